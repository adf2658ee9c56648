// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/receipt.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fem/receipt_successors.hpp"
#include "mesh/builder.hpp"
#include "tests/support/blocks.hpp"
#include "tests/support/edits.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::fem {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

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
  EXPECT_THAT(result.lines[1].text, HasSubstr("total force 1 N kept"));
}

TEST(Receipt, TenThousandNewtonsAndMoreAreWrittenOutAndTenMillionAreNot) {
  const auto before = test::box_mesh({2, 2, 2}, {1, 1, 1});
  const auto after = repainted(before, 2, 4);
  const auto text = [&](double newtons) {
    auto loads = two_items();
    std::get<force>(loads.loads[0].kind).total_n = {0, 0, newtons};
    return carry_over(loads, *before, *after, compare_surfaces(*before, *after)).lines[1].text;
  };

  EXPECT_THAT(text(10000), HasSubstr("total force 10000 N kept"));
  EXPECT_THAT(text(-12345), HasSubstr("total force 12345 N kept"));
  EXPECT_THAT(text(1e7), HasSubstr("total force 1e+07 N kept"));
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

// -- loads that follow an edit --------------------------------------------------------------

using ::testing::Pair;

/// 3 x 3 x 1 unit cubes with a bore of 1 x 1 through the middle (surface 7, 4 m^2), and the same
/// filled. The lid of 1 m^2 above is surface 25; below it is 25 to one half and 26 to the other.
struct filled_bore {
  version_ptr filled = lids(test::blocks({3, 3, 1}, [](int, int, int) { return true; }));
  version_ptr bored = test::dig(
    filled, [](vec3 c) { return c.x > 1 && c.x < 2 && c.y > 1 && c.y < 2; }, 7);
  std::vector<surface_change> map = compare_surfaces(*bored, *filled);

  static version_ptr lids(const version_ptr& mesh) {
    mesh_builder builder(mesh);
    for (facet_id f = 0; f < mesh->facet_slots(); ++f) {
      vec3 c;
      for (const auto v : mesh->facet(f).v)
        c = c + (1.0 / 3) * mesh->position(v);
      const bool inside = c.x > 1 && c.x < 2 && c.y > 1 && c.y < 2;
      if (inside && (mesh->facet(f).surface == 5 || mesh->facet(f).surface == 6))
        builder.set_surface(f, c.z < 0.5 && c.x > c.y ? 26 : 25);
    }
    return builder.freeze();
  }

  carried_load_case carry(const load_case& loads, const carry_settings& settings) const {
    return carry_over(loads, *bored, *filled, map, settings);
  }
};

constexpr carry_settings move_them{load_policy::move, false};

vec3 sum_of_forces(const load_case& loads) {
  vec3 sum;
  for (const auto& one : loads.loads)
    sum = sum + std::get<force>(one.kind).total_n;
  return sum;
}

TEST(Successors, AreTheNewFacetsAtTheOldBorder) {
  const filled_bore bore;

  const auto found = successors(*bore.bored, *bore.filled).of(7);

  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found.at(25), 1.5, 1e-12);
  EXPECT_NEAR(found.at(26), 0.5, 1e-12);
}

TEST(Successors, AVoidInsideHasNone) {
  const auto full = test::blocks(3, [](int, int, int) { return true; });
  const auto hollow = test::dig(
    full, [](vec3 c) { return c.x > 1 && c.x < 2 && c.y > 1 && c.y < 2 && c.z > 1 && c.z < 2; }, 7);

  EXPECT_TRUE(successors(*hollow, *full).of(7).empty());
}

TEST(MovedLoads, AForceIsSplitByTheNewAreaOfItsSuccessors) {
  const filled_bore bore;
  load_case loads;
  loads.name = "L";
  loads.loads = {{{7}, force{{0, 0, -8}}}};

  const auto result = bore.carry(loads, move_them);

  ASSERT_EQ(result.after.loads.size(), 2u);
  EXPECT_THAT(result.after.loads[0].surfaces, ElementsAre(25));
  EXPECT_NEAR(std::get<force>(result.after.loads[0].kind).total_n.z, -6, 1e-12);
  EXPECT_THAT(result.after.loads[1].surfaces, ElementsAre(26));
  EXPECT_NEAR(std::get<force>(result.after.loads[1].kind).total_n.z, -2, 1e-12);
  const auto& line = result.lines[0];
  EXPECT_EQ(line.fate, receipt_fate::moved);
  EXPECT_THAT(line.moved_to, ElementsAre(25, 26));
  EXPECT_EQ(line.text,
            "load 0 (force): surface 7 is gone, its share moved to surface 25, 26; total force 8 N "
            "kept");
}

