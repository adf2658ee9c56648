// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/make_report.hpp"

#include <gtest/gtest.h>

namespace tedit {
namespace {

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
  result.max_von_mises_element = 1;
  EXPECT_EQ(made().max_von_mises_singularity, fem::singularity::clamp_rim);

  result.max_von_mises_element = 0;
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

TEST_F(MakeReport, OfSeveralCasesNamesTheWorst) {
  fem::case_set set{problem, {{"a", {}, {}, {}, {}}, {"b", {}, {}, {}, {}}}};
  fem::solved_cases solved{{result, result}, {}};
  solved.cases[0].converged = true;
  solved.cases[1].max_von_mises_pa = 9e6;
  solved.envelope.max_von_mises = {9e6, {1, 0, 0}, 1};
  solved.envelope.max_displacement = {1e-3, {2, 0, 0}, 0};

  const auto outcome = make_outcome(*mesh, set, solved, true, 80);

  ASSERT_EQ(outcome.cases.size(), 2u);
  EXPECT_EQ(outcome.cases[1].load_case, "b");
  EXPECT_EQ(outcome.cases[1].total_ms, 40);
  EXPECT_TRUE(outcome.cases[0].interim);
  EXPECT_FALSE(outcome.cases[0].preview);
  ASSERT_TRUE(outcome.envelope.has_value());
  EXPECT_TRUE(outcome.envelope->preview) << "b is one";
  EXPECT_TRUE(outcome.envelope->interim);
  EXPECT_EQ(outcome.envelope->load_cases, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(outcome.envelope->max_von_mises.load_case, "b");
  EXPECT_EQ(outcome.envelope->max_displacement.load_case, "a");
  EXPECT_FALSE(outcome.envelope->min_safety_factor.has_value());

  solved.cases.pop_back();
  set.cases.pop_back();
  EXPECT_FALSE(make_outcome(*mesh, set, solved, false, 80).envelope.has_value());
}

}  // namespace
}  // namespace tedit
