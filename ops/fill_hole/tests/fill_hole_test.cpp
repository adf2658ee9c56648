// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/features/fill_holes.hpp"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/finish_edit.hpp"
#include "ops/services/host_services.hpp"
#include "ops/shapes/caps/caps.hpp"
#include "tests/support/blocks.hpp"

namespace tedit::ops {
namespace {

using test::blocks;
using ::testing::HasSubstr;

struct filled {
  expected<edit_result> edit;
  expected<finished_edit> finished = fail(ec::internal, "not run");
};

filled fill(const version_ptr& mesh, std::vector<surface_id> surfaces,
            completion_settings settings = {}) {
  setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
  const auto host = make_host_services();
  context ctx;
  ctx.host = host.get();
  filled result{fill_holes(mesh, surfaces, settings, ctx)};
  if (result.edit) {
    edit_claim claim;
    claim.touched = result.edit->touched;
    claim.volume_change = result.edit->volume_change;
    result.finished = finish_edit(mesh, result.edit->candidate, claim, improvement::local, {}, {});
  }
  return result;
}

TEST(FillHole, ThroughHoleClosesIntoTheSurfacesAroundIt) {
  const auto mesh = blocks(3, [](int x, int y, int) { return x != 1 || y != 1; });

  const auto result = fill(mesh, {7});

  ASSERT_TRUE(result.edit.has_value()) << render(result.edit.error());
  EXPECT_DOUBLE_EQ(result.edit->volume_change, 3);
  ASSERT_TRUE(result.finished.has_value()) << render(result.finished.error());
  const auto& after = *result.finished->version;
  EXPECT_NEAR(total_volume(after), 27, 1e-12);
  EXPECT_EQ(after.find_surface(7), nullptr);
  EXPECT_EQ(after.surfaces().size(), 6u);
  EXPECT_TRUE(check_version(after).ok());
  ASSERT_TRUE(result.finished->ratios.has_value());
  EXPECT_GE(result.finished->ratios->min_after, 0.15);
}

TEST(FillHole, BlindHoleClosesWithItsBottom) {
  const auto mesh = blocks(3, [](int x, int y, int z) { return x != 1 || y != 1 || z != 2; });

  const auto result = fill(mesh, {7});

  ASSERT_TRUE(result.finished.has_value());
  EXPECT_DOUBLE_EQ(result.edit->volume_change, 1);
  EXPECT_NEAR(total_volume(*result.finished->version), 27, 1e-12);
}

TEST(FillHole, ClosedVoidNeedsNoCap) {
  const auto mesh = blocks(3, [](int x, int y, int z) { return x != 1 || y != 1 || z != 1; });

  const auto result = fill(mesh, {7});

  ASSERT_TRUE(result.finished.has_value());
  EXPECT_NEAR(total_volume(*result.finished->version), 27, 1e-12);
  EXPECT_TRUE(check_version(*result.finished->version).ok());
}

TEST(FillHole, TheOuterSkinIsNoHole) {
  const auto mesh = blocks(2, [](int, int, int) { return true; });

  const auto result = fill(mesh, {1, 2, 3, 4, 5, 6}, {true, false});

  ASSERT_FALSE(result.edit.has_value());
  EXPECT_EQ(result.edit.error().code, ec::not_a_hole);
}

TEST(FillHole, AFlatSurfaceIsNoHole) {
  const auto mesh = blocks(2, [](int, int, int) { return true; });

  const auto result = fill(mesh, {1});

  ASSERT_FALSE(result.edit.has_value());
  EXPECT_THAT(render(result.edit.error()), HasSubstr("flat"));
}

TEST(FillHole, CancelStopsTheEdit) {
  const auto mesh = blocks(3, [](int x, int y, int) { return x != 1 || y != 1; });
  const auto host = make_host_services();
  context ctx;
  ctx.host = host.get();
  ctx.run.cancel.cancel();

  const auto result = fill_holes(mesh, {7}, {}, ctx);

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ec::cancelled);
}

TEST(FillHole, MissingMesherIsNamed) {
  const auto mesh = blocks(3, [](int x, int y, int) { return x != 1 || y != 1; });
  setenv("TEDIT_LIBEXEC", "/nowhere", 1);
  const auto host = make_host_services();
  context ctx;
  ctx.host = host.get();

  const auto result = fill_holes(mesh, {7}, {}, ctx);

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ec::service_unavailable);
  EXPECT_THAT(result.error().message, HasSubstr("/nowhere/tedit-mesher"));
}

