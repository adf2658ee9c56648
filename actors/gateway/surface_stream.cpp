// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/surface_stream.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "actors/gateway/client_actor.hpp"
#include "fem/fields.hpp"
#include "mesh/changes.hpp"
#include "mesh/facet_pages.hpp"
#include "protocol/load_case_message.hpp"
#include "protocol/report.hpp"

namespace tedit::gateway {

namespace {

/// The arrays of a SurfaceUpdate, as session.proto lists them.
struct surface_arrays {
  std::vector<std::uint32_t> removed;
  std::vector<vertex_id> vertices;
  std::vector<double> positions;
  std::vector<facet_id> facets;
  std::vector<std::uint32_t> facet_vertices;
  std::vector<std::int64_t> facet_surfaces;

  void add_facet(facet_id slot, const boundary_facet& f) {
    facets.push_back(slot);
    facet_vertices.insert(facet_vertices.end(), f.v.begin(), f.v.end());
    facet_surfaces.push_back(f.surface);
  }

  void add_positions(const mesh_version& mesh) {
    for (const auto v : vertices) {
      const auto p = mesh.position(v);
      positions.insert(positions.end(), {p.x, p.y, p.z});
    }
  }

  void write(bulk& target, v1::SurfaceUpdate* update) const {
    using info = v1::ArrayInfo;
    auto* stream = update->mutable_stream();
    bulk_builder builder;
    builder.add(stream, "removed_facets", info::UINT32, 1, removed);
    builder.add(stream, "vertices", info::UINT32, 1, vertices);
    builder.add(stream, "positions", info::FLOAT64, 3, positions);
    builder.add(stream, "facets", info::UINT32, 1, facets);
    builder.add(stream, "facet_vertices", info::UINT32, 3, facet_vertices);
    builder.add(stream, "facet_surfaces", info::INT64, 1, facet_surfaces);
    builder.finish(target);
    target.stream = stream;
  }
};

void describe(const mesh_version& mesh, surface_id id, const surface_size& size,
              v1::SurfaceInfo* out) {
  out->set_id(id);
  if (const auto* info = mesh.find_surface(id))
    out->set_name(info->name);
  out->set_facets(size.facets);
  out->set_area_m2(size.area_m2);
}

/// The arrays of a FieldUpdate, as session.proto lists them.
class field_arrays {
public:
  field_arrays(const mesh_version& mesh, const std::vector<field>& fields)
      : fields_(fields), vertices_(boundary_vertices(mesh)) {
    stream_ = update()->mutable_stream();
    builder_.add(stream_, "vertices", v1::ArrayInfo::UINT32, 1, vertices_);
  }

  [[nodiscard]] v1::FieldUpdate* update() { return result_.header.mutable_field_update(); }

  /// False when one is missing that is always sent; `name_of` gives its name. Of those on request
  /// one may be missing: no yield strength is known, or the result is of an older release.
  template <class Name>
  [[nodiscard]] bool add_case(const Name& name_of, const watched_quantities& watched) {
    bool complete = true;
    for (const auto& array : fem::result_arrays)
      if (is_wanted(array, watched) &&
          !add<float>(array.name, name_of(array.name), array.components))
        complete = complete && array.sent != fem::array_sent::always;
    return complete;
  }

  /// The same of the worst of several load cases, which all who watch get.
  [[nodiscard]] bool add_envelope() {
    bool complete = true;
    for (const auto& array : fem::result_arrays) {
      const auto& worst = array.envelope;
      if (!worst.values.empty() && !(add<float>(array.name, worst.values, array.components) &&
                                     add<std::uint32_t>(worst.sent_cases, worst.cases)))
        complete = complete && array.sent != fem::array_sent::always;
    }
    return complete;
  }

  [[nodiscard]] bulk finish() {
    builder_.finish(result_);
    result_.stream = stream_;
    return std::move(result_);
  }

private:
  template <class T>
  bool add(std::string_view name, std::string_view source, int components = 1) {
    const auto* found = find_field(fields_, source);
    if (!found)
      return false;
    std::vector<T> values;
    values.reserve(vertices_.size() * static_cast<std::size_t>(components));
    for (const auto v : vertices_)
      for (int c = 0; c < components; ++c)
        values.push_back(static_cast<T>(found->at(v, c)));
    constexpr auto type = std::is_same_v<T, float> ? v1::ArrayInfo::FLOAT32 : v1::ArrayInfo::UINT32;
    builder_.add(stream_, std::string(name), type, static_cast<unsigned>(components), values);
    return true;
  }

