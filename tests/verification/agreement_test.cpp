// SPDX-License-Identifier: AGPL-3.0-or-later
// How far two solutions agree, with numbers that can be checked by hand.
#include "verification/agreement.hpp"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fem/native/backend.hpp"
#include "fem/recovery.hpp"
#include "verification/cases.hpp"
#include "verification/meshes.hpp"

namespace tedit::verification {
namespace {

using ::testing::HasSubstr;

TEST(CalculixStress, StandsInItsResultsByNode) {
  std::istringstream frd(
    " -4  DISP        4    1\n"
    " -1         1 9.00000E+00 9.00000E+00 9.00000E+00\n"
    " -3\n"
    " -4  STRESS      6    1\n"
    " -5  SXX         1    4    1    1\n"
    " -1         1 1.00000E+00-2.00000E+00 3.00000E-05-4.00000E+10 5.00000E+00 6.00000E+00\n"
    " -1         2 0.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00-1.50000E+06\n"
    " -1         3 7.00000E+00 7.00000E+00 7.00000E+00 7.00000E+00 7.00000E+00 7.00000E+00\n"
    " -3\n"
    " -4  ERROR       1    1\n"
    " -1         1 8.00000E+00\n");

  const auto stress = read_calculix_stress(frd, 2);

  ASSERT_TRUE(stress.has_value()) << render(stress.error());
  EXPECT_EQ(*stress, (std::vector<double>{1, -2, 3e-5, -4e10, 5, 6, 0, 0, 0, 0, 0, -1.5e6}));
}

TEST(CalculixStress, ANodeWithoutANumberIsNamed) {
  std::istringstream frd(
    " -4  STRESS      6    1\n"
    " -1         1 1.00000E+00-2.00000E+00 3.00000E-05-4.00000E+10 5.00000E+00 6.00000E+00\n"
    " -1         2         NaN         NaN         NaN         NaN         NaN         NaN\n");

  const auto stress = read_calculix_stress(frd, 2);

  ASSERT_FALSE(stress.has_value());
  EXPECT_EQ(stress.error().code, ec::bad_input);
  EXPECT_THAT(stress.error().message, HasSubstr("node 2"));
}

/// A block that is pulled along x and held at its other end.
struct solved_block {
  fem::problem problem;
  fem::solution ours;
  calculix_solution theirs;  ///< The same, as if CalculiX had said it.
};

solved_block pulled(int order) {
  const auto mesh = *block_mesh({3, 2, 2}, box({3, 1, 1}));
  auto loads = with_material(200e9, 0.3);
  loads.constraints = {{{s_low}, fem::fixed{}}};
  loads.loads = {{{s_high}, fem::force{{1000, 300, 0}}}};
  solved_block b{*fem::make_problem(*mesh, loads, order), {}, {}};
  b.ours = *fem::solve(b.problem, *fem::make_native_backend(), {.tolerance = 1e-11}, {});
  b.theirs.displacement = b.ours.displacement;
  b.theirs.reactions = b.ours.reactions;
  const auto plain = plain_nodal_stress(b.problem, b.ours.displacement);
  b.theirs.stress.resize(6 * b.problem.node_count());
  std::ranges::copy(plain, b.theirs.stress.begin());
  return b;
}

TEST(Agreement, OfEqualSolutionsIsPerfect) {
  const auto b = pulled(2);

  const auto result = compare_solutions(b.problem, b.ours, b.theirs);
  const auto stress = compare_stress(b.problem, b.ours, b.theirs);

  EXPECT_EQ(result.displacement, 0);
  EXPECT_LE(result.reaction, 1e-15);
  EXPECT_LE(result.surface_reaction, 1e-15);
  EXPECT_LE(result.compliance, 1e-12);
  EXPECT_EQ(stress.same_means, 0);
  EXPECT_GT(stress.own_means, 0) << "the elements around a node are of several volumes";
  EXPECT_GT(stress.most_ours_pa, 1000);
}

TEST(Agreement, OneNodeThatDiffersIsSeen) {
  auto b = pulled(2);
  std::size_t last = 0;  // A free node that moves most, so that the scale stays.
  for (std::size_t i = 0; i < b.ours.displacement.size(); ++i)
    if (std::abs(b.ours.displacement[i]) > std::abs(b.ours.displacement[last]))
      last = i;
  b.theirs.displacement[last] *= 1.001;
  for (std::size_t i = 0; i < 6; ++i)
    b.theirs.stress[i] *= 1.01;  // Of node 0.

  const auto result = compare_solutions(b.problem, b.ours, b.theirs);
  const auto stress = compare_stress(b.problem, b.ours, b.theirs);

  EXPECT_NEAR(result.displacement, 1e-3, 2e-4);
  EXPECT_GT(stress.same_means, 0);
  EXPECT_LE(stress.same_means, 0.01);
}

TEST(Agreement, AReactionThatIsMissingIsSeen) {
  auto b = pulled(1);
  for (auto& r : b.theirs.reactions)
    r *= 0.5;

  const auto result = compare_solutions(b.problem, b.ours, b.theirs);

  // Half of it is missing, over the half that is there.
  EXPECT_NEAR(result.reaction, 1, 1e-9);
  EXPECT_NEAR(result.surface_reaction, 1, 1e-9);
}

TEST(PlainStress, IsTheMeanOfTheElementsAroundWhateverTheirVolume) {
  const auto b = pulled(1);
  const auto plain = plain_nodal_stress(b.problem, b.ours.displacement);
  double sum = 0;
  int count = 0;
  for (std::size_t e = 0; e < b.problem.element_count(); ++e)
    for (std::size_t k = 0; k < 4; ++k)
      if (b.problem.element_nodes[4 * e + k] == 0) {
        sum += fem::corner_stress(b.problem, b.ours.displacement, e)[k][0];
        ++count;
      }

  ASSERT_GT(count, 0);
  EXPECT_DOUBLE_EQ(plain[0], sum / count);
}

}  // namespace
}  // namespace tedit::verification
