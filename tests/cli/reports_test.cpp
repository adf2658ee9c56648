// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/reports.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tedit::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A solve as the solver would tell it, with the rounding that real ones have.
solve_report plate() {
  solve_report report;
  report.device = "cpu";
  report.element_order = 2;
  report.preview = false;
  report.dofs = 93303;
  report.iterations = 24;
  report.true_relative_residual = 6.1e-7;
  report.max_displacement_m = 4.690652e-5;
  report.max_displacement_at = {0.1, -0.02, 3e-17};
  report.compliance_j = 0.5;
  report.strain_energy_j = 0.25;
  report.max_von_mises_pa = 14.8387e6;
  report.max_von_mises_at = {0.35, 0.12, 0.04};
  report.mass_kg = 39.645103;
  report.relative_error_estimate = 0.0812;
  report.min_safety_factor = 18.6;
  report.min_safety_factor_at = report.max_von_mises_at;
  report.reaction_n = {-8.0885e-6, 2.88514e-6, 19999.99999};
  report.applied_n = {0, -0.0, -20000};
  report.surface_reactions = {{72, "", {-1234.56, 2e-7, 12000}}, {-9, "foot", {1234.56, 0, 8000}}};
  return report;
}

TEST(DescribeSolve, SaysEverythingInReadableNumbers) {
  EXPECT_EQ(describe(plate()),
            "  device            cpu\n"
            "  unknowns          93303 (quadratic tets)\n"
            "  iterations        24\n"
            "  residual          6.1e-07 (true, relative)\n"
            "  max displacement  0.0469065 mm at (100, -20, 0) mm\n"
            "  max von Mises     14.839 MPa at (350, 120, 40) mm (node)\n"
            "  safety factor     18.6 at (350, 120, 40) mm\n"
            "  error estimate    8.1 % (energy norm)\n"
            "  compliance        0.5 J\n"
            "  strain energy     0.25 J\n"
            "  mass              39.65 kg\n"
            "  reaction          0, 0, 20000 N\n"
            "  applied           0, 0, -20000 N\n");
  EXPECT_EQ(remarks(plate()),
            "  reaction of surface      x N  y N    z N\n"
            "  ----------------------------------------\n"
            "  72                   -1234.6    0  12000\n"
            "  -9 foot               1234.6    0   8000\n");
}

TEST(DescribeSolve, LinearTetsNameTheElement) {
  auto report = plate();
  report.element_order = 1;

  EXPECT_THAT(describe(report), HasSubstr("(linear tets)\n"));
  EXPECT_THAT(describe(report), HasSubstr("MPa at (350, 120, 40) mm (element)\n"));
  EXPECT_THAT(describe(report), HasSubstr("18.6 at (350, 120, 40) mm (nodal means)\n"));
}

TEST(DescribeSolve, UnknownValuesAndSingleReactionsHaveNoLine) {
  auto report = plate();
  report.mass_kg.reset();
  report.min_safety_factor.reset();
  report.surface_reactions.resize(1);

  EXPECT_THAT(describe(report), Not(HasSubstr("mass")));
  EXPECT_THAT(describe(report), Not(HasSubstr("safety")));
  EXPECT_EQ(remarks(report), "");
}

TEST(DescribeSolve, AnUnstressedPartIsNotMeasuredOut) {
  auto report = plate();
  report.min_safety_factor = 1e6;

  EXPECT_THAT(describe(report), HasSubstr("  safety factor     over 1e+06\n"));
}

TEST(DescribeSolve, WarnsWhenTheLargestStressIsSingular) {
  auto report = plate();
  report.singular_places = {{fem::singularity::clamp_rim, {1, 2, 3}, 14.8387e6}};
  report.singular_places_count = 1;
  report.max_von_mises_singularity = fem::singularity::clamp_rim;
  EXPECT_THAT(describe(report),
              HasSubstr("  singular places   1 node at clamps' rims or re-entrant edges\n"));
  EXPECT_THAT(remarks(report),
              HasSubstr("  WARNING: the largest stress is at a clamp's rim, where it grows with "
                        "every refinement: do not read it as strength\n"));

  report.singular_places[0].at = report.min_safety_factor_at;
  report.max_von_mises_singularity = fem::singularity::reentrant_edge;
  EXPECT_THAT(
    remarks(report),
    HasSubstr("  WARNING: the largest stress is at a re-entrant edge, where it grows with "
              "every refinement: do not read it, nor the safety factor there, as "
              "strength\n"));
}

TEST(SummarizeSolve, KeepsWhatSaysHowStrongThePartIs) {
  EXPECT_EQ(summarize(plate()),
            "  safety factor     18.6 at (350, 120, 40) mm\n"
            "  error estimate    8.1 % (energy norm)\n"
            "  mass              39.65 kg\n");
}