TEST(MovedLoads, WhatIsLeftKeepsItsShareOfAForce) {
  const filled_bore bore;
  load_case loads;
  loads.loads = {{{7, 1}, force{{14, 0, 0}}}};  // 4 m^2 and 3 m^2

  const auto result = bore.carry(loads, move_them);

  ASSERT_EQ(result.after.loads.size(), 3u);
  EXPECT_THAT(result.after.loads[0].surfaces, ElementsAre(1));
  EXPECT_NEAR(std::get<force>(result.after.loads[0].kind).total_n.x, 6, 1e-12);
  EXPECT_NEAR(std::get<force>(result.after.loads[1].kind).total_n.x, 6, 1e-12);
  EXPECT_NEAR(std::get<force>(result.after.loads[2].kind).total_n.x, 2, 1e-12);
  EXPECT_NEAR(sum_of_forces(result.after).x, 14, 1e-12);
}

TEST(MovedLoads, TractionAndPressureKeepTheirNewtonsOrTheirPascals) {
  const filled_bore bore;
  load_case loads;
  loads.loads = {{{7}, traction{{0, 0, 2}}}, {{7}, pressure{3}}};

  const auto newtons = bore.carry(loads, move_them);
  const auto pascals = bore.carry(loads, {load_policy::move, true});

  // 8 N to 1.5 and 0.5 m^2 as 6 and 2 N; 12 N as 9 and 3 N.
  ASSERT_EQ(newtons.after.loads.size(), 4u);
  EXPECT_NEAR(std::get<traction>(newtons.after.loads[0].kind).pa.z, 4, 1e-12);
  EXPECT_NEAR(std::get<traction>(newtons.after.loads[1].kind).pa.z, 4, 1e-12);
  EXPECT_NEAR(std::get<pressure>(newtons.after.loads[2].kind).pa, 6, 1e-12);
  EXPECT_NEAR(std::get<pressure>(newtons.after.loads[3].kind).pa, 6, 1e-12);
  EXPECT_THAT(newtons.lines[0].text, HasSubstr("total 8 N kept"));
  EXPECT_EQ(std::get<traction>(pascals.after.loads[0].kind).pa.z, 2);
  EXPECT_THAT(pascals.lines[0].text, HasSubstr("total changed from 8 to 4 N"));
  EXPECT_THAT(pascals.lines[1].text, HasSubstr("total changed from 12 to 6 N"));
}

TEST(MovedLoads, ThoseThatAreGivenInAllKeepIt) {
  const filled_bore bore;
  const remote_force lever{{0, 0, 5}, {1, 2, 3}, {0, 4, 0}};
  load_case loads;
  loads.loads = {{{7}, normal_force{8}},
                 {{7}, bearing_force{{8, 0, 0}}},
                 {{7, 3}, moment{{0, 0, 6}}},
                 {{7}, lever},
                 {{7}, pressure{1, {0, 0, 2}, {0, 0, 3}}}};

  const auto result = bore.carry(loads, move_them);

  const auto& after = result.after.loads;
  ASSERT_EQ(after.size(), 8u);
  // By the successors' areas of 1.5 and 0.5 m2.
  EXPECT_NEAR(std::get<normal_force>(after[0].kind).total_n, 6, 1e-12);
  EXPECT_NEAR(std::get<normal_force>(after[1].kind).total_n, 2, 1e-12);
  // No bore is left for the pin.
  EXPECT_NEAR(std::get<force>(after[2].kind).total_n.x, 6, 1e-12);
  EXPECT_NEAR(std::get<force>(after[3].kind).total_n.x, 2, 1e-12);
  // A couple has no parts.
  EXPECT_EQ(after[4], (load{{3, 25, 26}, moment{{0, 0, 6}}}));
  EXPECT_EQ(after[5], (load{{25, 26}, lever}));
  // A liquid's pressure is a matter of the place.
  EXPECT_EQ(after[6].kind, loads.loads[4].kind);
  EXPECT_EQ(after[7].kind, loads.loads[4].kind);
  EXPECT_THAT(result.lines[0].text, HasSubstr("total force 8 N kept"));
  EXPECT_THAT(result.lines[1].text, HasSubstr("load 1 (bearing force): surface 7 is gone"));
  EXPECT_THAT(result.lines[1].text, HasSubstr("total force 8 N kept"));
  EXPECT_THAT(result.lines[2].text, HasSubstr("moment 6 N m kept"));
  EXPECT_THAT(result.lines[3].text, HasSubstr("total force 5 N kept"));
  EXPECT_THAT(result.lines[4].text, HasSubstr("its pressure by place kept"));
}

TEST(CarriedLoads, APinStaysOnWhatIsLeftOfItsBore) {
  const filled_bore bore;
  load_case loads;
  loads.loads = {{{1, 7}, bearing_force{{8, 0, 0}}}};

  const auto result = bore.carry(loads, {});

  ASSERT_EQ(result.after.loads.size(), 1u);
  EXPECT_EQ(result.after.loads[0], (load{{1}, bearing_force{{8, 0, 0}}}));
}

