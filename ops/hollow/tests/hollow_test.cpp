// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/hollow/hollow.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "ops/shapes/isosurface/isosurface.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/tool_edits.hpp"
#include "tests/support/two_regions.hpp"

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

/// Two cubes of 0.5 m side by side.
class HollowRegion : public test::tool_edits {
protected:
  expected<edit_result> run(const std::vector<surface_id>& picked, const std::string& region) {
    const auto settings = hollow_settings_of(*part_, picked,
                                             {{"thickness", 0.1},
                                              {"drain_diameter", 0.0},
                                              {"drain_points", std::string()},
                                              {"region", region}});
    if (!settings)
      return fail(settings.error());
    return hollow(part_, picked, *settings, ctx_);
  }

  /// Region 4 and what lies between both are as they were, region 90 lacks so much.
  void expect_taken_from_90(const expected<edit_result>& result, double volume) {
    ASSERT_TRUE(result) << render(result.error());
    expect_good(part_, *result);
    const auto& after = *result->candidate;
    EXPECT_NEAR(test::region_volume(after, 4), 0.125, 1e-12);
    EXPECT_NEAR(test::region_volume(after, 90), 0.125 - volume, 1e-9);
    EXPECT_NEAR(test::interface_area(after), 0.25, 1e-12);
    EXPECT_NEAR(result->volume_change, -volume, 1e-9);
  }

  version_ptr part_ = test::two_regions(2);
};

TEST_F(HollowRegion, OneOfTwoBecomesAShellUpToTheOther) {
  expect_taken_from_90(run({}, "90"), 0.3 * 0.3 * 0.3);
}

/// The wall at x = 1 m is of region 90 alone; the top belongs to both, and is open where it is
/// of 90.
TEST_F(HollowRegion, WallsOfItAreOpenAndSayWhichIsMeant) {
  expect_taken_from_90(run({2}, {}), 0.4 * 0.3 * 0.3);
  expect_taken_from_90(run({6}, "90"), 0.3 * 0.3 * 0.4);
}

TEST_F(HollowRegion, WhichIsMeantHasToBeSaid) {
  const auto said = [&](const std::vector<surface_id>& picked, const std::string& region) {
    const auto made = run(picked, region);
    return made ? "accepted" : render(made.error());
  };
  EXPECT_THAT(said({}, ""), HasSubstr("which is to be hollow is not said"));
  EXPECT_THAT(said({}, ""), HasSubstr("4"));
  EXPECT_THAT(said({6}, ""), HasSubstr("surface 6"));
  EXPECT_THAT(said({1, 2}, ""), HasSubstr("surface 2"));
  EXPECT_THAT(said({77}, "90"), HasSubstr("surface 77"));
  EXPECT_THAT(said({}, "steel"), HasSubstr("no region \"steel\""));
}

class HollowDrains : public test::tool_edits {
protected:
  expected<edit_result> run(const std::string& points, double diameter,
                            const std::vector<surface_id>& picked = {}) {
    const auto settings = hollow_settings_of(*cube_, picked,
                                             {{"thickness", 0.2},
                                              {"drain_diameter", diameter},
                                              {"drain_points", points},
                                              {"region", std::string()}});
    if (!settings)
      return fail(settings.error());
    return hollow(cube_, picked, *settings, ctx_);
  }

  version_ptr cube_ = test::box_mesh({8, 8, 8}, {1, 1, 1});
};

/// A prism of 24 sides through a wall of 0.2 m for each, one of them given 30 mm above its wall.
TEST_F(HollowDrains, AreWhereTheyAreWanted) {
  const auto result = run("0.3,0.3,1.03; 1,0.6,0.5", 0.16);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(cube_, *result);
  const double drain = 0.2 * 12 * 0.08 * 0.08 * std::sin(std::numbers::pi / 12);
  EXPECT_NEAR(result->volume_change, -0.6 * 0.6 * 0.6 - 2 * drain, 1e-9);
  EXPECT_EQ(result->bodies_added, 0u);
}

TEST_F(HollowDrains, OneThatCannotBeIsToldWithItsPlace) {
  const auto corner = run("0.3,0.3,1; 0.01,0.01,1", 0.1);
  const auto off = run("0.3,0.3,1.5", 0.1);

  ASSERT_FALSE(corner);
  EXPECT_THAT(corner.error().message, HasSubstr("drain 2 (10, 10, 1000 mm): behind"));
  ASSERT_FALSE(off);
  EXPECT_THAT(off.error().message, HasSubstr("no wall within 100 mm"));
  EXPECT_THAT(run("0.3,0.3,1", 0).error().message, HasSubstr("no diameter"));
}

}  // namespace
}  // namespace tedit::ops
