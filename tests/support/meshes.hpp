// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "mesh/build_version.hpp"
#include "mesh/quality.hpp"

namespace tedit::test {

/// A box [0,x] x [0,y] x [0,z] of nx x ny x nz cells with six tets each. Surfaces 1 to 6: x=0,
/// x=max, y=0, y=max, z=0, z=max. `place` moves the grid points when given.
inline version_ptr box_mesh(std::array<int, 3> cells, vec3 size,
                            const std::function<vec3(vec3)>& place = {}) {
  raw_mesh raw;
  const auto [nx, ny, nz] = cells;
  const auto index = [&](int x, int y, int z) {
    return static_cast<vertex_id>((z * (ny + 1) + y) * (nx + 1) + x);
  };
  for (int z = 0; z <= nz; ++z)
    for (int y = 0; y <= ny; ++y)
      for (int x = 0; x <= nx; ++x)
        raw.positions.push_back({size.x * x / nx, size.y * y / ny, size.z * z / nz});
  constexpr std::array<std::array<int, 3>, 6> paths{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x)
        for (const auto& path : paths) {
          std::array<int, 3> at{x, y, z};
          tet t;
          t.v[0] = index(x, y, z);
          for (int step = 0; step < 3; ++step) {
            ++at[path[step]];
            t.v[step + 1] = index(at[0], at[1], at[2]);
          }
          const auto& p = raw.positions;
          if (signed_volume(p[t.v[0]], p[t.v[1]], p[t.v[2]], p[t.v[3]]) < 0)
            std::swap(t.v[2], t.v[3]);
          raw.tets.push_back(t);
          raw.tet_regions.push_back(1);
        }
  const auto add_side = [&](int axis, bool high, surface_id id) {
    const int last = high ? cells[axis] : 0;
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (int i = 0; i < cells[u]; ++i)
      for (int j = 0; j < cells[v]; ++j) {
        // Kuhn's tets cut every square along the diagonal from its lowest to its highest corner.
        const auto corner = [&](int a, int b) {
          std::array<int, 3> at{};
          at[axis] = last;
          at[u] = i + a;
          at[v] = j + b;
          return index(at[0], at[1], at[2]);
        };
        raw.triangles.push_back({{corner(0, 0), corner(1, 0), corner(1, 1)}, id, true});
        raw.triangles.push_back({{corner(0, 0), corner(1, 1), corner(0, 1)}, id, true});
      }
  };
  for (int axis = 0; axis < 3; ++axis) {
    add_side(axis, false, 2 * axis + 1);
    add_side(axis, true, 2 * axis + 2);
  }
  if (place)
    for (auto& p : raw.positions)
      p = place(p);
  return build_version(std::move(raw), 1)->version;
}

/// The unit cube with surfaces 1 to 6.
inline version_ptr unit_box() {
  return box_mesh({2, 2, 2}, {1, 1, 1});
}

inline std::vector<tet_id> all_tets(const mesh_version& mesh) {
  std::vector<tet_id> result;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t))
      result.push_back(t);
  return result;
}

}  // namespace tedit::test
