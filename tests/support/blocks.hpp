// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>

#include "mesh/build_version.hpp"
#include "mesh/quality.hpp"

namespace tedit::test {

/// nx x ny x nz unit cubes of six tets each; those for which `keep` is false are left out.
/// Surfaces: 1 to 6 for the sides x=0, x=nx, y=0, y=ny, z=0, z=nz; 7 for walls inside. `place`
/// moves the vertices when given.
inline version_ptr blocks(std::array<int, 3> n, const std::function<bool(int, int, int)>& keep,
                          const std::function<vec3(vec3)>& place = {}) {
  raw_mesh raw;
  const auto index = [&](int x, int y, int z) {
    return static_cast<vertex_id>((z * (n[1] + 1) + y) * (n[0] + 1) + x);
  };
  for (int z = 0; z <= n[2]; ++z)
    for (int y = 0; y <= n[1]; ++y)
      for (int x = 0; x <= n[0]; ++x)
        raw.positions.push_back({1.0 * x, 1.0 * y, 1.0 * z});
  // Kuhn's subdivision: six tets around the diagonal.
  constexpr std::array<std::array<int, 3>, 6> paths{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (int z = 0; z < n[2]; ++z)
    for (int y = 0; y < n[1]; ++y)
      for (int x = 0; x < n[0]; ++x) {
        if (!keep(x, y, z))
          continue;
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
      }
  // Name the faces: build once without surfaces, then by position.
  const auto bare = build_version(raw, 1)->version;
  for (facet_id f = 0; f < bare->facet_slots(); ++f) {
    const auto& v = bare->facet(f).v;
    const auto all = [&](double vec3::*c, double value) {
      return std::ranges::all_of(v, [&](vertex_id i) { return bare->position(i).*c == value; });
    };
    surface_id id = 7;
    if (all(&vec3::x, 0))
      id = 1;
    else if (all(&vec3::x, n[0]))
      id = 2;
    else if (all(&vec3::y, 0))
      id = 3;
    else if (all(&vec3::y, n[1]))
      id = 4;
    else if (all(&vec3::z, 0))
      id = 5;
    else if (all(&vec3::z, n[2]))
      id = 6;
    raw_mesh::triangle triangle;
    for (int i = 0; i < 3; ++i) {
      const auto& p = bare->position(v[i]);
      triangle.v[i] = index(static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z));
    }
    triangle.surface = id;
    raw.triangles.push_back(triangle);
  }
  if (place)
    for (auto& p : raw.positions)
      p = place(p);
  return build_version(std::move(raw), 1)->version;
}

inline version_ptr blocks(int n, const std::function<bool(int, int, int)>& keep) {
  return blocks({n, n, n}, keep);
}

}  // namespace tedit::test