TEST(DescribeEdit, LinesOfSeveralLoadCasesNameTheirs) {
  edit_report report;
  report.receipt = {{"bend", "constraint 0 (fixed)", {}, {}, 1, 1, "constraint 0 is as before"},
                    {"push", "constraint 0 (fixed)", {}, {}, 1, 1, "constraint 0 is as before"}};

  EXPECT_THAT(describe(report), HasSubstr("bend: constraint 0 is as before\n"));
  EXPECT_THAT(describe(report), HasSubstr("push: constraint 0 is as before\n"));

  report.receipt.pop_back();
  EXPECT_THAT(describe(report), Not(HasSubstr("bend")));
}

TEST(Edit, RatiosAreLeftOutWhereNoTetWasTouched) {
  edit_report report;
  EXPECT_THAT(describe(report), Not(HasSubstr("radius ratio")));
  EXPECT_FALSE(to_json(report).contains("radius_ratio_touched"));

  report.ratios = {1, 0.25, 0.5};

  EXPECT_THAT(describe(report), HasSubstr("worst touched 0.25 (before 1), median 0.5"));
  EXPECT_EQ(to_json(report)["radius_ratio_touched"]["after_min"], 0.25);
}

TEST(Edit, WarningsOfTheReceiptAreShown) {
  edit_report report;
  report.receipt.push_back({.load_case = "static", .text = "moved", .warning = "it grew"});
  report.receipt.push_back({.load_case = "static", .text = "as before"});

  EXPECT_THAT(describe(report), HasSubstr("WARNING           it grew\n"));
  EXPECT_EQ(to_json(report)["receipt"][0]["warning"], "it grew");
  EXPECT_FALSE(to_json(report)["receipt"][1].contains("warning"));
}

TEST(DescribeSolve, WarningsAboutLoadsStandWithThoseAboutStress) {
  auto report = plate();
  report.warnings = {"an edit moved a support"};
  report.notice = "the device was lost";
  solve_outcome several{{report, plate()}, solve_envelope{}};

  for (const auto& text : {remarks(report), summarize(report), summarize(several)}) {
    EXPECT_THAT(text, HasSubstr("  WARNING: an edit moved a support\n"));
    EXPECT_THAT(text, HasSubstr("  NOTE: the device was lost\n"));
  }
  EXPECT_EQ(to_json(report)["warnings"][0], "an edit moved a support");
  EXPECT_FALSE(to_json(plate()).contains("warnings"));
}

TEST(DescribeEdit, NamesTheSelectionWhereTheOperationCompletedIt) {
  edit_report report;
  report.surfaces = {15, 91};
  report.surfaces_used = {91, 15};
  EXPECT_THAT(describe(report), Not(HasSubstr("surfaces used")));

  report.surfaces_used.push_back(-3);

  EXPECT_THAT(describe(report), HasSubstr("surfaces used     -3, 15, 91\n"));
  EXPECT_EQ(to_json(report)["surfaces_used"].dump(), "[91,15,-3]");
}

TEST(EditJson, FiguresAreKeysOfTheirOwn) {
  edit_report report;
  report.figures = {{"pieces", 1, "", "pieces of the body"},
                    {"thickness_change_mm", 0.5, "mm", "thickness taken off"},
                    {"tets_added", 99, "", "no key of the report is replaced"}};
  const auto json = to_json(report);

  EXPECT_EQ(json["pieces"].dump(), "1");
  EXPECT_EQ(json["thickness_change_mm"], 0.5);
  EXPECT_EQ(json["tets_added"], 0);
  EXPECT_THAT(describe(report), HasSubstr("thickness taken off"));
  EXPECT_THAT(describe(report), HasSubstr("0.5 mm\n"));
}

TEST(SolveJson, NumbersAreAsComputed) {
  const auto json = to_json(plate());

  EXPECT_EQ(json["reaction_n"][0], -8.0885e-6);
  EXPECT_EQ(json["surface_reactions"][0]["force_n"][1], 2e-7);
  EXPECT_EQ(json["surface_reactions"][1]["surface"], -9);
  EXPECT_EQ(json["surface_reactions"][1]["name"], "foot");
  EXPECT_EQ(json["mass_kg"], 39.645103);
  EXPECT_EQ(json["min_safety_factor_at_m"], nlohmann::json({0.35, 0.12, 0.04}));
  EXPECT_EQ(json["singular_places"], nlohmann::json::array());
}

TEST(SolveJson, SingularPlacesNameTheirKind) {
  auto report = plate();
  report.singular_places = {{fem::singularity::reentrant_edge, {1, 2, 3}, 5e6}};
  report.singular_places_count = 7;
  report.max_von_mises_singularity = fem::singularity::reentrant_edge;
  const auto json = to_json(report);

  EXPECT_EQ(json["singular_places"][0]["kind"], "reentrant_edge");
  EXPECT_EQ(json["singular_places"][0]["at_m"], nlohmann::json({1, 2, 3}));
  EXPECT_EQ(json["singular_places"][0]["von_mises_pa"], 5e6);
  EXPECT_EQ(json["singular_places_count"], 7);
  EXPECT_EQ(json["max_von_mises_singularity"], "reentrant_edge");
}