TEST(FillHole, ANotchInAnEdgeGetsACapInEachPlane) {
  const auto mesh = blocks(3, [](int x, int y, int z) { return x != 1 || y != 0 || z != 2; });

  const auto result = fill(mesh, {7});

  ASSERT_TRUE(result.edit.has_value()) << render(result.edit.error());
  EXPECT_NEAR(result.edit->volume_change, 1, 1e-12);
  ASSERT_TRUE(result.finished.has_value()) << render(result.finished.error());
  const auto& after = *result.finished->version;
  EXPECT_NEAR(total_volume(after), 27, 1e-12);
  EXPECT_EQ(after.surfaces().size(), 6u);
}

TEST(FillHole, ANotchInACornerGetsItsCornerBack) {
  const auto mesh = blocks(3, [](int x, int y, int z) { return x != 0 || y != 0 || z != 2; });

  const auto result = fill(mesh, {7});

  ASSERT_TRUE(result.finished.has_value()) << render(result.edit.error());
  const auto& after = *result.finished->version;
  EXPECT_NEAR(total_volume(after), 27, 1e-12);
  EXPECT_EQ(after.surfaces().size(), 6u);
}

/// A plate of 9 x 9 x 3 cells bent around the axis y at z = -20, with a square hole through it.
version_ptr bent_plate() {
  return blocks(
    {9, 9, 3}, [](int x, int y, int) { return x < 3 || x > 5 || y < 3 || y > 5; },
    [](vec3 p) -> vec3 {
      const double angle = (p.x - 4.5) / 20;
      const double radius = 20 + p.z;
      return {radius * std::sin(angle), p.y, radius * std::cos(angle) - 20};
    });
}

TEST(FillHole, AHoleThroughACylindersWallIsClosedWithinTheCylinder) {
  const auto mesh = bent_plate();

  const auto result = fill(mesh, {7});

  ASSERT_TRUE(result.finished.has_value()) << render(result.edit.error());
  const auto& after = *result.finished->version;
  EXPECT_EQ(after.surfaces().size(), 6u) << "both caps go on the surface around them";
  // The hole is 3 wide; flat caps would leave the outer radius of 23 by 23 (1 - cos 0.075) = 0.065.
  for (facet_id f = 0; f < after.facet_slots(); ++f)
    if (after.is_live_facet(f) && after.facet(f).surface >= 5)
      for (const auto v : after.facet(f).v) {
        const vec3 p = after.position(v);
        EXPECT_NEAR(std::hypot(p.x, p.z + 20), after.facet(f).surface == 5 ? 20 : 23, 1e-9);
      }
}

TEST(FillHole, ABentRimWithoutASmoothShapeGetsASurfaceOfLeastArea) {
  // A saddle-like twist of fourth order: no quadric fits within 5 % of the rim.
  const auto mesh = blocks(
    {9, 9, 3}, [](int x, int y, int) { return x < 3 || x > 5 || y < 3 || y > 5; },
    [](vec3 p) -> vec3 {
      const double x = p.x - 4.5;
      const double y = p.y - 4.5;
      return {p.x, p.y, p.z + 0.004 * (x * x * x * x - y * y * y * y)};
    });

  const auto result = fill(mesh, {7});

  ASSERT_TRUE(result.finished.has_value()) << render(result.edit.error());
  const auto& after = *result.finished->version;
  EXPECT_EQ(after.surfaces().size(), 8u) << "two caps of their own";
  EXPECT_TRUE(check_version(after).ok());
}

TEST(Rims, AFigureEightGivesTwoSimpleLoops) {
  // Two squares of the top that touch in one vertex.
  const auto mesh = blocks(4, [](int, int, int) { return true; });
  std::vector<facet_id> picked;
  for (facet_id f = 0; f < mesh->facet_slots(); ++f) {
    const auto& facet = mesh->facet(f);
    const vec3 middle =
      (mesh->position(facet.v[0]) + mesh->position(facet.v[1]) + mesh->position(facet.v[2])) / 3;
    const int x = static_cast<int>(middle.x);
    const int y = static_cast<int>(middle.y);
    if (facet.surface == 6 && x == y && (x == 1 || x == 2))
      picked.push_back(f);
  }

  const auto shells = find_shells(*mesh, picked);

  ASSERT_EQ(shells.size(), 2u);
  for (const auto& part : shells) {
    ASSERT_EQ(part.rims.size(), 1u);
    EXPECT_EQ(part.rims[0].loop.size(), 4u);
    EXPECT_DOUBLE_EQ(part.rims[0].convex_share, 1) << "flat: neither convex nor concave";
    EXPECT_DOUBLE_EQ(part.rims[0].concave_share, 1);
  }
}

}  // namespace
}  // namespace tedit::ops
