// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/version_lanes.hpp"

#include <set>

#include <gtest/gtest.h>

namespace tedit::desktop {
namespace {

using tree = std::map<std::uint32_t, std::optional<std::uint32_t>>;

TEST(VersionLanes, OneAfterTheOtherStandInOneLane) {
  const auto at = lanes_of(tree{{0, {}}, {1, 0}, {2, 1}});

  EXPECT_EQ(at.at(0), (version_place{0, 0}));
  EXPECT_EQ(at.at(1), (version_place{1, 0}));
  EXPECT_EQ(at.at(2), (version_place{2, 0}));
}

TEST(VersionLanes, AnEditAfterAnUndoBeginsALaneBelow) {
  const auto at = lanes_of(tree{{0, {}}, {1, 0}, {2, 1}, {3, 0}, {4, 3}});

  EXPECT_EQ(at.at(2), (version_place{2, 0}));
  EXPECT_EQ(at.at(3), (version_place{1, 1}));
  EXPECT_EQ(at.at(4), (version_place{2, 1}));
}

TEST(VersionLanes, OfSeveralBranchesTheOldestIsTheNearest) {
  const auto at = lanes_of(tree{{0, {}}, {1, 0}, {2, 0}, {3, 0}});

  EXPECT_EQ(at.at(2), (version_place{1, 1}));
  EXPECT_EQ(at.at(3), (version_place{1, 2}));
}

TEST(VersionLanes, ALaneIsUsedAgainLeftOfWhatStandsInIt) {
  // 0-1-2-3 with a branch 4 of 2, and a branch 5 of 0 that ends before it.
  const auto at = lanes_of(tree{{0, {}}, {1, 0}, {2, 1}, {3, 2}, {4, 2}, {5, 0}});

  EXPECT_EQ(at.at(4), (version_place{3, 1}));
  EXPECT_EQ(at.at(5), (version_place{1, 1}));
}

TEST(VersionLanes, NobodyStandsBetweenAVersionAndItsChildNorInOnePlace) {
  // A bushy tree: each version hangs on one of those before it.
  tree parents{{0, {}}};
  std::uint32_t seed = 7;
  for (std::uint32_t n = 1; n < 200; ++n) {
    seed = seed * 1664525U + 1013904223U;
    parents[n] = (seed >> 8) % n;
  }

  const auto at = lanes_of(parents);

  std::set<std::pair<int, int>> taken;
  for (const auto& [number, place] : at) {
    EXPECT_TRUE(taken.insert({place.column, place.lane}).second) << number;
    if (parents[number]) {
      EXPECT_EQ(place.column, at.at(*parents[number]).column + 1);
      EXPECT_GE(place.lane, at.at(*parents[number]).lane);
    }
  }
  EXPECT_EQ(at.size(), 200U);
}

TEST(VersionLanes, AMissingParentMakesARootOfItsOwn) {
  const auto at = lanes_of(tree{{0, {}}, {5, 3}});

  EXPECT_EQ(at.at(5), (version_place{0, 1}));
}

}  // namespace
}  // namespace tedit::desktop
