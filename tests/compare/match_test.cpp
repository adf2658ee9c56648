// SPDX-License-Identifier: AGPL-3.0-or-later
#include "compare/match.hpp"

#include <gtest/gtest.h>

#include "tests/support/edits.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/renumbered.hpp"

namespace tedit {
namespace {

version_ptr cube_of_64() {
  return test::box_mesh({4, 4, 4}, {1, 1, 1});
}

version_match match(const version_ptr& before, const version_ptr& after) {
  return *match_versions(*before, *after, {});
}

TEST(MatchVersions, EqualVersionsListNothing) {
  const auto found = match(cube_of_64(), cube_of_64());

  EXPECT_TRUE(found.elsewhere.empty());
  EXPECT_TRUE(found.tets_before.empty());
  EXPECT_TRUE(found.tets_after.empty());
  EXPECT_TRUE(found.facets_after.empty());
  EXPECT_EQ(found.vertices, 125u);
}

TEST(MatchVersions, WhatWasTakenAwayIsOnlyBefore) {
  const auto before = cube_of_64();
  const auto after = test::dig(
    before, [](vec3 p) { return p.x < .25 && p.y < .25 && p.z < .25; }, 1);

  const auto found = match(before, after);

  EXPECT_EQ(found.tets_before.size(), 6u);
  EXPECT_TRUE(found.tets_after.empty());
  EXPECT_EQ(found.facets_before.size(), 6u);
  EXPECT_EQ(found.facets_after.size(), 6u);
  EXPECT_EQ(found.vertices, 124u);
}

TEST(MatchVersions, ASplitTetIsFourThatBeforeHasNot) {
  const auto before = cube_of_64();
  const auto after = test::split(before, [](tet_id t) { return t == 100; });

  const auto found = match(before, after);

  EXPECT_EQ(found.tets_before, std::vector<tet_id>{100});
  EXPECT_EQ(found.tets_after.size(), 4u);
  EXPECT_EQ(found.elsewhere.size(), 1u);
  EXPECT_EQ(found.elsewhere.begin()->second, no_id);
  EXPECT_TRUE(found.facets_after.empty());
}

TEST(MatchVersions, AMovedVertexChangesTheTetsAroundItInPagesThatStayed) {
  const auto before = cube_of_64();
  const auto after = test::move(before, [](vec3 p) {
    return p == vec3{.5, .5, .5} ? vec3{.5, .5, .51} : p;
  });
  ASSERT_EQ(before->data().tets.pages().front(), after->data().tets.pages().front());

  const auto found = match(before, after);

  EXPECT_EQ(found.tets_before.size(), 24u);  // Kuhn's star of an inner vertex.
  EXPECT_EQ(found.tets_after, found.tets_before);
  EXPECT_EQ(found.vertices, 124u);
}

TEST(MatchVersions, AMovedCornerOfTheBoundaryChangesTheFacetsAroundIt) {
  const auto before = cube_of_64();
  const auto after = test::move(before, [](vec3 p) {
    return p == vec3{1, .5, .5} ? vec3{1.01, .5, .5} : p;
  });

  const auto found = match(before, after);

  EXPECT_EQ(found.facets_before.size(), 6u);
  EXPECT_EQ(found.facets_after, found.facets_before);
}

TEST(MatchVersions, TheSameMeshWithOtherNumbersIsTheSame) {
  const auto before = cube_of_64();

  const auto found = match(before, test::renumbered(*before));

  EXPECT_TRUE(found.tets_before.empty());
  EXPECT_TRUE(found.tets_after.empty());
  EXPECT_TRUE(found.facets_before.empty());
  EXPECT_TRUE(found.facets_after.empty());
  EXPECT_EQ(found.vertices, 125u);
  for (const auto& [v, twin] : found.elsewhere)
    EXPECT_EQ(twin, 124 - v);
}

TEST(MatchVersions, WhatAFileInOtherUnitsRoundsIsTheSame) {
  const auto before = test::box_mesh({4, 3, 2}, {0.1, 0.07, 0.03});
  const auto after = test::move(before, [](vec3 p) { return (1 / 25.4) * (25.4 * p); });
  ASSERT_NE(before->id(), after->id());

  EXPECT_TRUE(match(before, after).tets_after.empty());
  EXPECT_EQ(match(before, after).vertices, before->vertex_count());
}

TEST(MatchVersions, FurtherApartThanRoundingIsNotTheSame) {
  const auto before = cube_of_64();
  const auto after = test::move(before, [](vec3 p) {
    return p == vec3{.5, .5, .5} ? vec3{.5, .5, .5 + 1e-10} : p;
  });

  EXPECT_EQ(match(before, after).tets_after.size(), 24u);
}

TEST(MatchVersions, ACancelEndsIt) {
  execution run;
  run.cancel.cancel();

  const auto found = match_versions(*cube_of_64(), *cube_of_64(), run);

  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ec::cancelled);
}

}  // namespace
}  // namespace tedit