TEST(MovedLoads, ASupportStaysOneOnTheSuccessors) {
  const filled_bore bore;
  load_case loads;
  loads.constraints = {{{7, 3}, fixed{}}, {{7}, prescribed_displacement{0.0, {}, 1e-3}}};

  const auto result = bore.carry(loads, move_them);

  ASSERT_EQ(result.after.constraints.size(), 2u);
  EXPECT_THAT(result.after.constraints[0].surfaces, ElementsAre(3, 25, 26));
  EXPECT_TRUE(std::holds_alternative<fixed>(result.after.constraints[0].kind));
  EXPECT_THAT(result.after.constraints[1].surfaces, ElementsAre(25, 26));
  EXPECT_EQ(std::get<prescribed_displacement>(result.after.constraints[1].kind).z_m, 1e-3);
  EXPECT_EQ(result.lines[1].total_before, 0);
}

/// The bore of `filled_bore` with nothing but the whole walls of 9 m^2 above and below to go to.
carried_load_case carry_to_walls(const load_case& loads) {
  const auto filled = test::blocks({3, 3, 1}, [](int, int, int) { return true; });
  const auto bored = test::dig(
    filled, [](vec3 c) { return c.x > 1 && c.x < 2 && c.y > 1 && c.y < 2; }, 7);
  return carry_over(loads, *bored, *filled, compare_surfaces(*bored, *filled), move_them);
}

TEST(MovedLoads, ToAMuchLargerAreaTheyWarnWithBothAreasAndKeepTheWarning) {
  load_case loads;
  loads.constraints = {{{7}, fixed{}}, {{1}, fixed{}}};
  loads.loads = {{{7}, pressure{3}}};

  const auto result = carry_to_walls(loads);

  const auto support =
    "an edit moved constraint 0 (fixed) from 4000000 mm2 to 1.8e+07 mm2 "
    "(surface 5, 6): check that it may act on all of that";
  EXPECT_EQ(result.lines[0].warning, support);
  EXPECT_EQ(result.after.constraints[0].warning, support);
  EXPECT_EQ(result.lines[1].warning, "");
  ASSERT_EQ(result.after.loads.size(), 2u);
  for (const auto& part : result.after.loads)
    EXPECT_EQ(part.warning, result.lines[2].warning);
  EXPECT_THAT(result.lines[2].warning, HasSubstr("load 0 (pressure)"));
  // The next edit, which does not concern it, leaves it there.
  const auto mesh = test::blocks({3, 3, 1}, [](int, int, int) { return true; });
  const auto again = carry_over(result.after, *mesh, *mesh, {}, move_them);
  EXPECT_EQ(again.lines[0].warning, "");
  EXPECT_EQ(again.after.constraints[0].warning, support);
}

TEST(MovedLoads, ToASimilarAreaTheySayNothing) {
  const filled_bore bore;
  load_case loads;
  loads.constraints = {{{7}, fixed{}}};  // 4 m^2 to 2 m^2.

  const auto result = bore.carry(loads, move_them);

  EXPECT_EQ(result.lines[0].fate, receipt_fate::moved);
  EXPECT_EQ(result.lines[0].warning, "");
}

TEST(MovedLoads, WithoutASuccessorTheyAreDroppedAndThatIsSaid) {
  const filled_bore bore;
  load_case loads;
  loads.loads = {{{99}, force{{1, 0, 0}}}};

  const auto result = bore.carry(loads, move_them);

  EXPECT_TRUE(result.after.loads.empty());
  EXPECT_EQ(result.lines[0].fate, receipt_fate::dropped);
  EXPECT_THAT(result.lines[0].text, HasSubstr("surface 99 is gone and none took its place"));
}

TEST(DroppedLoads, APressureSaysHowItsTotalChanged) {
  const filled_bore bore;
  load_case loads;
  loads.loads = {{{7, 1}, pressure{2}}};

  const auto result = bore.carry(loads, {});

  EXPECT_EQ(result.lines[0].fate, receipt_fate::reduced);
  EXPECT_THAT(result.lines[0].text, HasSubstr("total changed from 14 to 6 N"));
  EXPECT_TRUE(result.lines[0].moved_to.empty());
}

TEST(RefusedLosses, NameCaseItemAndSurface) {
  const filled_bore bore;
  load_case loads;
  loads.name = "lifting";
  loads.constraints = {{{3, 7}, fixed{}}};
  loads.loads = {{{7}, force{{0, 0, -8}}}, {{1}, force{{1, 0, 0}}}};

  const auto refused = refuse_losses(bore.carry(loads, {load_policy::refuse}).lines);

  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::postcondition_failed);
  EXPECT_THAT(refused.error().message,
              HasSubstr("load case lifting: constraint 0 (fixed) acts on surface 7; load case "
                        "lifting: load 0 (force) acts on surface 7"));
  EXPECT_THAT(refused.error().message, Not(HasSubstr("load 1")));
  loads.constraints[0].surfaces = {3};
  loads.loads.erase(loads.loads.begin());
  EXPECT_TRUE(refuse_losses(bore.carry(loads, {load_policy::refuse}).lines).has_value());
}

}  // namespace
}  // namespace tedit::fem
