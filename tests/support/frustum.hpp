// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/build_version.hpp"

/// A part whose side may be a cone or a fillet: a CAD model has to say which.
namespace tedit::test::frustum_part {

using kind = surface_geometry::kind;

inline constexpr surface_id skirt = 1;
inline constexpr surface_id floor_of_it = 2;
inline constexpr surface_id roof = 3;
inline constexpr int sectors = 12;

/// A frustum of twelve sectors, in m: 8 mm at its bottom, 10 mm at its top, 2 mm high. Its side may
/// be a cone of 45 degrees, or the hollow fillet of 2 mm around a pin of 8 mm.
inline raw_mesh frustum() {
  raw_mesh raw;
  const auto ring = [&](double radius, double z) {
    for (int i = 0; i < sectors; ++i) {
      const double turn = 2 * std::numbers::pi * i / sectors;
      raw.positions.push_back({radius * std::cos(turn), radius * std::sin(turn), z});
    }
    raw.positions.push_back({0, 0, z});
  };
  ring(0.008, 0);
  ring(0.010, 0.002);
  const auto low = [](int i) { return static_cast<vertex_id>(i % sectors); };
  const auto high = [](int i) { return static_cast<vertex_id>(sectors + 1 + i % sectors); };
  const vertex_id below = sectors;
  const vertex_id above = 2 * sectors + 1;
  for (int i = 0; i < sectors; ++i) {
    const auto j = i + 1;
    // Cut so that the diagonals of neighbouring sectors meet: each from below to above.
    raw.tets.push_back({{below, low(i), low(j), above}});
    raw.tets.push_back({{low(i), low(j), above, high(j)}});
    raw.tets.push_back({{low(i), high(j), above, high(i)}});
    raw.triangles.push_back({{below, low(j), low(i)}, floor_of_it, true});
    raw.triangles.push_back({{above, high(i), high(j)}, roof, true});
    raw.triangles.push_back({{low(i), low(j), high(j)}, skirt, true});
    raw.triangles.push_back({{low(i), high(j), high(i)}, skirt, true});
  }
  for (auto& t : raw.tets) {
    std::array<vec3, 4> p;
    for (int k = 0; k < 4; ++k)
      p[k] = raw.positions[t.v[k]];
    if (dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) < 0)
      std::swap(t.v[0], t.v[1]);
  }
  raw.tet_regions.assign(raw.tets.size(), 1);
  return raw;
}

inline version_ptr frustum_with(const surface_geometry& geometry) {
  auto raw = frustum();
  raw.surface_names = {{skirt, "skirt", geometry}};
  auto built = build_version(std::move(raw), 1, slot_order::as_given);
  EXPECT_TRUE(built.has_value()) << (built ? "" : built.error().message);
  return built->version;
}

inline const surface_geometry fillet{kind::torus, {0, 0, 0.002}, {0, 0, 1}, 0.008, 0, 0.002};
/// Its point is the apex: a radius of none there.
inline const surface_geometry cone{kind::cone, {0, 0, -0.008}, {0, 0, 1}, 0, 1, 0};

}  // namespace tedit::test::frustum_part