TEST(SolveJson, UnknownValuesHaveNoKey) {
  auto report = plate();
  report.mass_kg.reset();
  report.min_safety_factor.reset();
  const auto json = to_json(report);

  for (const auto* key :
       {"mass_kg", "min_safety_factor", "min_safety_factor_at_m", "max_von_mises_singularity"})
    EXPECT_FALSE(json.contains(key)) << key;
}

TEST(ReadableNumbers, NoiseIsZeroAndTheRestIsKept) {
  EXPECT_EQ(without_noise(-8.0885e-6, 20000, 6), "0");
  EXPECT_EQ(without_noise(0.3, 20000, 6), "0.3");
  EXPECT_EQ(without_noise(-0.0, 0, 6), "0");
  EXPECT_EQ(components({1e-9, -2.5, 1234.5678}, 5, 1234.5678), "0, -2.5, 1234.6");
}

TEST(DescribeCases, HasARowForEachAndTheWorstOfAll) {
  auto soft = plate();
  soft.load_case = "lifting";
  auto hard = plate();
  hard.load_case = "braking";
  hard.iterations = 31;
  hard.max_displacement_m = 1e-4;
  hard.max_von_mises_pa = 55.5e6;
  hard.min_safety_factor = 4.5;
  hard.max_von_mises_singularity = fem::singularity::clamp_rim;
  solve_outcome outcome{{soft, hard}, solve_envelope{}};
  outcome.envelope->element_order = 2;
  outcome.envelope->preview = false;
  outcome.envelope->max_displacement = {1e-4, {0.1, 0, 0}, "braking"};
  outcome.envelope->max_von_mises = {55.5e6, {0.35, 0.12, 0.04}, "braking"};
  outcome.envelope->min_safety_factor = {4.5, {0.35, 0.12, 0.04}, "braking"};

  EXPECT_EQ(preview_text(outcome), "");
  EXPECT_EQ(
    describe(outcome),
    "  device            cpu\n"
    "  unknowns          93303 (quadratic tets)\n"
    "  load case  iterations  max displacement mm  max von Mises MPa  safety factor  error %\n"
    "  -------------------------------------------------------------------------------------\n"
    "  lifting            24            0.0469065             14.839           18.6      8.1\n"
    "  braking            31                  0.1               55.5            4.5      8.1\n"
    "  worst of all load cases:\n"
    "  max displacement  0.1 mm at (100, 0, 0) mm in braking\n"
    "  max von Mises     55.5 MPa at (350, 120, 40) mm in braking (node)\n"
    "  safety factor     4.5 at (350, 120, 40) mm in braking\n"
    "  braking:\n"
    "  WARNING: the largest stress is at a clamp's rim, where it grows with every refinement: do "
    "not read it as strength\n");
}

TEST(JsonOfCases, HasCasesAndEnvelope) {
  auto one = plate();
  one.load_case = "lifting";
  one.min_safety_factor.reset();
  auto other = one;
  other.load_case = "braking";
  solve_outcome outcome{{one, other}, solve_envelope{}};
  outcome.envelope->max_displacement = {1e-4, {0.1, 0, 0}, "braking"};
  outcome.envelope->max_von_mises = {55.5e6, {0.35, 0.12, 0.04}, "lifting"};

  const auto json = to_json(outcome);

  ASSERT_EQ(json["cases"].size(), 2u);
  EXPECT_EQ(json["cases"][1]["load_case"], "braking");
  EXPECT_FALSE(json["cases"][0].contains("timings_ms"));
  EXPECT_EQ(json["envelope"]["max_von_mises_pa"], 55.5e6);
  EXPECT_EQ(json["envelope"]["max_von_mises_case"], "lifting");
  EXPECT_EQ(json["envelope"]["max_displacement_case"], "braking");
  EXPECT_EQ(json["envelope"]["max_displacement_at_m"], nlohmann::ordered_json({0.1, 0, 0}));
  // No yield strength, no safety factor.
  EXPECT_FALSE(json["envelope"].contains("min_safety_factor"));
}

TEST(OneCase, IsShownAsItAlwaysWas) {
  const solve_outcome outcome{{plate()}, {}};

  EXPECT_EQ(to_json(outcome), to_json(plate()));
  EXPECT_EQ(describe(outcome), describe(plate()));
  EXPECT_EQ(summarize(outcome), summarize(plate()));
}

TEST(PreviewText, SaysWhyTheNumbersAreNotFinal) {
  solve_outcome outcome{{plate()}, {}};
  EXPECT_EQ(preview_text(outcome), "");
  outcome.cases[0].preview = true;
  EXPECT_THAT(preview_text(outcome), HasSubstr("stopped at the energy tolerance"));
  outcome.cases[0].element_order = 1;
  EXPECT_THAT(preview_text(outcome), HasSubstr("too stiff in bending"));
}

}  // namespace
}  // namespace tedit::cli
