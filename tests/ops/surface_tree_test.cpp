// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/surface_tree.hpp"

#include <gtest/gtest.h>

#include "tests/support/blocks.hpp"

namespace tedit::test {
namespace {

constexpr std::array<vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

ops::closed_surface boundary_of(const mesh_version& mesh) {
  ops::closed_surface result;
  for (vertex_id v = 0; v < mesh.vertex_slots(); ++v)
    result.points.push_back(mesh.position(v));
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    result.triangles.push_back(mesh.facet(f).v);
  return result;
}

ops::closed_surface unit_cube() {
  return boundary_of(*blocks({1, 1, 1}, [](int, int, int) { return true; }));
}

/// Rays along each axis run through corners, along edges and within flat sides.
TEST(SurfaceTree, TellsInsideFromOutsideWhereRaysMeetEdgesAndCorners) {
  const auto keep = [](int x, int y, int z) {
    return x >= 0 && x < 3 && y >= 0 && y < 2 && z >= 0 && z <= 2 - x;
  };
  const auto stair = boundary_of(*blocks({3, 2, 3}, keep));
  const ops::surface_tree tree(stair);
  int inside = 0;
  int outside = 0;
  for (int i = 0; i < 9 * 7 * 9; ++i) {
    const vec3 p{0.5 * (i % 9) - 0.5, 0.5 * (i / 9 % 7) - 0.5, 0.5 * (i / 63) - 0.5};
    int cubes = 0;  // Of the eight at the point, those that are there.
    for (int k = 0; k < 8; ++k) {
      const auto cube = [&](double c, int bit) {
        return static_cast<int>(std::floor(c + ((k >> bit & 1) != 0 ? 0.25 : -0.25)));
      };
      cubes += keep(cube(p.x, 0), cube(p.y, 1), cube(p.z, 2));
    }
    if (cubes != 0 && cubes != 8)
      continue;  // On the surface.
    ++(cubes == 8 ? inside : outside);
    for (const auto along : axes)
      EXPECT_EQ(tree.winding(p, along), cubes / 8) << p.x << ' ' << p.y << ' ' << p.z;
  }
  EXPECT_EQ(inside, 3 * (5 + 3 + 3 + 1 + 1));  // Layers of y, columns of x.
  EXPECT_GT(outside, 200);
}

TEST(SurfaceTree, CountsHowOftenSurfacesGoRound) {
  auto two = unit_cube();
  const auto cube = two;
  for (const auto p : cube.points)
    two.points.push_back(p + vec3{0.5, 0.5, 0.5});
  for (auto t : cube.triangles) {
    for (auto& v : t)
      v += static_cast<std::uint32_t>(cube.points.size());
    two.triangles.push_back(t);
  }
  auto turned = cube;
  for (auto& t : turned.triangles)
    std::swap(t[0], t[1]);
  const ops::surface_tree both(two);
  const ops::surface_tree inverse(turned);
  for (const auto along : axes) {
    EXPECT_EQ(both.winding({0.25, 0.25, 0.25}, along), 1);
    EXPECT_EQ(both.winding({0.75, 0.75, 0.75}, along), 2);
    EXPECT_EQ(both.winding({1.25, 1.25, 1.25}, along), 1);
    EXPECT_EQ(both.winding({1.25, 0.25, 0.75}, along), 0);
    EXPECT_EQ(inverse.winding({0.5, 0.5, 0.5}, along), -1);
  }
}

TEST(SurfaceTree, MeasuresToSidesEdgesAndCorners) {
  const auto cube = unit_cube();
  const ops::surface_tree tree(cube);

  EXPECT_FALSE(tree.comes_within({0.5, 0.5, 0.5}, 0.5));
  EXPECT_TRUE(tree.comes_within({0.5, 0.5, 0.5}, 0.5001));
  EXPECT_TRUE(tree.comes_within({4, 5, 0.5}, 5.0001));  // 3, 4 from an edge.
  EXPECT_FALSE(tree.comes_within({4, 5, 0.5}, 4.9999));
  EXPECT_TRUE(tree.comes_within({2, 3, 3}, 3.0001));  // 1, 2, 2 from a corner.
  EXPECT_FALSE(tree.comes_within({2, 3, 3}, 2.9999));
}

}  // namespace
}  // namespace tedit::test
