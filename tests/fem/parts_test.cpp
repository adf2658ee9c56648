// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "fem/solver.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"

namespace tedit::fem {
namespace {

const std::filesystem::path parts_folder = TEDIT_TEST_DATA "/parts";

class PartsAgainstCalculix : public ::testing::TestWithParam<const char*> {};

TEST_P(PartsAgainstCalculix, DisplacementComplianceAndReactionsAgree) {
  const auto folder = parts_folder / GetParam();
  const auto mesh = import_mesh(folder / (std::string(GetParam()) + ".coarse.msh"), "mm");
  const auto loads = protocol::load_case_from_file(folder / "load_case.json");
  std::ifstream in(folder / "reference.json");
  const auto reference = nlohmann::json::parse(in);
  ASSERT_TRUE(mesh.has_value());
  ASSERT_TRUE(loads.has_value());
  const auto problem = make_problem(*mesh->version, *loads);
  ASSERT_TRUE(problem.has_value()) << render(problem.error());

  const auto device = open_backend("cpu");
  const auto result = solve(*problem, **device, {}, {});

  ASSERT_TRUE(result.has_value()) << render(result.error());
  EXPECT_LE(result->true_relative_residual, 1e-6);
  const double displacement = reference["max_displacement_m"];
  const double compliance = reference["compliance_j"];
  const double stress = reference["max_element_von_mises_pa"];
  EXPECT_NEAR(result->max_displacement_m, displacement, 1e-6 * displacement);
  EXPECT_NEAR(result->compliance_j, compliance, 1e-6 * compliance);
  EXPECT_NEAR(result->max_von_mises_pa, stress, 1e-4 * stress);
  EXPECT_LE(norm(result->reaction_n + result->applied_n), 1e-6 * norm(result->applied_n));
}

INSTANTIATE_TEST_SUITE_P(Open, PartsAgainstCalculix,
                         ::testing::Values("as1_assembly", "bracket_4040", "ctc01_plate",
                                           "foot_cup", "fork_thin", "heatsink_125", "holes_block",
                                           "inch_block"));

TEST(BadElements, AreNamedAndRefused) {
  const auto folder = parts_folder / "base_so101";
  const auto mesh = import_mesh(folder / "base_so101.coarse.msh", "mm");
  const auto loads = protocol::load_case_from_file(folder / "load_case.json");

  const auto problem = make_problem(*mesh->version, *loads);

  ASSERT_FALSE(problem.has_value());
  EXPECT_EQ(problem.error().code, ec::degenerate_tet);
  EXPECT_THAT(problem.error().message, ::testing::HasSubstr("tet 19921"));
}

}  // namespace
}  // namespace tedit::fem
