// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/version.hpp"

namespace tedit::protocol {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

solve_report full_report() {
  solve_report report;
  report.version_id = std::string(32, 'a');
  report.element_order = 2;
  report.preview = false;
  report.strain_energy_j = 0.25;
  report.mass_kg = 12.5;
  report.relative_error_estimate = 0.08;
  report.min_safety_factor = 18.5;
  report.min_safety_factor_at = {1, 2, 3};
  report.surface_reactions = {{-7, "foot", {1, 2, 3}}, {72, "", {-4, 5, 0.5}}};
  report.singular_places = {{fem::singularity::clamp_rim, {1, 2, 3}, 5e6},
                            {fem::singularity::reentrant_edge, {4, 5, 6}, 3e6}};
  report.singular_places_count = 41;
  report.max_von_mises_singularity = fem::singularity::reentrant_edge;
  return report;
}

TEST(SolveReportJson, JudgementsSurviveTheRoundTrip) {
  const auto before = full_report();

  const auto after = solve_report_from_json(to_json(before));

  ASSERT_TRUE(after.has_value()) << render(after.error());
  EXPECT_EQ(after->strain_energy_j, 0.25);
  EXPECT_EQ(after->mass_kg, 12.5);
  EXPECT_EQ(after->relative_error_estimate, 0.08);
  EXPECT_EQ(after->min_safety_factor, 18.5);
  EXPECT_EQ(after->min_safety_factor_at, (vec3{1, 2, 3}));
  ASSERT_EQ(after->surface_reactions.size(), 2U);
  EXPECT_EQ(after->surface_reactions[0].surface, -7);
  EXPECT_EQ(after->surface_reactions[0].name, "foot");
  EXPECT_EQ(after->surface_reactions[1].force_n, (vec3{-4, 5, 0.5}));
  ASSERT_EQ(after->singular_places.size(), 2U);
  EXPECT_EQ(after->singular_places[0].kind, fem::singularity::clamp_rim);
  EXPECT_EQ(after->singular_places[1].kind, fem::singularity::reentrant_edge);
  EXPECT_EQ(after->singular_places[1].at, (vec3{4, 5, 6}));
  EXPECT_EQ(after->singular_places[1].von_mises_pa, 3e6);
  EXPECT_EQ(after->singular_places_count, 41U);
  EXPECT_EQ(after->max_von_mises_singularity, fem::singularity::reentrant_edge);
  EXPECT_EQ(to_json(before), to_json(*after));
}

TEST(SolveReportJson, WhatIsUnknownStaysUnknown) {
  auto before = full_report();
  before.mass_kg.reset();
  before.min_safety_factor.reset();
  before.max_von_mises_singularity.reset();

  const auto json = to_json(before);
  const auto after = solve_report_from_json(json);

  EXPECT_THAT(json, Not(HasSubstr("mass_kg")));
  EXPECT_THAT(json, Not(HasSubstr("min_safety_factor")));
  EXPECT_THAT(json, Not(HasSubstr("max_von_mises_singularity")));
  ASSERT_TRUE(after.has_value()) << render(after.error());
  EXPECT_FALSE(after->mass_kg.has_value());
  EXPECT_FALSE(after->min_safety_factor.has_value());
  EXPECT_FALSE(after->max_von_mises_singularity.has_value());
}

TEST(SolveReportJson, AMassOfZeroIsKnown) {
  auto before = full_report();
  before.mass_kg = 0;

  const auto after = solve_report_from_json(to_json(before));

  ASSERT_TRUE(after.has_value()) << render(after.error());
  EXPECT_EQ(after->mass_kg, 0.0);
}

class MakeReport : public ::testing::Test {
protected:
  fem::problem problem;
  fem::solution result;
  version_ptr mesh = mesh_version::create({});

  MakeReport() {
    result.element_order = problem.element_order = 2;
    for (std::uint32_t i = 0; i < 30; ++i)
      result.singular_places.push_back(
        {i, fem::singularity::clamp_rim, {0.1 * i, 0, 0}, 1e6 * (30 - i)});
  }

  [[nodiscard]] solve_report made() const { return make_report(*mesh, "a", problem, result); }
};

TEST_F(MakeReport, KeepsTheWorstTwentySingularPlacesAndCountsAll) {
  const auto report = made();

  ASSERT_EQ(report.singular_places.size(), 20U);
  EXPECT_EQ(report.singular_places.front().von_mises_pa, 30e6);
  EXPECT_EQ(report.singular_places_count, 30U);
}

TEST_F(MakeReport, SaysWhenTheLargestNodalStressIsSingular) {
  result.max_von_mises_at = result.singular_places[3].at;
  EXPECT_EQ(made().max_von_mises_singularity, fem::singularity::clamp_rim);

  result.max_von_mises_at = {0, 1, 0};
  EXPECT_FALSE(made().max_von_mises_singularity.has_value());
}

TEST_F(MakeReport, SaysWhenTheLargestElementTouchesASingularNode) {
  result.element_order = problem.element_order = 1;
  problem.element_nodes = {40, 41, 42, 43, 50, 51, 7, 53};
  result.element_von_mises = {1e6, 2e6};
  EXPECT_EQ(made().max_von_mises_singularity, fem::singularity::clamp_rim);

  result.element_von_mises = {3e6, 2e6};
  EXPECT_FALSE(made().max_von_mises_singularity.has_value());
}

TEST_F(MakeReport, LeavesOutWhatTheMaterialsDoNotSay) {
  EXPECT_FALSE(made().mass_kg.has_value());
  EXPECT_FALSE(made().min_safety_factor.has_value());

  result.mass_known = true;
  result.mass_kg = 2;
  result.safety_factor = {4};
  result.min_safety_factor = 4;
  EXPECT_EQ(made().mass_kg, 2.0);
  EXPECT_EQ(made().min_safety_factor, 4.0);
}

}  // namespace
}  // namespace tedit::protocol
