// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/calculix_deck.hpp"

#include <cmath>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/meshes.hpp"

namespace tedit::fem {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The unit tet; E = 2.5 Pa and nu = 0.25 (lambda = mu = 1), all nodes free, no load.
problem one_tet() {
  problem p;
  p.corner_count = 4;
  p.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  p.node_vertices = {0, 1, 2, 3};
  p.element_nodes = {0, 1, 2, 3};
  p.element_tets = {0};
  p.element_materials = {0};
  p.constants = {{1, 1}};
  p.densities = {0};
  p.yield_strengths = {0};
  p.loads.assign(12, 0);
  p.prescribed.assign(12, 0);
  p.filter.assign(4, {1, 0, 0, 1, 0, 1});
  return p;
}

std::string deck_of(const problem& p, const calculix_settings& settings = {}) {
  std::ostringstream out;
  write_calculix_deck(p, settings, out);
  return out.str();
}

/// The lines behind a keyword, up to the next one.
std::string block(const std::string& deck, const std::string& keyword) {
  const auto at = deck.find("\n" + keyword + "\n");
  if (at == std::string::npos)
    return {};
  const auto begin = at + keyword.size() + 2;
  return deck.substr(begin, deck.find('*', begin) - begin);
}

TEST(CalculixDeck, OneTetWordForWord) {
  auto p = one_tet();
  p.filter[0] = {0, 0, 0, 0, 0, 0};
  p.filter[1] = {0, 0, 0, 1, 0, 1};
  p.prescribed[3] = 0.001;
  p.loads[11] = -0.5;

  const auto deck = deck_of(p, {.title = "pull\non a tet"});

  EXPECT_EQ(deck,
            "** pull on a tet\n"
            "** Written by TEdit for CalculiX 2.20: ccx -i NAME, for this file as NAME.inp\n"
            "** Units: SI (m, N, Pa, kg).\n"
            "** 4 nodes, 1 linear tets (C3D4)\n"
            "** Results: NAME.dat has U of all nodes and RF of the held ones (set HELD), with the "
            "total.\n"
            "** RF is the reaction plus the load on the node.\n"
            "*NODE, NSET=NALL\n"
            "1, 0, 0, 0\n"
            "2, 1, 0, 0\n"
            "3, 0, 1, 0\n"
            "4, 0, 0, 1\n"
            "*NSET, NSET=HELD\n"
            "1,\n"
            "2,\n"
            "*ELEMENT, TYPE=C3D4, ELSET=MATERIAL-1\n"
            "1,1,2,3,4\n"
            "*MATERIAL, NAME=MATERIAL-1\n"
            "*ELASTIC\n"
            "2.5, 0.25\n"
            "*SOLID SECTION, ELSET=MATERIAL-1, MATERIAL=MATERIAL-1\n"
            "*STEP\n"
            "*STATIC, SOLVER=SPOOLES\n"
            "1., 1.\n"
            "*BOUNDARY\n"
            "1, 1, 1, 0\n"
            "1, 2, 2, 0\n"
            "1, 3, 3, 0\n"
            "2, 1, 1, 0.001\n"
            "*CLOAD\n"
            "4, 3, -0.5\n"
            "*NODE PRINT, NSET=NALL\n"
            "U\n"
            "*NODE PRINT, NSET=HELD, TOTALS=YES\n"
            "RF\n"
            "*NODE FILE\n"
            "U, RF\n"
            "*EL FILE\n"
            "S\n"
            "*END STEP\n");
}

TEST(CalculixDeck, AnObliqueRollerIsAnEquation) {
  auto p = one_tet();
  p.filter[2] = {0.5, -0.5, 0, 0.5, 0, 1};  // Held along (1, 1, 0).

  std::ostringstream out;
  const auto counts = write_calculix_deck(p, {}, out);

  EXPECT_EQ(block(out.str(), "*EQUATION"), "2\n3,1,1.,3,2,1\n");
  EXPECT_THAT(out.str(), Not(HasSubstr("*BOUNDARY")));
  EXPECT_EQ(counts.held_nodes, 1u);
  EXPECT_EQ(counts.equations, 1u);
  EXPECT_EQ(counts.boundaries, 0u);
}

TEST(CalculixDeck, TheLargestComponentIsTheDependentOne) {
  auto p = one_tet();
  // Held along (0.48, 0.6, 0.64): u_z + 0.75 u_x + 0.9375 u_y = 0.
  p.filter[0] = {1 - 0.2304, -0.288, -0.3072, 1 - 0.36, -0.384, 1 - 0.4096};

  std::istringstream row(block(deck_of(p), "*EQUATION"));

  int terms = 0;
  row >> terms;
  EXPECT_EQ(terms, 3);
  double node = 0;
  char comma = 0;
  for (const auto& [component, factor] : {std::pair{3, 1.0}, {1, 0.75}, {2, 0.9375}}) {
    int c = 0;
    double f = 0;
    row >> node >> comma >> c >> comma >> f >> comma;
    EXPECT_EQ(node, 1);
    EXPECT_EQ(c, component);
    EXPECT_NEAR(f, factor, 1e-14);
  }
}

TEST(CalculixDeck, AMovedObliqueDirectionTakesANodeOfItsOwn) {
  auto p = one_tet();
  p.filter[2] = {0.5, -0.5, 0, 0.5, 0, 1};
  p.prescribed[6] = p.prescribed[7] = 0.25;  // u_x + u_y = 0.5.

  const auto deck = deck_of(p);

  EXPECT_EQ(block(deck, "*NODE, NSET=OFFSETS"), "5, 0, 1, 0\n");
  EXPECT_EQ(block(deck, "*EQUATION"), "3\n3,1,1.,3,2,1,5,1,-1.\n");
  EXPECT_EQ(block(deck, "*BOUNDARY"), "5, 1, 1, 0.5\n");
}

TEST(CalculixDeck, TwoHeldDirectionsHaveTwoDependentComponents) {
  auto p = one_tet();
  // Only the motion along (1, 1, 0) is left: u_x = u_y, u_z = 0.
  p.filter[0] = {0.5, 0.5, 0, 0.5, 0, 0};
  // Only the motion along (1, 0, 0) is left: no equation at all.
  p.filter[1] = {1, 0, 0, 0, 0, 0};
  p.prescribed[4] = 2;

  const auto deck = deck_of(p);

  EXPECT_EQ(block(deck, "*EQUATION"), "2\n1,1,1.,1,2,-1\n");
  EXPECT_EQ(block(deck, "*BOUNDARY"), "1, 3, 3, 0\n2, 2, 2, 2\n2, 3, 3, 0\n");

  const double third = 1.0 / 3;
  p = one_tet();
  p.filter[3] = {third, third, third, third, third, third};  // u_x = u_y = u_z.
  std::ostringstream out;
  EXPECT_EQ(write_calculix_deck(p, {}, out).equations, 2u);
  EXPECT_THAT(block(out.str(), "*EQUATION"),
              ::testing::MatchesRegex("2\n4,1,1.,4,3,-[0-9.]+\n2\n4,2,1.,4,3,-[0-9.]+\n"));
}

TEST(CalculixDeck, NumbersFitIntoWhatCalculixReads) {
  auto p = one_tet();
  p.loads = {1.0 / 3, -1.0 / 3e5, 2.0 / 3e-11, -0.0, 1e300 / 3, -1e-300 / 3, 0, 0, 0, 0, 0, 0};

  std::istringstream rows(block(deck_of(p), "*CLOAD"));

  std::string line;
  std::vector<double> read;
  while (std::getline(rows, line)) {
    const auto text = line.substr(line.rfind(' ') + 1);
    EXPECT_LE(text.size(), 20u) << text;
    read.push_back(std::stod(text));
  }
  ASSERT_EQ(read.size(), 5u);
  EXPECT_EQ(read[0], 1.0 / 3);
  EXPECT_NEAR(read[1] / (-1.0 / 3e5), 1, 1e-13);
  EXPECT_NEAR(read[2] / (2.0 / 3e-11), 1, 1e-13);
  EXPECT_NEAR(read[3] / (1e300 / 3), 1, 1e-12);
  EXPECT_NEAR(read[4] / (-1e-300 / 3), 1, 1e-12);
}

TEST(CalculixDeck, QuadraticTetsHaveTheirMidNodesWhereC3D10WantsThem) {
  load_case loads;
  loads.materials = {{"steel", 210e9, 0.3, 7850, 0, {}}};
  loads.constraints = {{{1}, fixed{}}};
  loads.loads = {{{2}, force{{1, 0, 0}}}};
  const auto p = make_problem(*test::box_mesh({1, 1, 1}, {1, 1, 1}), loads, 2);
  ASSERT_TRUE(p.has_value());

  const auto deck = deck_of(*p, {.solver = calculix_solver::iterative_cholesky, .fields = false});

  EXPECT_THAT(deck, HasSubstr("*STATIC, SOLVER=ITERATIVE CHOLESKY\n"));
  EXPECT_THAT(deck, Not(HasSubstr("FILE")));
  EXPECT_EQ(block(deck, "*ELASTIC"), "210000000000, 0.3\n");
  EXPECT_EQ(block(deck, "*DENSITY"), "7850\n");
  std::istringstream rows(block(deck, "*ELEMENT, TYPE=C3D10, ELSET=MATERIAL-1"));
  std::string line;
  int elements = 0;
  for (; std::getline(rows, line); ++elements) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream numbers(line);
    std::array<std::size_t, 11> n{};
    for (auto& id : n)
      numbers >> id;
    // Abaqus: nodes 5 to 10 between 1-2, 2-3, 1-3, 1-4, 2-4, 3-4.
    constexpr std::array<std::array<int, 2>, 6> ends{
      {{1, 2}, {2, 3}, {1, 3}, {1, 4}, {2, 4}, {3, 4}}};
    for (int i = 0; i < 6; ++i) {
      const vec3 mid = 0.5 * (p->nodes[n[ends[i][0]] - 1] + p->nodes[n[ends[i][1]] - 1]);
      EXPECT_EQ(norm(p->nodes[n[5 + i] - 1] - mid), 0);
    }
  }
  EXPECT_EQ(elements, 6);
}

TEST(CalculixDeck, EachMaterialHasItsElements) {
  auto p = one_tet();
  p.nodes.push_back({1, 1, 1});
  p.node_vertices.push_back(4);
  p.corner_count = 5;
  p.element_nodes = {0, 1, 2, 3, 4, 2, 1, 3};
  p.element_tets = {0, 1};
  p.element_materials = {2, 0};
  p.constants = {{1, 1}, {9, 9}, {2, 1}};
  p.densities = {0, 0, 1000};
  p.loads.resize(15);
  p.prescribed.resize(15);
  p.filter.resize(5, {1, 0, 0, 1, 0, 1});

  const auto deck = deck_of(p);

  EXPECT_EQ(block(deck, "*ELEMENT, TYPE=C3D4, ELSET=MATERIAL-1"), "2,5,3,2,4\n");
  EXPECT_EQ(block(deck, "*ELEMENT, TYPE=C3D4, ELSET=MATERIAL-3"), "1,1,2,3,4\n");
  EXPECT_THAT(deck, Not(HasSubstr("MATERIAL-2"))) << "a material without elements has no section";
  EXPECT_EQ(block(deck, "*DENSITY"), "1000\n");
}

}  // namespace
}  // namespace tedit::fem
