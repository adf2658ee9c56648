// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/section.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/meshes.hpp"

namespace tedit {
namespace {

using test::box_mesh;

/// Area, and the area seen along the normal: both are the same when all triangles face it.
struct facing_areas {
  double area = 0;
  double seen = 0;
};

facing_areas measure(const mesh_version& mesh, const plane_section& cut, vec3 normal) {
  normal = normal / std::sqrt(dot(normal, normal));
  facing_areas sum;
  for (const auto& c : cut.triangles) {
    const vec3 p = cut.position(mesh, c[0]);
    const vec3 n = cross(cut.position(mesh, c[1]) - p, cut.position(mesh, c[2]) - p);
    sum.area += std::sqrt(dot(n, n)) / 2;
    sum.seen += dot(n, normal) / 2;
  }
  return sum;
}

TEST(Section, OfABoxIsItsRectangle) {
  const auto mesh = box_mesh({3, 2, 2}, {3, 2, 1});

  for (const double x : {0.2, 1.0, 1.5, 2.9}) {  // 1.0: through vertices.
    const auto cut = cut_by_plane(*mesh, {x, 0, 0}, {5, 0, 0}, {});
    ASSERT_TRUE(cut.has_value());
    const auto got = measure(*mesh, *cut, {1, 0, 0});
    EXPECT_NEAR(got.area, 2, 1e-12) << x;
    EXPECT_NEAR(got.seen, 2, 1e-12) << x;
  }
}

TEST(Section, AcrossTheDiagonalOfACubeIsAHexagon) {
  const auto mesh = box_mesh({2, 2, 2}, {1, 1, 1});

  const auto cut = cut_by_plane(*mesh, {0.5, 0.5, 0.5}, {1, 1, 1}, {});

  ASSERT_TRUE(cut.has_value());
  // A regular hexagon with edges of sqrt(1/2): 3 sqrt(3) / 2 times its square.
  const auto got = measure(*mesh, *cut, {1, 1, 1});
  EXPECT_NEAR(got.area, 0.75 * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(got.seen, got.area, 1e-12);
}

TEST(Section, TetsThatShareAnEdgeShareItsPoint) {
  const auto mesh = box_mesh({2, 2, 2}, {1, 1, 1});
  const auto cut = cut_by_plane(*mesh, {0.3, 0, 0}, {1, 0, 0}, {});
  ASSERT_TRUE(cut.has_value());

  for (std::size_t i = 0; i < cut->points.size(); ++i)
    for (std::size_t j = i + 1; j < cut->points.size(); ++j)
      EXPECT_FALSE(cut->points[i].a == cut->points[j].a && cut->points[i].b == cut->points[j].b);
  // A linear field is exact: here x itself.
  for (const auto& p : cut->points)
    EXPECT_NEAR((1 - p.t) * mesh->position(p.a).x + p.t * mesh->position(p.b).x, 0.3, 1e-15);
}

TEST(Section, BesideThePartIsEmpty) {
  const auto mesh = box_mesh({1, 1, 1}, {1, 1, 1});
  const auto cut = cut_by_plane(*mesh, {2, 0, 0}, {1, 0, 0}, {});

  ASSERT_TRUE(cut.has_value());
  EXPECT_TRUE(cut->triangles.empty());
}

TEST(Section, NoPlaneIsRefused) {
  const auto mesh = box_mesh({1, 1, 1}, {1, 1, 1});

  for (const vec3 normal : {vec3{0, 0, 0}, vec3{NAN, 0, 0}, vec3{INFINITY, 0, 0}}) {
    const auto cut = cut_by_plane(*mesh, {0, 0, 0}, normal, {});
    ASSERT_FALSE(cut.has_value());
    EXPECT_EQ(cut.error().code, ec::invalid_argument);
  }
  EXPECT_FALSE(cut_by_plane(*mesh, {NAN, 0, 0}, {1, 0, 0}, {}).has_value());
}

TEST(Section, CanBeCancelled) {
  const auto mesh = box_mesh({1, 1, 1}, {1, 1, 1});
  execution run;
  run.cancel.cancel();

  const auto cut = cut_by_plane(*mesh, {0.5, 0, 0}, {1, 0, 0}, run);

  ASSERT_FALSE(cut.has_value());
  EXPECT_EQ(cut.error().code, ec::cancelled);
}

}  // namespace
}  // namespace tedit
