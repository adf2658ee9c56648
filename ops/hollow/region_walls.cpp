// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/hollow/region_walls.hpp"

#include <algorithm>

#include "mesh/checks.hpp"

namespace tedit::ops {

namespace {

void add(region_walls& walls, const mesh_version& mesh, const std::array<vertex_id, 3>& corners,
         std::optional<surface_id> surface) {
  walls.triangles.push_back(corners);
  walls.surfaces.push_back(surface);
  for (const auto v : corners)
    walls.extent.add(mesh.position(v));
  walls.area += norm(
    area_vector(mesh.position(corners[0]), mesh.position(corners[1]), mesh.position(corners[2])));
}

std::string names_of(const mesh_version& mesh) {
  std::string all;
  for (const auto& one : mesh.regions())
    all += (all.empty() ? "" : ", ") + std::to_string(one.id) +
           (one.name.empty() ? "" : " (" + one.name + ")");
  return all;
}

std::optional<region_id> named(const mesh_version& mesh, const std::string& text) {
  for (const auto& one : mesh.regions())
    if (one.name == text)
      return one.id;
  for (const auto& one : mesh.regions())
    if (std::to_string(one.id) == text)
      return one.id;
  return std::nullopt;
}

/// The regions that have some of a surface, ascending.
std::vector<region_id> regions_at(const mesh_version& mesh, surface_id surface) {
  std::set<region_id> found;
  for (const auto f : facets_of(mesh, std::array{surface}))
    found.insert(mesh.region_of(mesh.facet(f).tet));
  return {found.begin(), found.end()};
}

}  // namespace

region_walls walls_of(const mesh_version& mesh, std::optional<region_id> region) {
  region_walls walls;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f) && (!region || mesh.region_of(mesh.facet(f).tet) == *region))
      add(walls, mesh, mesh.facet(f).v, mesh.facet(f).surface);
  if (!region)
    return walls;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    if (!mesh.is_live_tet(t) || mesh.region_of(t) != *region)
      continue;
    const auto& next = mesh.neighbours(t);
    const auto& v = mesh.tet_at(t).v;
    for (int k = 0; k < 4; ++k)
      if (!is_facet(next[k]) && mesh.region_of(next[k]) != *region) {
        const auto& face = tet_faces[k];
        add(walls, mesh, {v[face[0]], v[face[1]], v[face[2]]}, std::nullopt);
      }
  }
  return walls;
}

expected<std::optional<region_id>> region_meant(const mesh_version& mesh, const std::string& text,
                                                const std::vector<surface_id>& picked) {
  std::optional<region_id> meant;
  if (!text.empty()) {
    meant = named(mesh, text);
    if (!meant)
      return fail(ec::invalid_parameter, "the part has no region \"" + text + "\"",
                  "It has " + names_of(mesh));
  }
  if (mesh.regions().size() < 2)
    return std::nullopt;
  for (const auto wall : picked) {
    const auto there = regions_at(mesh, wall);
    if (meant ? std::ranges::find(there, *meant) == there.end() : there.size() != 1)
      return fail(ec::invalid_parameter,
                  "surface " + std::to_string(wall) + " is no wall of one region that is meant",
                  "Pick walls of one region, or name it: region=NAME");
    meant = meant.value_or(there.front());
  }
  if (!meant)
    return fail(ec::invalid_parameter,
                "the part has " + std::to_string(mesh.regions().size()) +
                  " regions, and which is to be hollow is not said",
                "Name one: region=NAME; it has " + names_of(mesh));
  return meant;
}

}  // namespace tedit::ops
