// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/surface_stream.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "protocol/json.hpp"

namespace tedit::gateway {

namespace {

// Rows of `manifest::arrays`.
constexpr std::size_t positions_row = 0;
constexpr std::size_t facets_row = 5;

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

struct surface_size {
  std::uint64_t facets = 0;
  double area = 0;
};

std::map<surface_id, surface_size> sizes_of(const mesh_version& mesh) {
  std::map<surface_id, surface_size> sizes;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f)) {
      auto& row = sizes[mesh.facet(f).surface];
      ++row.facets;
      row.area += norm(area_vector(mesh, mesh.facet(f)));
    }
  return sizes;
}

void describe(const mesh_version& mesh, surface_id id, const surface_size& size,
              v1::SurfaceInfo* out) {
  out->set_id(id);
  if (const auto* info = mesh.find_surface(id))
    out->set_name(info->name);
  out->set_facets(size.facets);
  out->set_area_m2(size.area);
}

std::vector<vertex_id> boundary_vertices(const mesh_version& mesh) {
  std::vector<vertex_id> vertices;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      vertices.insert(vertices.end(), mesh.facet(f).v.begin(), mesh.facet(f).v.end());
  std::ranges::sort(vertices);
  const auto rest = std::ranges::unique(vertices);
  vertices.erase(rest.begin(), rest.end());
  return vertices;
}

/// Calls `visit(slot)` for every slot of one array in pages that differ between two versions.
template <class T, class Visit>
void for_each_dirty_slot(const mesh_version& before, const mesh_version& after, std::size_t row,
                         std::size_t slots, const Visit& visit) {
  const std::size_t per_page = paged_array<T>::items_per_page;
  for (const auto p : dirty_pages(before.pages().arrays.at(row), after.pages().arrays.at(row)))
    for (std::size_t s = p * per_page; s < std::min((p + 1) * per_page, slots); ++s)
      visit(static_cast<std::uint32_t>(s));
}

}  // namespace

std::optional<bulk> surface_stream::update_to(const std::string& document,
                                              const version_ptr& mesh) {
  if (held_ && held_->id() == mesh->id())
    return std::nullopt;
  auto result = held_ ? difference(document, *mesh) : whole(document, *mesh);
  held_ = mesh;
  return result;
}

bulk surface_stream::whole(const std::string& document, const mesh_version& mesh) {
  bulk result;
  auto* update = result.header.mutable_surface_update();
  update->set_document(document);
  update->set_version_id(to_hex(mesh.id()));
  const auto sizes = sizes_of(mesh);
  for (const auto& surface : mesh.surfaces())
    if (const auto found = sizes.find(surface.id); found != sizes.end())
      describe(mesh, surface.id, found->second, update->add_surfaces());
  surface_arrays arrays;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      arrays.add_facet(f, mesh.facet(f));
  arrays.vertices = boundary_vertices(mesh);
  arrays.add_positions(mesh);
  vertices_ = {arrays.vertices.begin(), arrays.vertices.end()};
  arrays.write(result, update);
  return result;
}

bulk surface_stream::difference(const std::string& document, const mesh_version& mesh) {
  const auto& before = *held_;
  bulk result;
  auto* update = result.header.mutable_surface_update();
  update->set_document(document);
  update->set_version_id(to_hex(mesh.id()));
  update->set_base_version_id(to_hex(before.id()));
  surface_arrays arrays;
  std::set<surface_id> touched;
  std::set<vertex_id> moved;
  const auto slots = std::max(before.facet_slots(), mesh.facet_slots());
  for_each_dirty_slot<boundary_facet>(before, mesh, facets_row, slots, [&](facet_id f) {
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
      if (!vertices_.contains(v))
        moved.insert(v);
  });
  // Known vertices that have moved, or whose slot holds another vertex now.
  const auto common = std::min(before.vertex_slots(), mesh.vertex_slots());
  bool surfaces_moved = false;
  for_each_dirty_slot<vec3>(before, mesh, positions_row, common, [&](vertex_id v) {
    if (vertices_.contains(v) && mesh.is_live_vertex(v) &&
        !(before.position(v) == mesh.position(v))) {
      moved.insert(v);
      surfaces_moved = true;
    }
  });
  arrays.vertices.assign(moved.begin(), moved.end());
  arrays.add_positions(mesh);
  vertices_.insert(moved.begin(), moved.end());
  const auto sizes = sizes_of(mesh);
  for (const auto& [id, size] : sizes)
    if (surfaces_moved || touched.contains(id))
      describe(mesh, id, size, update->add_surfaces());
  for (const auto id : touched)
    if (!sizes.contains(id))
      update->add_removed(id);
  arrays.write(result, update);
  return result;
}

std::optional<bulk> surface_stream::fields_of(const std::string& document, const mesh_version& mesh,
                                              const std::vector<field>& fields,
                                              const std::string& report) {
  const auto* displacement = find_field(fields, "displacement_m");
  const auto* von_mises = find_field(fields, "von_mises_pa");
  auto parsed = protocol::message_from_json<v1::SolveReport>(report);
  if (!displacement || !von_mises || !parsed)
    return std::nullopt;
  bulk result;
  auto* update = result.header.mutable_field_update();
  update->set_document(document);
  *update->mutable_report() = std::move(*parsed);
  const auto vertices = boundary_vertices(mesh);
  std::vector<float> moved;
  std::vector<float> stress;
  for (const auto v : vertices) {
    for (int c = 0; c < 3; ++c)
      moved.push_back(static_cast<float>(displacement->at(v, c)));
    stress.push_back(static_cast<float>(von_mises->at(v)));
  }
  using info = v1::ArrayInfo;
  auto* stream = update->mutable_stream();
  bulk_builder builder;
  builder.add(stream, "vertices", info::UINT32, 1, vertices);
  builder.add(stream, "displacement_m", info::FLOAT32, 3, moved);
  builder.add(stream, "von_mises_pa", info::FLOAT32, 1, stress);
  builder.finish(result);
  result.stream = stream;
  return result;
}

}  // namespace tedit::gateway
