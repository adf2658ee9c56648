// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "mesh/build_version.hpp"
#include "mesh/quality.hpp"

namespace tedit::test {

/// A tube around z, in m: n sides, each a cell wide. Its volume is n/2 sin(2 pi/n) (R^2 - r^2) L.
struct tube {
  int sides = 16;
  int rings = 3;
  int layers = 3;
  double inner = 1;
  double outer = 2;
  double length = 1;
  double slope = 0;        ///< By how much both radii grow along z.
  surface_id surface = 1;  ///< The inner wall; then the outer one, z = 0, z = length.

  [[nodiscard]] double radius(int ring, double z) const {
    return inner + (outer - inner) * ring / rings + slope * z;
  }
};

/// Adds a tube's cells of six tets each to a mesh.
inline void add_tube(raw_mesh& raw, const tube& shape) {
  const auto first = raw.positions.size();
  const auto index = [&](int ring, int side, int layer) {
    return static_cast<vertex_id>(first) +
           static_cast<vertex_id>((layer * (shape.rings + 1) + ring) * shape.sides +
                                  side % shape.sides);
  };
  for (int layer = 0; layer <= shape.layers; ++layer)
    for (int ring = 0; ring <= shape.rings; ++ring)
      for (int side = 0; side < shape.sides; ++side) {
        const double z = shape.length * layer / shape.layers;
        const double angle = 2 * std::numbers::pi * side / shape.sides;
        const double r = shape.radius(ring, z);
        raw.positions.push_back({r * std::cos(angle), r * std::sin(angle), z});
      }
  constexpr std::array<std::array<int, 3>, 6> paths{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (int layer = 0; layer < shape.layers; ++layer)
    for (int ring = 0; ring < shape.rings; ++ring)
      for (int side = 0; side < shape.sides; ++side)
        for (const auto& path : paths) {
          std::array<int, 3> at{ring, side, layer};
          tet t;
          t.v[0] = index(at[0], at[1], at[2]);
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
  const auto square = [&](std::array<vertex_id, 4> v, surface_id id) {
    raw.triangles.push_back({{v[0], v[1], v[2]}, id, true});
    raw.triangles.push_back({{v[0], v[2], v[3]}, id, true});
  };
  for (int side = 0; side < shape.sides; ++side) {
    for (int layer = 0; layer < shape.layers; ++layer)
      for (const int ring : {0, shape.rings})
        square({index(ring, side, layer), index(ring, side + 1, layer),
                index(ring, side + 1, layer + 1), index(ring, side, layer + 1)},
               shape.surface + (ring > 0 ? 1 : 0));
    for (int ring = 0; ring < shape.rings; ++ring)
      for (const int layer : {0, shape.layers})
        square({index(ring, side, layer), index(ring + 1, side, layer),
                index(ring + 1, side + 1, layer), index(ring, side + 1, layer)},
               shape.surface + (layer > 0 ? 3 : 2));
  }
}

inline version_ptr tube_mesh(const tube& shape) {
  raw_mesh raw;
  add_tube(raw, shape);
  return build_version(std::move(raw), 1)->version;
}

/// Area of a regular n-gon with corners at radius r, m^2.
inline double polygon(int n, double r) {
  return 0.5 * n * std::sin(2 * std::numbers::pi / n) * r * r;
}

}  // namespace tedit::test
