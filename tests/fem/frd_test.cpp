// SPDX-License-Identifier: AGPL-3.0-or-later
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fem/frd_writer.hpp"
#include "fem/nastran_deck.hpp"

namespace tedit::fem {
namespace {

/// The unit tet; E = 2.5 Pa and nu = 0.25 (lambda = mu = 1), nodes 1 and 2 held along an axis.
problem unit_tet() {
  problem p;
  p.corner_count = 4;
  p.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  p.node_vertices = {0, 1, 2, 3};
  p.element_nodes = {0, 1, 2, 3};
  p.element_tets = {0};
  p.element_materials = {0};
  p.constants = {{1, 1}};
  p.densities = {7850};
  p.yield_strengths = {0};
  p.loads.assign(12, 0);
  p.prescribed.assign(12, 0);
  p.filter.assign(4, {1, 0, 0, 1, 0, 1});
  return p;
}

// The lines of CalculiX 2.20 for the same tet with E = 1000, pulled at its top: all but the header.
TEST(Frd, OneTetAsCalculixWritesIt) {
  solution s;
  s.displacement = {0, 0, 0, -1.8e-3, 0, 0, 0, -1.8e-3, 0, 0, 0, 6e-3};
  for (int n = 0; n < 4; ++n)
    s.nodal_stress.insert(s.nodal_stress.end(), {0, 0, 6, 0, 0, 0});
  std::ostringstream out;

  write_frd(unit_tet(), {&s}, {"pull"}, out);

  const auto text = out.str();
  EXPECT_EQ(
    text.substr(text.find("    2C")),
    "    2C                             4                                     1\n"
    " -1         1 0.00000E+00 0.00000E+00 0.00000E+00\n"
    " -1         2 1.00000E+00 0.00000E+00 0.00000E+00\n"
    " -1         3 0.00000E+00 1.00000E+00 0.00000E+00\n"
    " -1         4 0.00000E+00 0.00000E+00 1.00000E+00\n"
    " -3\n"
    "    3C                             1                                     1\n"
    " -1         1    3    0    1\n"
    " -2         1         2         3         4\n"
    " -3\n"
    "    1PSTEP                         1           1           1\n"
    "  100CL  101 1.000000000           4                     0    1           1\n"
    " -4  DISP        4    1\n"
    " -5  D1          1    2    1    0\n"
    " -5  D2          1    2    2    0\n"
    " -5  D3          1    2    3    0\n"
    " -5  ALL         1    2    0    0    1ALL\n"
    " -1         1 0.00000E+00 0.00000E+00 0.00000E+00\n"
    " -1         2-1.80000E-03 0.00000E+00 0.00000E+00\n"
    " -1         3 0.00000E+00-1.80000E-03 0.00000E+00\n"
    " -1         4 0.00000E+00 0.00000E+00 6.00000E-03\n"
    " -3\n"
    "    1PSTEP                         1           1           1\n"
    "  100CL  101 1.000000000           4                     0    1           1\n"
    " -4  STRESS      6    1\n"
    " -5  SXX         1    4    1    1\n"
    " -5  SYY         1    4    2    2\n"
    " -5  SZZ         1    4    3    3\n"
    " -5  SXY         1    4    1    2\n"
    " -5  SYZ         1    4    2    3\n"
    " -5  SZX         1    4    3    1\n"
    " -1         1 0.00000E+00 0.00000E+00 6.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00\n"
    " -1         2 0.00000E+00 0.00000E+00 6.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00\n"
    " -1         3 0.00000E+00 0.00000E+00 6.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00\n"
    " -1         4 0.00000E+00 0.00000E+00 6.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00\n"
    " -3\n"
    " 9999\n");
}

TEST(NastranDeck, OneTetWordForWord) {
  auto p = unit_tet();
  p.filter[0] = {0, 0, 0, 1, 0, 1};
  p.filter[1] = {0.64, -0.48, 0, 0.36, 0, 1};  // Held along (0.6, 0.8, 0).
  p.prescribed[0] = 0.001;
  p.loads[11] = -0.5;
  std::ostringstream out;

  const auto counts = write_nastran_deck(p, {.title = "pull\non a tet"}, out);

  ASSERT_TRUE(counts.has_value());
  EXPECT_EQ(counts->equations, 1U);
  const auto text = out.str();
  EXPECT_THAT(text, ::testing::HasSubstr("GRID*   4 "));
  EXPECT_THAT(text, ::testing::Not(::testing::HasSubstr("GRID*   5 ")));
  EXPECT_THAT(text, ::testing::HasSubstr("TITLE = pull on a tet\nSPC = 1\nMPC = 2\nLOAD = 3\n"));
  EXPECT_THAT(text,
              ::testing::HasSubstr("CTETRA  1       1       1       2       3       4       \n"));
  EXPECT_THAT(text, ::testing::HasSubstr("MAT1*   1               2.5                             "
                                         "0.25            \n*       7850.           \n"));
  EXPECT_THAT(text,
              ::testing::HasSubstr(
                "SPC*    1               1               1               0.001           \n"));
  EXPECT_THAT(text, ::testing::HasSubstr(
                      "MPC*    2               2               2               1.              \n"
                      "*       2               1               0.75            \n"));
  EXPECT_THAT(text, ::testing::HasSubstr(
                      "FORCE*  3               4                               1.              \n"
                      "*       0.              0.              -0.5            \n"));
}

}  // namespace
}  // namespace tedit::fem
