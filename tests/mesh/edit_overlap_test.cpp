// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/edit_overlap.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/edits.hpp"
#include "tests/support/meshes.hpp"

namespace tedit {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A bar of 8 x 1 x 1 cubes of 1 m, each of six tets; surface 2 is its end at x = 8, 6 its top.
version_ptr bar() {
  return test::box_mesh({8, 1, 1}, {8, 1, 1});
}

version_ptr split_where(const version_ptr& mesh, double from, double to) {
  return test::split(mesh, [&](tet_id t) {
    const auto c = mesh->corners(t);
    const double x = (c[0].x + c[1].x + c[2].x + c[3].x) / 4;
    return x > from && x < to;
  });
}

version_ptr stretch(const version_ptr& mesh, double plane) {
  return test::move(mesh, [&](vec3 p) { return p.x == plane ? vec3{p.x + .25, p.y, p.z} : p; });
}

TEST(EditOverlap, EditsInDifferentPlacesHaveNone) {
  const auto seen = bar();
  const auto head = split_where(seen, 0, 1);
  const auto edited = split_where(head, 7, 8);

  const auto found = overlap_of(*seen, *head, *edited, {});

  EXPECT_TRUE(found.none());
  EXPECT_THAT(found.surfaces, IsEmpty());
}

TEST(EditOverlap, TetsThatWereMadeMeanwhileMayNotBeTaken) {
  const auto seen = bar();
  const auto head = split_where(seen, 0, 1);    // Six tets become 24.
  const auto edited = split_where(head, 0, 2);  // Those, and six that were seen.

  const auto found = overlap_of(*seen, *head, *edited, {});

  EXPECT_EQ(found.tets, 24U);
  EXPECT_FALSE(found.surfaces.empty());
  EXPECT_FALSE(found.none());
}

TEST(EditOverlap, WhatIsNotTouchedSinceIsThereWhateverWasAddedElsewhere) {
  const auto seen = bar();
  const auto head = split_where(seen, 0, 1);
  EXPECT_TRUE(overlap_of(*seen, *head, *split_where(head, 1, 2), {}).none());
}

TEST(EditOverlap, VerticesThatMoveReshapeAllTetsAround) {
  const auto seen = bar();
  const auto head = stretch(seen, 3);  // The cubes from 2 to 4.

  EXPECT_EQ(overlap_of(*seen, *head, *stretch(head, 4), {}).tets, 6U);  // The cube from 3 to 4.
  EXPECT_EQ(overlap_of(*seen, *head, *stretch(head, 5), {}).tets, 0U);
  EXPECT_EQ(overlap_of(*seen, *head, *split_where(head, 2, 4), {}).tets, 12U);
}

TEST(EditOverlap, ASelectedWallThatWasChangedElsewhereIsTold) {
  const auto seen = bar();
  const auto head = test::dig(
    seen, [](vec3 p) { return p.x < 1; }, 50);  // A cube less.
  const auto edited = split_where(head, 6, 7);
  const std::vector<surface_id> end{surface_id{2}}, top{surface_id{6}};

  EXPECT_TRUE(overlap_of(*seen, *head, *edited, end).none());
  EXPECT_THAT(overlap_of(*seen, *head, *edited, top).reshaped, ElementsAre(surface_id{6}));
  EXPECT_EQ(overlap_of(*seen, *head, *edited, top).tets, 0U);
}

TEST(EditOverlap, ASelectedWallWhoseVerticesMovedIsTold) {
  const auto seen = bar();
  const auto head = stretch(seen, 3);
  const std::vector<surface_id> top{surface_id{6}}, end{surface_id{2}};

  EXPECT_THAT(overlap_of(*seen, *head, *head, top).reshaped, ElementsAre(surface_id{6}));
  EXPECT_TRUE(overlap_of(*seen, *head, *head, end).none());
}

TEST(EditOverlap, TheVersionThatWasSeenMayLieOnAnotherBranch) {
  const auto root = bar();
  const auto seen = split_where(root, 0, 1);
  const auto head = split_where(root, 7, 8);

  EXPECT_TRUE(overlap_of(*seen, *head, *split_where(head, 3, 4), {}).none());
  // Its cube is whole again: nobody who saw it cut may change it unasked.
  EXPECT_EQ(overlap_of(*seen, *head, *split_where(head, 0, 1), {}).tets, 6U);
}

TEST(EditOverlap, BetweenEqualVersionsThereIsNone) {
  const auto mesh = bar();
  const std::vector<surface_id> all{1, 2, 3, 4, 5, 6};
  EXPECT_TRUE(overlap_of(*mesh, *mesh, *split_where(mesh, 0, 8), all).none());
}

}  // namespace
}  // namespace tedit
