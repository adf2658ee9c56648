// SPDX-License-Identifier: AGPL-3.0-or-later
#include "compare/load_differences.hpp"

#include <gtest/gtest.h>

#include "tests/support/meshes.hpp"

namespace tedit {
namespace {

using lines = std::vector<std::string>;

fem::load_case pulled_bar() {
  return {"pull",
          {{"steel", 2.1e11, .3, 7850, 2.4e8}},
          {{{1}, fem::fixed{}}},
          {{{2}, fem::force{{0, 0, -1000}}}, {{}, fem::gravity{{0, 0, -9.81}}}}};
}

TEST(LoadDifferences, EqualLoadCasesHaveNone) {
  EXPECT_TRUE(differences_of(pulled_bar(), pulled_bar()).empty());
}

TEST(LoadDifferences, ANumberIsSaidByItsPathWithEveryDigit) {
  auto after = pulled_bar();
  after.loads[0].kind = fem::force{{0, 0, -1000.0000000001}};

  EXPECT_EQ(differences_of(pulled_bar(), after),
            lines{"loads[0].force.total_n.z: -1000 -> -1000.0000000001"});
}

TEST(LoadDifferences, AnotherKindSaysWhatWentAndWhatCame) {
  auto after = pulled_bar();
  after.constraints[0].kind = fem::prescribed_displacement{0.001, std::nullopt, std::nullopt};

  EXPECT_EQ(
    differences_of(pulled_bar(), after),
    (lines{"constraints[0].fixed: yes -> none", "constraints[0].displacement.x_m: none -> 0.001",
           "constraints[0].displacement.y_m: none -> free",
           "constraints[0].displacement.z_m: none -> free"}));
}

TEST(LoadDifferences, SurfacesAndMaterialsAreNamed) {
  auto after = pulled_bar();
  after.loads[0].surfaces = {2, 7};
  after.materials[0].name = "iron";

  const auto found = differences_of(pulled_bar(), after);

  EXPECT_EQ(std::ranges::count(found, "loads[0].surfaces: 2 -> 2, 7"), 1);
  EXPECT_EQ(std::ranges::count(found, "materials[iron].poisson_ratio: none -> 0.3"), 1);
  EXPECT_EQ(std::ranges::count(found, "materials[steel].regions: all others -> none"), 1);
}

TEST(LoadDifferences, EveryKindOfLoadIsLookedInto) {
  const std::vector<decltype(fem::load::kind)> kinds{
    fem::traction{{1, 0, 0}},
    fem::pressure{5, {0, 0, 1}, {0, 0, 2}},
    fem::normal_force{3},
    fem::moment{{0, 1, 0}},
    fem::remote_force{{1, 0, 0}, {0, 0, 3}, {0, 4, 0}},
    fem::bearing_force{{2, 0, 0}},
    fem::gravity{{0, 1, 0}}};
  for (const auto& kind : kinds) {
    auto before = pulled_bar();
    auto after = pulled_bar();
    before.loads = {{{3}, fem::force{{1, 2, 3}}}};
    after.loads = {{{3}, kind}};

    EXPECT_GT(differences_of(before, after).size(), 3u) << kind.index();
    EXPECT_TRUE(differences_of(after, after).empty()) << kind.index();
  }
}

TEST(RegionVolumes, MassTakesTheMaterialOfTheRegionAndElseTheOneForAll) {
  const std::vector<region_volume> volumes{{1, 2.0}, {2, 3.0}};
  fem::load_case loads{"two", {{"all", 1, 0, 10}, {"second", 1, 0, 100, 0, {2}}}};

  EXPECT_DOUBLE_EQ(*mass_of(volumes, loads), 320);
  std::swap(loads.materials[0], loads.materials[1]);
  EXPECT_DOUBLE_EQ(*mass_of(volumes, loads), 320);
  loads.materials.pop_back();
  EXPECT_FALSE(mass_of(volumes, loads));  // Region 1 has none.
}

}  // namespace
}  // namespace tedit
