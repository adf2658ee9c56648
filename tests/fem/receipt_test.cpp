// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/receipt.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/builder.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::fem {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The box with the facets of one surface handed to another.
version_ptr repainted(const version_ptr& mesh, surface_id from, surface_id to) {
  mesh_builder builder(mesh);
  const std::vector<surface_id> list{from};
  for (const auto f : facets_of(*mesh, list))
    builder.set_surface(f, to);
  return builder.freeze();
}

load_case two_items() {
  load_case loads;
  loads.name = "L";
  loads.constraints = {{{1, 3}, fixed{}}};
  loads.loads = {{{2}, force{{0, 0, -1}}}, {{}, gravity{{0, 0, -9.81}}}};
  return loads;
}

carried_load_case carry(const version_ptr& before, const version_ptr& after) {
  return carry_over(two_items(), *before, *after, compare_surfaces(*before, *after));
}

TEST(Receipt, NothingChangedIsKept) {
  const auto mesh = test::box_mesh({2, 2, 2}, {1, 1, 1});

  const auto result = carry(mesh, mesh);

  ASSERT_EQ(result.lines.size(), 2u);
  EXPECT_EQ(result.lines[0].fate, receipt_fate::kept);
  EXPECT_EQ(result.after.loads.size(), 2u);
}

TEST(Receipt, AMergedSurfaceTakesItsLoadAlong) {
  const auto before = test::box_mesh({2, 2, 2}, {1, 1, 1});
  const auto after = repainted(before, 2, 4);

  const auto result = carry(before, after);

  EXPECT_THAT(result.after.loads[0].surfaces, ElementsAre(4));
  EXPECT_EQ(result.lines[1].fate, receipt_fate::area_changed);
  EXPECT_NEAR(result.lines[1].area_after, 2, 1e-12);
  EXPECT_THAT(result.lines[1].text, HasSubstr("total force is kept"));
}

TEST(Receipt, ALostSurfaceReducesOrDropsWithASentence) {
  const auto before = test::box_mesh({2, 2, 2}, {1, 1, 1});
  const std::vector<surface_change> map{{3, surface_fate::removed, 0, "", 1, 0},
                                        {2, surface_fate::removed, 0, "", 1, 0}};
  const auto after = repainted(repainted(before, 3, 5), 2, 5);

  const auto result = carry_over(two_items(), *before, *after, map);

  EXPECT_EQ(result.lines[0].fate, receipt_fate::reduced);
  EXPECT_THAT(result.lines[0].surfaces_lost, ElementsAre(3));
  EXPECT_EQ(result.lines[1].fate, receipt_fate::dropped);
  EXPECT_THAT(result.lines[1].text, HasSubstr("no longer acts"));
  ASSERT_EQ(result.after.loads.size(), 1u);  // gravity is left
}

}  // namespace
}  // namespace tedit::fem