  const std::vector<field>& fields_;
  std::vector<vertex_id> vertices_;
  bulk result_;
  v1::Stream* stream_ = nullptr;  ///< Inside `result_`.
  bulk_builder builder_;
};

/// Fills `update` and its stream with the difference between two versions. `known`: vertices of
/// `before` whose positions the client has; returns those that it has besides when it has taken the
/// update.
std::vector<vertex_id> write_difference(const mesh_version& before, const mesh_version& mesh,
                                        const std::unordered_set<vertex_id>& known, bulk& result,
                                        v1::SurfaceUpdate* update) {
  update->set_version_id(to_hex(mesh.id()));
  update->set_base_version_id(to_hex(before.id()));
  surface_arrays arrays;
  std::set<surface_id> touched;
  std::set<vertex_id> moved;
  for_each_dirty_slot(before.data().facets, mesh.data().facets, [&](facet_id f) {
    const bool was = f < before.facet_slots() && before.is_live_facet(f);
    const bool is = f < mesh.facet_slots() && mesh.is_live_facet(f);
    const bool same = was && is && before.facet(f).v == mesh.facet(f).v &&
                      before.facet(f).surface == mesh.facet(f).surface;
    if (same || (!was && !is))
      return;
    if (was)
      touched.insert(before.facet(f).surface);
    if (!is)
      return arrays.removed.push_back(f);
    touched.insert(mesh.facet(f).surface);
    arrays.add_facet(f, mesh.facet(f));
    for (const auto v : mesh.facet(f).v)
      if (!known.contains(v))
        moved.insert(v);
  });
  // Known vertices that have moved, or whose slot holds another vertex now.
  const auto common = std::min(before.vertex_slots(), mesh.vertex_slots());
  bool surfaces_moved = false;
  for_each_dirty_slot(before.data().positions, mesh.data().positions, [&](vertex_id v) {
    if (v < common && known.contains(v) && mesh.is_live_vertex(v) &&
        !(before.position(v) == mesh.position(v))) {
      moved.insert(v);
      surfaces_moved = true;
    }
  });
  arrays.vertices.assign(moved.begin(), moved.end());
  arrays.add_positions(mesh);
  const auto sizes = surface_sizes(mesh);
  for (const auto& [id, size] : sizes)
    if (surfaces_moved || touched.contains(id))
      describe(mesh, id, size, update->add_surfaces());
  for (const auto id : touched)
    if (!sizes.contains(id))
      update->add_removed(id);
  arrays.write(result, update);
  return arrays.vertices;
}

/// Answers the vertices that were written.
std::vector<vertex_id> write_whole(const mesh_version& mesh, bulk& result,
                                   v1::SurfaceUpdate* update) {
  update->set_version_id(to_hex(mesh.id()));
  const auto sizes = surface_sizes(mesh);
  for (const auto& surface : mesh.surfaces())
    if (const auto found = sizes.find(surface.id); found != sizes.end())
      describe(mesh, surface.id, found->second, update->add_surfaces());
  surface_arrays arrays;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      arrays.add_facet(f, mesh.facet(f));
  arrays.vertices = boundary_vertices(mesh);
  arrays.add_positions(mesh);
  arrays.write(result, update);
  return arrays.vertices;
}

}  // namespace

std::optional<bulk> surface_stream::update_to(const std::string& document,
                                              const version_ptr& mesh) {
  const bool says_so = std::exchange(resumed_, false);
  if (held_ && held_->id() == mesh->id() && !says_so)
    return std::nullopt;
  if (!held_) {
    held_ = mesh;
    return whole(document, *mesh);
  }
  bulk result;
  auto* update = result.header.mutable_surface_update();
  update->set_document(document);
  const auto sent = write_difference(*held_, *mesh, vertices_, result, update);
  vertices_.insert(sent.begin(), sent.end());
  // A slot that is free now may hold another vertex the next time.
  std::erase_if(vertices_,
                [&](vertex_id v) { return v >= mesh->vertex_slots() || !mesh->is_live_vertex(v); });
  held_ = mesh;
  return result;
}

void surface_stream::resume(const version_ptr& held) {
  const auto boundary = boundary_vertices(*held);
  vertices_ = {boundary.begin(), boundary.end()};
  held_ = held;
  resumed_ = true;
}

bulk surface_stream::whole(const std::string& document, const mesh_version& mesh) {
  bulk result;
  auto* update = result.header.mutable_surface_update();
  update->set_document(document);
  const auto sent = write_whole(mesh, result, update);
  vertices_ = {sent.begin(), sent.end()};
  return result;
}

bulk surface_stream::of_version(const actors::session_version& version) {
  bulk result;
  auto* out = result.header.mutable_version_surface();
  out->set_document(version.document);
  out->set_number(version.number);
  out->mutable_surface()->set_document(version.document);
  write_whole(*version.mesh, result, out->mutable_surface());
  return result;
}

bulk surface_stream::preview(const actors::previewed& made) const {
  bulk result;
  auto* out = result.header.mutable_edit_preview();
  out->set_document(made.document);
  out->mutable_surface()->set_document(made.document);
  const bool holds = held_ && held_->id() == made.base->id();
  const auto boundary = holds ? std::vector<vertex_id>() : boundary_vertices(*made.base);
  write_difference(*made.base, *made.version,
                   holds ? vertices_ : std::unordered_set(boundary.begin(), boundary.end()), result,
                   out->mutable_surface());
  protocol::to_message(*made.report, out->mutable_report());
  out->set_draft(made.draft);
  if (!made.draft) {
    out->set_tets(made.version->tet_count());
    out->set_vertices(made.version->vertex_count());
  }
  out->set_boundary_facets(made.version->facet_count());
  protocol::to_messages(*made.load_cases, out->mutable_load_cases());
  return result;
}

std::optional<bulk> surface_stream::fields_of(const actors::solved& event, unsigned index,
                                              const watched_quantities& watched) {
  const auto& reports = event.outcome->cases;
  const auto& envelope = event.outcome->envelope;
  const auto cases = static_cast<unsigned>(reports.size());
  const unsigned updates = envelope ? cases + 1 : 1;
  if (index >= updates)
    return std::nullopt;
  field_arrays arrays(*event.version, *event.fields);
  auto* update = arrays.update();
  bool complete = false;
  if (index < cases) {
    const auto& report = reports[index];
    protocol::to_message(report, update->mutable_report());
    complete = arrays.add_case(
      [&](std::string_view name) {
        return envelope ? fem::case_field(name, report.load_case) : std::string(name);
      },
      watched);
  } else {
    protocol::to_message(*envelope, update->mutable_envelope());
    complete = arrays.add_envelope();
  }
  if (!complete)
    return std::nullopt;
  update->set_document(event.document);
  update->set_solve(event.number);
  update->set_remaining(updates - 1 - index);
  return arrays.finish();
}

}  // namespace tedit::gateway
