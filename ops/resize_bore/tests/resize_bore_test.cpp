// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/resize_bore/resize_bore.hpp"

#include <algorithm>

#include <gmock/gmock.h>

#include "tests/support/features_on_plate.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

class ResizeBore : public test::features_on_plate {
protected:
  static double figure_of(const edit_result& result, const std::string& id) {
    const auto found = std::ranges::find(result.figures, id, &figure::id);
    return found == result.figures.end() ? -1 : found->value;
  }

  /// The bores are prisms on the new cylinder: no smaller than with 20 corners, and within it.
  static void expect_prisms(const edit_result& result, int bores, double d) {
    const double gone = hole_volume(0.2) - result.volume_change / bores;
    const double round = 0.2 * std::numbers::pi * d * d / 4;
    EXPECT_LT(gone, round);
    EXPECT_GT(gone, round * std::sin(2 * std::numbers::pi / 20) / (2 * std::numbers::pi / 20));
  }
};

TEST_F(ResizeBore, ABoreBecomesWiderAndKeepsItsNumber) {
  const auto mesh = with_hole({0.5, 0.5, 0.2});
  const auto bore = surface_named(*mesh, "bore");

  const auto result = resize_bores(mesh, {bore}, 0.3, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(mesh, *result);
  expect_prisms(*result, 1, 0.3);
  EXPECT_EQ(surface_named(*result->candidate, "bore"), bore);
  EXPECT_EQ(result->candidate->surfaces().size(), mesh->surfaces().size());
  EXPECT_LT(figure_of(*result, "diameter_off_mm"), 1e-3);
}

TEST_F(ResizeBore, ABoreBecomesNarrower) {
  const auto mesh = with_hole({0.5, 0.5, 0.2});

  const auto result = resize_bores(mesh, {surface_named(*mesh, "bore")}, 0.12, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(mesh, *result);
  expect_prisms(*result, 1, 0.12);
}

TEST_F(ResizeBore, TwoBoresAtOnceAreOneEdit) {
  const auto one = with_hole({0.25, 0.5, 0.2});
  const auto mesh = with_hole_in(one, {0.75, 0.5, 0.2});
  std::vector<surface_id> bores;
  for (const auto& row : mesh->surfaces())
    if (row.name == "bore")
      bores.push_back(row.id);
  ASSERT_EQ(bores.size(), 2u);

  const auto result = resize_bores(mesh, bores, 0.26, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(mesh, *result);
  expect_prisms(*result, 2, 0.26);
}

TEST_F(ResizeBore, WhatIsNoBoreOrHasThatDiameterIsRefused) {
  const auto mesh = with_hole({0.5, 0.5, 0.2});

  const auto flat = resize_bores(mesh, {6}, 0.3, ctx_);
  const auto same = resize_bores(mesh, {surface_named(*mesh, "bore")}, 0.2, ctx_);

  ASSERT_FALSE(flat);
  EXPECT_THAT(flat.error().message, HasSubstr("surface 6 is no round cylinder"));
  ASSERT_FALSE(same);
  EXPECT_THAT(same.error().message, HasSubstr("a diameter of 200 mm already"));
}

TEST_F(ResizeBore, TheLargestThatCanBeIsSaidAsADiameter) {
  const auto mesh = with_hole({0.5, 0.5, 0.2});
  ctx_.search_s = 4;

  const auto result = resize_bores(mesh, {surface_named(*mesh, "bore")}, 1.2, ctx_);

  ASSERT_FALSE(result);
  ASSERT_TRUE(result.error().most) << render(result.error());
  EXPECT_EQ(result.error().most->parameter, "diameter");
  EXPECT_GT(result.error().most->value, 0.5);
  EXPECT_LT(result.error().most->value, 1.0);
  EXPECT_THAT(result.error().remedy, HasSubstr("Take a diameter of "));
}

}  // namespace
}  // namespace tedit::ops
