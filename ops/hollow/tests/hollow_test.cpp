// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/hollow/hollow.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "ops/shapes/isosurface/isosurface.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/tool_edits.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

double volume_of(const closed_surface& s) {
  double sum = 0;
  for (const auto& t : s.triangles)
    sum += dot(s.points[t[0]], cross(s.points[t[1]], s.points[t[2]])) / 6;
  return sum;
}

/// Of a box around the origin; on its edges and corners one of the nearest faces counts.
field_sample box_field(vec3 p, vec3 half) {
  const std::array off{std::abs(p.x) - half.x, std::abs(p.y) - half.y, std::abs(p.z) - half.z};
  const auto axis = std::ranges::max_element(off) - off.begin();
  return {off[axis], axis == 0   ? vec3{std::copysign(1.0, p.x), 0, 0}
                     : axis == 1 ? vec3{0, std::copysign(1.0, p.y), 0}
                                 : vec3{0, 0, std::copysign(1.0, p.z)}};
}

TEST(Isosurface, ABoxHasItsEdgesAndCorners) {
  const vec3 half{0.5, 0.35, 0.2};
  isosurface_settings settings;
  settings.extent.add(-half);
  settings.extent.add(half);
  settings.cell = 0.083;

  const auto surface = isosurface([&](vec3 p) { return box_field(p, half); }, settings, {});

  ASSERT_TRUE(surface) << render(surface.error());
  EXPECT_NEAR(volume_of(surface->surface), 8 * half.x * half.y * half.z, 1e-6);
  double furthest = 0;
  for (const auto& p : surface->surface.points)
    furthest = std::max(furthest, norm(p));
  EXPECT_NEAR(furthest, norm(half), 1e-6);
}

TEST(Isosurface, ASphereIsWithinItsChordError) {
  isosurface_settings settings;
  settings.extent.add(vec3{-1, -1, -1});
  settings.extent.add(vec3{1, 1, 1});
  settings.cell = 0.1;

  const auto surface = isosurface(
    [](vec3 p) {
      return field_sample{norm(p) - 1, normalized(p)};
    },
    settings, {});

  ASSERT_TRUE(surface) << render(surface.error());
  for (const auto& p : surface->surface.points)
    EXPECT_NEAR(norm(p), 1, 0.1 * 0.1 / 2);
  EXPECT_NEAR(volume_of(surface->surface), 4 * std::numbers::pi / 3, 0.02);
}

TEST(Isosurface, MoreCellsThanAllowedAreRefused) {
  isosurface_settings settings;
  settings.extent.add(vec3{-1, -1, -1});
  settings.extent.add(vec3{1, 1, 1});
  settings.cell = 0.01;
  settings.most_cells = 1000;

  const auto surface = isosurface(
    [](vec3 p) {
      return field_sample{norm(p) - 1, normalized(p)};
    },
    settings, {});

  ASSERT_FALSE(surface);
  EXPECT_EQ(surface.error().code, ec::invalid_parameter);
}

class Hollow : public test::tool_edits {
protected:
  version_ptr block_ = test::box_mesh({6, 6, 6}, {1, 1, 1});
};

TEST_F(Hollow, ABlockBecomesAShellWithAClosedVoid) {
  const auto result = hollow(block_, {}, {0.2, 0}, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(block_, *result);
  EXPECT_NEAR(result->volume_change, -std::pow(0.6, 3), 1e-6);
  EXPECT_EQ(result->bodies_added, 1u);
}

TEST_F(Hollow, AnOpenWallIsGoneAllButItsRim) {
  // zmax: the void is 0.6 x 0.6 and 0.8 deep.
  const auto result = hollow(block_, {6}, {0.2, 0}, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(block_, *result);
  EXPECT_NEAR(result->volume_change, -0.6 * 0.6 * 0.8, 1e-5);
  EXPECT_EQ(result->bodies_added, 0u);
  double rim = 0;
  for (const auto f : facets_of(*result->candidate, std::array<surface_id, 1>{6}))
    rim += norm(area_vector(*result->candidate, result->candidate->facet(f)));
  EXPECT_NEAR(rim, 1 - 0.6 * 0.6, 1e-5);
}

TEST_F(Hollow, ADrainLeadsIntoTheVoid) {
  const auto result = hollow(block_, {5}, {0.2, 0.2}, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(block_, *result);
  const double drain = 0.2 * 0.5 * 24 * 0.1 * 0.1 * std::sin(2 * std::numbers::pi / 24);
  EXPECT_NEAR(result->volume_change, -std::pow(0.6, 3) - drain, 1e-5);
  EXPECT_EQ(result->bodies_added, 0u);
}

TEST_F(Hollow, WhatIsThinnerThanTwoWallsIsRefused) {
  const auto result = hollow(block_, {}, {0.51, 0}, ctx_);

  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("thicker than twice 510 mm"));
}

}  // namespace
}  // namespace tedit::ops
