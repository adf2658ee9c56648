// SPDX-License-Identifier: AGPL-3.0-or-later
// Meshes of versions: the head's is always there, those used lately are at hand, as far as there is
// room, and the others come from the document (docs/decisions/0037).
#include "actors/errors.hpp"
#include "actors/session/session.hpp"

namespace tedit::actors {

namespace {

std::uint64_t bytes_of(const mesh_version& mesh) {
  std::uint64_t bytes = 0;
  mesh.for_each_page([&](const page_ptr& p) { bytes += p->bytes().size(); });
  return bytes;
}

}  // namespace

void session_state::begin_meshes() {
  if (const auto* head = graph.head())
    nearby[head->info.number].bytes = bytes_of(*head->mesh);
}

void session_state::leave_head() {
  const auto* head = graph.head();
  if (!head)
    return;
  auto& place = nearby[head->info.number];
  place.kept = parts.versions->keep(head->mesh, place.bytes);
}

version_ptr session_state::mesh_at_hand(std::uint32_t number) {
  if (const auto& there = graph.nodes()[number].mesh)
    return there;
  const auto place = nearby.find(number);
  return place != nearby.end() && place->second.kept ? parts.versions->find(place->second.kept)
                                                     : nullptr;
}

void session_state::with_mesh(std::uint32_t number,
                              const std::function<void(const version_ptr&)>& use,
                              const std::function<void(const error&)>& refuse) {
  if (const auto there = mesh_at_hand(number))
    return use(there);
  ++loading;
  self
    ->request(parts.store, answer_limit, load_atom::value,
              version_query{number, graph.nodes()[number].info.id, parts.cache})
    .then(
      [=, this](const stored_version& found) {
        --loading;
        parts.cache->put(*found.mesh);
        // It may have become the head, or have come by another request, meanwhile.
        if (!mesh_at_hand(number))
          nearby[number] = {parts.versions->keep(found.mesh, found.read_bytes), found.read_bytes};
        use(found.mesh);
      },
      [=, this](const caf::error& e) {
        --loading;
        refuse(from_caf(e, "reading version " + std::to_string(number)));
      });
}

}  // namespace tedit::actors
