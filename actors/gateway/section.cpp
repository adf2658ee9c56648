// SPDX-License-Identifier: AGPL-3.0-or-later
#include <caf/send.hpp>

#include "actors/errors.hpp"
#include "actors/gateway/client_actor.hpp"
#include "fem/fields.hpp"
#include "mesh/section.hpp"
#include "protocol/vector_message.hpp"

namespace tedit::gateway {

namespace {

/// Adds a field at the section's points; nothing when it is not among the fields.
void add_field(const plane_section& cut, const std::vector<field>& fields, const std::string& name,
               const std::string& array, bulk_builder& builder, v1::Stream* stream) {
  const auto* found = find_field(fields, name);
  if (!found)
    return;
  std::vector<float> values;
  values.reserve(cut.points.size() * static_cast<std::size_t>(found->components));
  for (const auto& p : cut.points)
    for (int c = 0; c < found->components; ++c)
      values.push_back(static_cast<float>((1 - p.t) * found->at(p.a, c) + p.t * found->at(p.b, c)));
  builder.add(stream, array, v1::ArrayInfo::FLOAT32, static_cast<unsigned>(found->components),
              values);
}

/// A field that a section gets: its name among those of the solve, and its array's.
struct wanted_field {
  std::string name;
  std::string array;
};

/// What a section shows of a load case, or of the envelope. Errors: `not_found`.
expected<std::vector<wanted_field>> fields_for(const actors::solved& event,
                                               const std::string& load_case,
                                               const watched_quantities& watched) {
  const auto& reports = event.outcome->cases;
  const bool several = event.outcome->envelope.has_value();
  const bool of_all = several && load_case.empty();
  if (several && !of_all && !std::ranges::count(reports, load_case, &solve_report::load_case))
    return fail(ec::not_found,
                "load case \"" + load_case + "\" is not among those that were solved");
  std::vector<wanted_field> result;
  for (const auto& array : fem::result_arrays) {
    const std::string name(array.name);
    if (!is_wanted(array, watched) || (of_all && array.envelope.values.empty()))
      continue;
    result.push_back({of_all    ? std::string(array.envelope.values)
                      : several ? fem::case_field(name, load_case)
                                : name,
                      name});
  }
  return result;
}

}  // namespace

expected<bulk> make_section(const mesh_version& mesh, const actors::solved* fields,
                            const watched_quantities& watched, const v1::CutSection& request) {
  const auto cut = cut_by_plane(mesh, protocol::read_vector(request.point_m()),
                                protocol::read_vector(request.normal()), {});
  if (!cut)
    return fail(cut.error());
  bulk result;
  auto* ready = result.header.mutable_section_ready();
  ready->set_document(request.document());
  ready->set_version_id(to_hex(mesh.id()));
  result.stream = ready->mutable_stream();
  bulk_builder builder;
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < cut->points.size(); ++i) {
    const vec3 p = cut->position(mesh, i);
    for (const double x : {p.x, p.y, p.z})
      positions.push_back(static_cast<float>(x));
  }
  for (const auto& corners : cut->triangles)
    triangles.insert(triangles.end(), corners.begin(), corners.end());
  builder.add(result.stream, "positions", v1::ArrayInfo::FLOAT32, 3, positions);
  builder.add(result.stream, "triangles", v1::ArrayInfo::UINT32, 3, triangles);
  if (fields) {
    const auto wanted = fields_for(*fields, request.load_case(), watched);
    if (!wanted)
      return fail(wanted.error());
    for (const auto& one : *wanted)
      add_field(*cut, *fields->fields, one.name, one.array, builder, result.stream);
  }
  builder.finish(result);
  return result;
}

namespace {

/// On a thread of its own: a million tets take a tenth of a second.
void begin_section(client_state& client, client_state::open_document& document,
                   const client_state::section_request& request) {
  document.cutting = true;
  const bool fits = document.last_solved && document.last_solved->version &&
                    document.last_solved->version->id() == document.head->id();
  // The request is an argument: CAF 0.17 dereferences a null pointer when there is none.
  client.self->spawn<caf::detached>(
    [mesh = document.head, watched = document.watched,
     fields = fits ? document.last_solved : std::optional<actors::solved>(),
     home = caf::actor_cast<caf::actor>(client.self)](caf::event_based_actor*,
                                                      const client_state::section_request& wanted) {
      auto made = std::make_shared<const expected<bulk>>(
        make_section(*mesh, fields ? &*fields : nullptr, watched, wanted.body));
      caf::anon_send(home, section_cut{wanted.id, wanted.body.document(), std::move(made)});
    },
    request);
}

/// While a plane is dragged many are asked for: one is made at a time, and of those that wait only
/// the newest.
void section(client_state& client, std::uint64_t id, const v1::CutSection& body) {
  auto* document = client.find(id, body.document());
  if (!document)
    return;
  if (!document->head)
    return client.refuse(id,
                         {ec::conflict, "the document has no mesh yet", "Import one first", {}});
  client.begin(id, {});
  if (!document->cutting)
    return begin_section(client, *document, {id, body});
  if (document->next_section)
    client.refuse(document->next_section->id,
                  {ec::superseded, "another section was asked for meanwhile", {}, {}});
  document->next_section = {id, body};
}

/// The next one is begun when this one's turn to be sent has come: who takes long gets fewer.
void on_section(client_state& client, const section_cut& cut) {
  const auto go_on = [&client, document = cut.document] {
    const auto found = client.look_up(document);
    if (found == client.documents.end())
      return;
    found->second.cutting = false;
    if (const auto next = std::exchange(found->second.next_section, std::nullopt))
      begin_section(client, found->second, *next);
  };
  if (!*cut.result) {
    client.refuse(cut.id, cut.result->error());
    return go_on();
  }
  client.bulk_out->add([=, &client]() -> std::optional<bulk> {
    client.end(cut.id);
    go_on();
    bulk result = **cut.result;
    result.header.set_request_id(cut.id);
    result.stream = result.header.mutable_section_ready()->mutable_stream();
    return result;
  });
  client.bulk_out->pump();
}

}  // namespace

request_rows section_requests() {
  return {row_of<&v1::ClientMessage::cut_section, section>(v1::ClientMessage::kCutSection)};
}

caf::message_handler section_events(client_state& client) {
  return {[&client](const section_cut& cut) { on_section(client, cut); }};
}

}  // namespace tedit::gateway
