// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/conformance/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "mesh/build_version.hpp"
#include "mesh/builder.hpp"
#include "mesh/quality.hpp"

namespace tedit::ops {

namespace {

using cell = std::array<int, 3>;

constexpr double cell_size = 0.01;  // m

/// A body of cubes.
struct body {
  cell cells;
  std::function<bool(cell)> keep;
  std::function<surface_id(vec3 middle, vec3 normal)> surface_of;  ///< In cells.
  std::function<region_id(cell)> region_of;
};

vertex_id corner_index(const body& b, cell at) {
  return static_cast<vertex_id>((at[2] * (b.cells[1] + 1) + at[1]) * (b.cells[0] + 1) + at[0]);
}

/// Kuhn's subdivision: six tets around the diagonal of a cube.
void add_cube(const body& b, cell c, raw_mesh& raw) {
  constexpr std::array<cell, 6> paths{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (const auto& path : paths) {
    cell at = c;
    tet t;
    t.v[0] = corner_index(b, at);
    for (int step = 0; step < 3; ++step) {
      ++at[path[step]];
      t.v[step + 1] = corner_index(b, at);
    }
    const auto& p = raw.positions;
    if (signed_volume(p[t.v[0]], p[t.v[1]], p[t.v[2]], p[t.v[3]]) < 0)
      std::swap(t.v[2], t.v[3]);
    raw.tets.push_back(t);
    raw.tet_regions.push_back(b.region_of ? b.region_of(c) : 1);
  }
}

/// The triangle of three points of the grid, named by where it lies.
raw_mesh::triangle named(const body& b, const std::array<vec3, 3>& p) {
  raw_mesh::triangle result;
  for (int i = 0; i < 3; ++i)
    result.v[i] =
      corner_index(b, {static_cast<int>(std::lround(p[i].x)), static_cast<int>(std::lround(p[i].y)),
                       static_cast<int>(std::lround(p[i].z))});
  result.surface =
    b.surface_of((1.0 / 3) * (p[0] + p[1] + p[2]), normalized(area_vector(p[0], p[1], p[2])));
  return result;
}

/// Built twice: the first time to learn the boundary, the second time with its names.
version_ptr build(const body& b, surface_id interface_id) {
  raw_mesh raw;
  for (int z = 0; z <= b.cells[2]; ++z)
    for (int y = 0; y <= b.cells[1]; ++y)
      for (int x = 0; x <= b.cells[0]; ++x)
        raw.positions.push_back({1.0 * x, 1.0 * y, 1.0 * z});
  for (int z = 0; z < b.cells[2]; ++z)
    for (int y = 0; y < b.cells[1]; ++y)
      for (int x = 0; x < b.cells[0]; ++x)
        if (b.keep({x, y, z}))
          add_cube(b, {x, y, z}, raw);
  const auto bare = build_version(raw, 1)->version;
  const auto points = [&](const std::array<vertex_id, 3>& v) {
    return std::array{bare->position(v[0]), bare->position(v[1]), bare->position(v[2])};
  };
  for (facet_id f = 0; f < bare->facet_slots(); ++f)
    raw.triangles.push_back(named(b, points(bare->facet(f).v)));
  for (tet_id t = 0; t < bare->tet_slots(); ++t)
    for (int i = 0; i < 4; ++i) {
      const auto behind = bare->neighbours(t)[i];
      if (is_facet(behind) || behind < t || bare->region_of(behind) == bare->region_of(t))
        continue;
      const auto& v = bare->tet_at(t).v;
      auto triangle =
        named(b, points({v[tet_faces[i][0]], v[tet_faces[i][1]], v[tet_faces[i][2]]}));
      triangle.surface = interface_id;
      raw.triangles.push_back(triangle);
    }
  return build_version(std::move(raw), cell_size)->version;
}

surface_id side_of_box(vec3, vec3 normal) {
  const std::array<double, 3> n{normal.x, normal.y, normal.z};
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(n[axis]) > 0.5)
      return 2 * axis + (n[axis] > 0 ? 2 : 1);
  return 0;
}

bool in_drilled_block(cell c) {
  if (c[2] == 3)
    return c[0] == 4 && c[1] == 3;  // the boss
  const bool through = c[0] == 1 && c[1] == 1;
  const bool blind = c[0] == 3 && c[1] == 1 && c[2] >= 1;
  return !through && !blind;
}

surface_id surface_of_drilled_block(vec3 middle, vec3) {
  const auto on = [](double value, double at) { return std::abs(value - at) < 1e-9; };
  if (middle.z > 3 + 1e-9)
    return 21;
  if (on(middle.x, 0))
    return 2;
  if (on(middle.x, 6))
    return 7;
  if (on(middle.y, 0))
    return -3;
  if (on(middle.y, 5))
    return 40;
  if (on(middle.z, 0))
    return 1000000;
  if (on(middle.z, 3))
    return 5;
  if (on(middle.z, 1))
    return 13;
  return middle.x < 2.5 ? 11 : 12;
}

/// Cuts the boss off: its tets, vertices and most of its facets leave free slots.
version_ptr without_boss(const version_ptr& mesh) {
  cavity_change change;
  const auto goes = [&](tet_id t) {
    const auto c = mesh->corners(t);
    return 0.25 * (c[0].z + c[1].z + c[2].z + c[3].z) > 3 * cell_size;
  };
  for (tet_id t = 0; t < mesh->tet_slots(); ++t) {
    if (!goes(t))
      continue;
    change.removed.push_back(t);
    const auto& v = mesh->tet_at(t).v;
    for (int i = 0; i < 4; ++i) {
      const auto behind = mesh->neighbours(t)[i];
      if (!is_facet(behind) && !goes(behind))
        change.facets.push_back({{v[tet_faces[i][0]], v[tet_faces[i][1]], v[tet_faces[i][2]]}, 5});
    }
  }
  mesh_builder builder(mesh);
  (void)builder.apply(change);
  return builder.freeze();
}

}  // namespace

std::vector<sample> kit_samples() {
  constexpr surface_id no_interface = 0;
  const body box{{4, 3, 3}, [](cell) { return true; }, side_of_box, {}};
  body drilled{{6, 5, 4}, in_drilled_block, surface_of_drilled_block, {}};
  std::vector<sample> result{{"the box", build(box, no_interface)},
                             {"the drilled block", build(drilled, no_interface)}};
  drilled.region_of = [](cell c) -> region_id { return c[0] < 3 ? 4 : 90; };
  result.push_back({"the block of two regions", build(drilled, 77)});
  result.push_back({"the edited block", without_boss(result[1].mesh)});
  return result;
}

}  // namespace tedit::ops
