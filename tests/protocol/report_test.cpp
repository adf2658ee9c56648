// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/forms.hpp"
#include "protocol/load_policy_message.hpp"
#include "tedit/v1/report.pb.h"

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

std::string to_json(const solve_report& report) {
  return protocol::to_json(solve_outcome{{report}, {}});
}

expected<solve_report> solve_report_from_json(const std::string& json) {
  return from_json<solve_outcome>(json).map([](const solve_outcome& outcome) {
    EXPECT_EQ(outcome.cases.size(), 1u);
    EXPECT_FALSE(outcome.envelope.has_value());
    return outcome.cases.front();
  });
}

TEST(EditReportJson, FiguresSurviveTheRoundTrip) {
  edit_report before;
  before.figures = {{"pieces", 1, "", "pieces of the body"},
                    {"thickness_change_mm", 0.125, "mm", "thickness taken off"}};

  const auto after = from_json<edit_report>(protocol::to_json(before));

  ASSERT_TRUE(after.has_value()) << render(after.error());
  EXPECT_EQ(after->figures, before.figures);
}

TEST(EditReportJson, RatiosAreAbsentWhereNoTetWasTouched) {
  edit_report none;
  edit_report flat;
  flat.ratios = {0.5, 0, 0.75};  // A flat tet has the ratio 0, and that is said.

  const auto without = from_json<edit_report>(protocol::to_json(none));
  const auto with = from_json<edit_report>(protocol::to_json(flat));

  EXPECT_THAT(protocol::to_json(none), Not(HasSubstr("touched_m")));
  EXPECT_EQ(without->ratios, std::nullopt);
  EXPECT_EQ(with->ratios, flat.ratios);
}

TEST(SolveReportJson, WarningsSurviveTheRoundTrip) {
  auto before = full_report();
  before.warnings = {"look at the support", "look at the load"};

  EXPECT_EQ(solve_report_from_json(to_json(before))->warnings, before.warnings);
}

TEST(EditReportJson, TheCompletedSelectionSurvivesTheRoundTrip) {
  edit_report before;
  before.surfaces = {15};
  before.surfaces_used = {15, -91};

  const auto after = from_json<edit_report>(protocol::to_json(before));

  ASSERT_TRUE(after.has_value()) << render(after.error());
  EXPECT_EQ(after->surfaces, before.surfaces);
  EXPECT_EQ(after->surfaces_used, before.surfaces_used);
}

TEST(EditReportJson, WhatBecameOfLoadsSurvivesTheRoundTrip) {
  edit_report before;
  before.loads = {fem::load_policy::move, true};
  fem::receipt_line line{"bend", "load 1 (force)", fem::receipt_fate::moved, {7}, 4, 2, "moved"};
  line.moved_to = {25, 26};
  line.total_before = 8;
  line.total_after = 6;
  before.receipt = {line};

  const auto after = from_json<edit_report>(protocol::to_json(before));

  ASSERT_TRUE(after.has_value()) << render(after.error());
  EXPECT_EQ(after->loads, before.loads);
  ASSERT_EQ(after->receipt.size(), 1u);
  EXPECT_EQ(after->receipt[0].fate, fem::receipt_fate::moved);
  EXPECT_EQ(after->receipt[0].moved_to, line.moved_to);
  EXPECT_EQ(after->receipt[0].total_before, 8);
  EXPECT_EQ(after->receipt[0].total_after, 6);
}

TEST(EditReportJson, OfAnOlderProgramDropsLoads) {
  const auto after = from_json<edit_report>("{}");

  ASSERT_TRUE(after.has_value()) << render(after.error());
  EXPECT_EQ(after->loads, fem::carry_settings{});
}

TEST(LoadPolicyMessage, AKindThatIsNotKnownIsRefused) {
  v1::LoadPolicy message;
  EXPECT_EQ(protocol::from_message(message).value().policy, fem::load_policy::drop);
  message.set_kind(static_cast<v1::LoadPolicy::Kind>(9));

  const auto refused = protocol::from_message(message);

  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::invalid_argument);
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

TEST(SolveOutcomeJson, SeveralCasesAndTheirEnvelopeSurviveTheRoundTrip) {
  auto other = full_report();
  other.load_case = "braking";
  solve_outcome before{{full_report(), other}, solve_envelope{}};
  auto& worst = *before.envelope;
  worst.version_id = other.version_id;
  worst.load_cases = {"", "braking"};
  worst.element_order = 2;
  worst.preview = false;
  worst.interim = true;
  worst.max_von_mises = {5e6, {1, 2, 3}, "braking"};
  worst.max_displacement = {1e-3, {4, 5, 6}, ""};
  worst.min_safety_factor = {1.5, {7, 8, 9}, "braking"};

  const auto after = from_json<solve_outcome>(protocol::to_json(before));

  ASSERT_TRUE(after.has_value()) << render(after.error());
  ASSERT_EQ(after->cases.size(), 2u);
  EXPECT_EQ(after->cases[1].load_case, "braking");
  EXPECT_EQ(to_json(after->cases[1]), to_json(other));
  ASSERT_TRUE(after->envelope.has_value());
  EXPECT_EQ(after->envelope->version_id, worst.version_id);
  EXPECT_EQ(after->envelope->load_cases, worst.load_cases);
  EXPECT_FALSE(after->envelope->preview);
  EXPECT_TRUE(after->envelope->interim);
  EXPECT_EQ(after->envelope->max_von_mises.value, 5e6);
  EXPECT_EQ(after->envelope->max_von_mises.at, (vec3{1, 2, 3}));
  EXPECT_EQ(after->envelope->max_displacement.value, 1e-3);
  EXPECT_EQ(after->envelope->max_displacement.load_case, "");
  ASSERT_TRUE(after->envelope->min_safety_factor.has_value());
  EXPECT_EQ(after->envelope->min_safety_factor->load_case, "braking");

  before.envelope->min_safety_factor.reset();
  EXPECT_FALSE(
    from_json<solve_outcome>(protocol::to_json(before))->envelope->min_safety_factor.has_value());
}

}  // namespace
}  // namespace tedit::protocol
