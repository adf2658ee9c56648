// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/pieces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/edits.hpp"
#include "tests/support/meshes.hpp"

namespace tedit {
namespace {

using ::testing::HasSubstr;

std::unordered_set<tet_id> tets_in(const mesh_version& mesh,
                                   const std::function<bool(vec3)>& inside) {
  std::unordered_set<tet_id> result;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    const auto c = mesh.corners(t);
    if (inside(0.25 * (c[0] + c[1] + c[2] + c[3])))
      result.insert(t);
  }
  return result;
}

TEST(Pieces, AHingeGetsItsTetsBack) {
  // Two opposite quarters of a block gone: the others meet in the edge between them.
  const auto base = test::box_mesh({2, 2, 1}, {2, 2, 1});
  const mesh_builder builder(base);
  auto removed = tets_in(*base, [](vec3 p) { return (p.x < 1) == (p.y < 1); });
  ASSERT_EQ(removed.size(), 12u);

  const auto mended = mend_hinges(builder, removed);

  EXPECT_GT(mended, 0u);
  EXPECT_LT(removed.size(), 12u);
  EXPECT_EQ(mend_hinges(builder, removed), 0u);
}

TEST(Pieces, ACleanRemovalIsLeftAlone) {
  const auto base = test::box_mesh({2, 2, 2}, {2, 2, 2});
  const mesh_builder builder(base);
  auto removed = tets_in(*base, [](vec3 p) { return p.z > 1; });

  EXPECT_EQ(mend_hinges(builder, removed), 0u);
  EXPECT_EQ(removed.size(), 24u);
}

TEST(Pieces, CrumbsGoWithTheRest) {
  const auto base = test::box_mesh({200, 1, 1}, {2, 0.1, 0.1});
  const mesh_builder builder(base);
  auto removed = tets_in(*base, [](vec3 p) { return p.x > 0.01 && p.x < 0.02; });

  const auto report = settle_removal(builder, removed);

  ASSERT_TRUE(report) << render(report.error());
  EXPECT_EQ(report->crumbs, 1u);
  EXPECT_NEAR(report->crumb_volume, 0.01 * 0.1 * 0.1, 1e-15);
  EXPECT_EQ(report->pieces, 1u);
  EXPECT_EQ(removed.size(), 12u);
}

TEST(Pieces, ASplitIsRefusedWithTheSizes) {
  const auto base = test::box_mesh({4, 1, 1}, {0.004, 0.001, 0.001});
  const mesh_builder builder(base);
  auto removed = tets_in(*base, [](vec3 p) { return p.x > 0.001 && p.x < 0.002; });

  const auto report = settle_removal(builder, removed);

  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ec::invalid_argument);
  EXPECT_THAT(report.error().message, HasSubstr("2 pieces of 2 mm3, 1 mm3"));
}

TEST(Pieces, WhatFallsApartMayBeKeptOrLoseItsSmallerPieces) {
  const auto base = test::box_mesh({4, 1, 1}, {0.004, 0.001, 0.001});
  const mesh_builder builder(base);
  const auto slice = tets_in(*base, [](vec3 p) { return p.x > 0.001 && p.x < 0.002; });
  auto kept = slice;
  auto largest = slice;

  const auto both = settle_removal(builder, kept, piece_policy::allow);
  const auto one = settle_removal(builder, largest, piece_policy::keep_largest);

  ASSERT_TRUE(both && one);
  EXPECT_EQ(kept, slice);
  EXPECT_EQ(both->bodies, 1u);
  EXPECT_EQ(both->pieces, 2u);
  EXPECT_EQ(largest.size(), 12u);
  EXPECT_EQ(one->pieces, 1u);
  EXPECT_EQ(one->dropped, 1u);
  EXPECT_NEAR(one->dropped_volume, 1e-9, 1e-18);
}

TEST(Pieces, ABodyMayNotVanish) {
  const auto base = test::box_mesh({1, 1, 1}, {1, 1, 1});
  const mesh_builder builder(base);
  auto removed = tets_in(*base, [](vec3) { return true; });

  const auto report = settle_removal(builder, removed);

  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().message, HasSubstr("would vanish"));
}

TEST(Pieces, TheBoundaryTellsTheVolume) {
  const auto base = test::box_mesh({4, 4, 4}, {1, 1, 1});
  const auto dug = test::dig(
    base, [](vec3 p) { return p.x > 0.5 && p.z > 0.5; }, 7);
  const auto moved = test::move(dug, [](vec3 p) {
    return p.z == 0 ? vec3{p.x, p.y, p.z - 0.1} : p;
  });

  EXPECT_NEAR(boundary_volume_change(*base, *dug), -0.25, 1e-14);
  EXPECT_NEAR(boundary_volume_change(*base, *moved), -0.25 + 0.1, 1e-14);
}

}  // namespace
}  // namespace tedit
