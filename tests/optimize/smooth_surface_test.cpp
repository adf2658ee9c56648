// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/optimize/smooth_surface.hpp"

#include <gtest/gtest.h>

#include "mesh/checks.hpp"
#include "tests/support/meshes.hpp"

namespace tedit {
namespace {

constexpr surface_id top = 6;  // z = max

/// A slab whose top grid points are up and down by `height`, the rim not.
version_ptr bumpy(double height) {
  return test::box_mesh({6, 6, 2}, {6, 6, 2}, [height](vec3 p) {
    const bool inner = p.x > 0 && p.x < 6 && p.y > 0 && p.y < 6;
    if (p.z == 2 && inner)
      p.z += (static_cast<int>(p.x + p.y) % 2 == 0 ? height : -height);
    return p;
  });
}

TEST(SmoothSurface, OneVertexGoesToTheMeanOfItsSymmetricalNeighbours) {
  // Only the middle of the top moves; the six neighbours on the flat rim are symmetrical about it.
  const auto mesh = test::box_mesh({2, 2, 1}, {2, 2, 1}, [](vec3 p) {
    return p == vec3{1, 1, 1} ? vec3{1, 1, 1.25} : p;
  });
  mesh_builder builder(mesh);

  const auto report = smooth_surface(builder, {top}, {}, {});

  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->movable, 1u);
  EXPECT_EQ(report->moved, 1u);
  EXPECT_NEAR(report->largest_move, 0.25, 1e-12);
  EXPECT_NEAR(report->roughness_after, 0, 1e-12);
  EXPECT_GT(report->roughness_before, 0.1);
}

TEST(SmoothSurface, BumpsGoAndAllElseStays) {
  const auto mesh = bumpy(0.3);
  const double worst = radius_ratios(*mesh).min;
  mesh_builder builder(mesh);

  const auto report = smooth_surface(builder, {top}, {}, {});
  const auto after = builder.freeze();

  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->movable, 25u);
  EXPECT_LT(report->roughness_after, 0.2 * report->roughness_before);
  for (vertex_id v = 0; v < mesh->vertex_slots(); ++v) {
    const vec3 p = mesh->position(v);
    const bool inner = p.x > 0 && p.x < 6 && p.y > 0 && p.y < 6 && p.z > 1.5;
    EXPECT_TRUE(inner || after->position(v) == p);
  }
  EXPECT_GE(radius_ratios(*after).min, std::min(0.1, worst) * (1 - 1e-12));
  EXPECT_TRUE(check_version(*after).ok());
}

TEST(SmoothSurface, AStepThatWouldFlattenATetIsShortened) {
  // The top vertex hangs above a thin slab: its neighbours' mean lies below the vertex under it.
  const auto mesh = test::box_mesh({2, 2, 1}, {2, 2, 1}, [](vec3 p) {
    if (p == vec3{1, 1, 0})
      return vec3{1, 1, 1.2};
    return p == vec3{1, 1, 1} ? vec3{1, 1, 1.6} : p;
  });
  const double worst = radius_ratios(*mesh).min;
  mesh_builder builder(mesh);

  const auto report = smooth_surface(builder, {top}, {}, {});
  const auto after = builder.freeze();

  ASSERT_TRUE(report.has_value());
  EXPECT_GT(after->position(builder.vertex_slots() / 2 + 4).z, 1.2);
  EXPECT_GE(radius_ratios(*after).min, std::min(0.1, worst) * (1 - 1e-12));
  EXPECT_TRUE(check_version(*after).ok());
}

TEST(SmoothSurface, TheTaubinPairKeepsARoundSurface) {
  const auto dome = [](vec3 p) {
    p.z += 0.05 * (p.x * (6 - p.x) + p.y * (6 - p.y));
    return p;
  };
  const auto mesh = test::box_mesh({6, 6, 2}, {6, 6, 2}, dome);
  mesh_builder plain(mesh);
  mesh_builder pair(mesh);
  smooth_settings keep;
  keep.keep_volume = true;

  const auto flattened = smooth_surface(plain, {top}, {}, {});
  const auto kept = smooth_surface(pair, {top}, keep, {});

  ASSERT_TRUE(flattened.has_value());
  ASSERT_TRUE(kept.has_value());
  EXPECT_LT(kept->largest_move, 0.25 * flattened->largest_move);
}

TEST(SmoothSurface, ACreaseBetweenTwoGivenSurfacesIsNoRim) {
  const auto mesh = bumpy(0.2);
  mesh_builder builder(mesh);

  const auto both = smooth_surface(builder, {top, 2}, {}, {});

  ASSERT_TRUE(both.has_value());
  // 25 on the top, 5 on the side x = max, and the 5 inner ones of their common edge.
  EXPECT_EQ(both->movable, 35u);
}

TEST(SmoothSurface, RepeatsItselfAndACancelLeavesTheMeshAlone) {
  const auto mesh = bumpy(0.3);
  mesh_builder first(mesh);
  mesh_builder second(mesh);
  ASSERT_TRUE(smooth_surface(first, {top}, {}, {}).has_value());
  execution run;
  run.cancel = cancel_token::at_poll(40);

  const auto stopped = smooth_surface(second, {top}, {}, run);

  ASSERT_FALSE(stopped.has_value());
  EXPECT_EQ(stopped.error().code, ec::cancelled);
  EXPECT_EQ(second.freeze()->id(), mesh->id());
  ASSERT_TRUE(smooth_surface(second, {top}, {}, {}).has_value());
  EXPECT_EQ(first.freeze()->id(), second.freeze()->id());
}

}  // namespace
}  // namespace tedit
