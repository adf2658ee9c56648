// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/mesh_report.hpp"

#include <algorithm>
#include <map>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "mesh/features/known_wall.hpp"

namespace tedit::cli {

namespace {

/// Of few corners a sphere or a torus is told by the CAD model alone: many shapes go through them.
std::optional<exact_wall> shape_of(const mesh_version& mesh, const std::vector<facet_id>& facets) {
  if (const auto simple = fit_wall(mesh, facets, {.cones = true}))
    return exact_wall{*simple};
  auto round = find_exact(mesh, facets);
  return round && (round->sphere_radius > 0 || round->tube_radius > 0) ? round : std::nullopt;
}

void add_surfaces(const mesh_version& mesh, mesh_report& report) {
  std::map<surface_id, mesh_report::surface_row> rows;
  std::map<surface_id, std::vector<facet_id>> facets;
  for (const auto& row : mesh.surfaces())
    rows[row.id] = {row.id, row.name, 0, 0, 0, {}};
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    auto& row = rows[mesh.facet(f).surface];
    ++row.facets;
    facets[mesh.facet(f).surface].push_back(f);
    row.area_m2 += norm(area_vector(mesh, mesh.facet(f)));
  }
  const auto& interfaces = mesh.data().interfaces;
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    auto& row = rows[interfaces[i].surface];
    const auto& v = interfaces[i].v;
    ++row.interface_facets;
    row.area_m2 += norm(area_vector(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])));
  }
  for (const auto& [id, mine] : facets)
    rows[id].shape = shape_of(mesh, mine);
  for (auto& [id, row] : rows)
    report.surfaces.push_back(std::move(row));
}

const char* kind_words(const exact_wall& wall) {
  if (wall.sphere_radius > 0)
    return "sphere";
  if (wall.tube_radius > 0)
    return "torus";
  return wall.flat() ? "plane" : wall.shape.type == wall_shape::kind::cone ? "cone" : "cylinder";
}

/// The shape as JSON has it; see `shape_words` for people.
void add_shape(const mesh_report::surface_row& row, nlohmann::ordered_json& item) {
  if (row.facets == 0)
    return;
  if (!row.shape) {
    item["shape"] = "free_form";
    return;
  }
  const auto& wall = *row.shape;
  item["shape"] = kind_words(wall);
  if (wall.flat())
    return;
  item["hollow"] = wall.shape.side < 0;
  if (wall.sphere_radius > 0)
    item["diameter_m"] = 2 * wall.sphere_radius;
  else if (wall.tube_radius > 0)
    item["tube_radius_m"] = wall.tube_radius;
  else if (wall.shape.type == wall_shape::kind::cylinder)
    item["diameter_m"] = 2 * wall.shape.radius;
}

void add_regions(const mesh_version& mesh, mesh_report& report) {
  std::map<region_id, mesh_report::region_row> rows;
  for (const auto& row : mesh.regions())
    rows[row.id] = {row.id, row.name, 0, 0};
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    if (!mesh.is_live_tet(t))
      continue;
    const double volume = signed_volume(mesh.corners(t));
    auto& row = rows[mesh.region_of(t)];
    ++row.tets;
    row.volume_m3 += volume;
    report.volume_m3 += volume;
  }
  for (auto& [id, row] : rows)
    report.regions.push_back(std::move(row));
}

vec3 bounding_size(const mesh_version& mesh) {
  vec3 low{1e300, 1e300, 1e300};
  vec3 high = -low;
  for (vertex_id v = 0; v < mesh.vertex_slots(); ++v) {
    if (!mesh.is_live_vertex(v))
      continue;
    const auto& p = mesh.position(v);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return mesh.vertex_count() > 0 ? high - low : vec3{};
}

}  // namespace

mesh_report make_mesh_report(const mesh_version& mesh) {
  mesh_report report;
  add_surfaces(mesh, report);
  add_regions(mesh, report);
  report.size_m = bounding_size(mesh);
  report.quality = radius_ratios(mesh);
  return report;
}

std::string shape_words(const mesh_report::surface_row& row) {
  if (row.facets == 0)
    return row.interface_facets > 0 ? "interface" : "nothing";
  if (!row.shape)
    return "free form";
  const auto& wall = *row.shape;
  const bool hollow = !wall.flat() && wall.shape.side < 0;
  if (wall.shape.type == wall_shape::kind::cylinder)
    return (hollow ? "bore, diameter " : "round, diameter ") + pretty(2e3 * wall.shape.radius) +
           " mm";
  auto words = (hollow ? "hollow " : "") + std::string(kind_words(wall));
  if (wall.sphere_radius > 0)
    words += ", diameter " + pretty(2e3 * wall.sphere_radius) + " mm";
  if (wall.tube_radius > 0)
    words += ", tube radius " + pretty(1e3 * wall.tube_radius) + " mm";
  return words;
}

nlohmann::ordered_json to_json(const mesh_version& mesh, const mesh_report& report) {
  using json = nlohmann::ordered_json;
  json surfaces = json::array();
  for (const auto& row : report.surfaces) {
    json item{{"id", row.id}, {"name", row.name}, {"facets", row.facets}, {"area_m2", row.area_m2}};
    if (row.interface_facets > 0)
      item["interface_facets"] = row.interface_facets;
    add_shape(row, item);
    surfaces.push_back(std::move(item));
  }
  json regions = json::array();
  for (const auto& row : report.regions)
    regions.push_back(
      {{"id", row.id}, {"name", row.name}, {"tets", row.tets}, {"volume_m3", row.volume_m3}});
  return {{"version_id", to_hex(mesh.id())},
          {"tets", mesh.tet_count()},
          {"vertices", mesh.vertex_count()},
          {"boundary_facets", mesh.facet_count()},
          {"interface_facets", mesh.data().interfaces.size()},
          {"surfaces", std::move(surfaces)},
          {"regions", std::move(regions)},
          {"volume_m3", report.volume_m3},
          {"size_m", {report.size_m.x, report.size_m.y, report.size_m.z}},
          {"radius_ratio",
           {{"min", report.quality.min},
            {"median", report.quality.median},
            {"max", report.quality.max}}}};
}

}  // namespace tedit::cli
