// SPDX-License-Identifier: AGPL-3.0-or-later
// Decks as others write them, word for word.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/io/formats.hpp"
#include "mesh/io/import.hpp"
#include "mesh/io/number_sets.hpp"

namespace tedit {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

expected<imported_mesh> read(const std::string& text) {
  return import_mesh_bytes(std::span(text.data(), text.size()), "mm");
}

/// A cube's corner tet and its neighbour over the face 2-3-4.
const std::string inp_nodes =
  "*Heading\nTwo tets\n*Node, nset=Nall\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n5, 1, 1, "
  "1\n";
const std::string inp_tets = "*Element, type=C3D4, elset=Eall\n10, 1, 2, 3, 4\n11, 2, 3, 4, 5\n";

std::size_t facets_named(const imported_mesh& mesh, const std::string& name) {
  for (const auto& row : mesh.version->surfaces())
    if (row.name == name) {
      const std::array ids{row.id};
      return facets_of(*mesh.version, ids).size();
    }
  return 0;
}

TEST(InpReader, SurfacesByFacesByShellsAndByNodes) {
  // S1 of tet 10 is 1-2-3; set "Low" S2 and S3 of it: 1-4-2 and 2-4-3, which is inside.
  const auto mesh = read(inp_nodes + inp_tets +
                         "*Elset, elset=Low, generate\n10, 10, 1\n"
                         "*Surface, name=Bottom, type=ELEMENT\n10, S1\n"
                         "*Surface, name=Side, type=ELEMENT\nLow, S2\n"
                         "*Element, type=S3, elset=Skin\n20, 2, 3, 5\n"
                         "*Nset, nset=Tip\n2, 4, 5\n");

  ASSERT_TRUE(mesh.has_value()) << render(mesh.error());
  EXPECT_EQ(facets_named(*mesh, "Bottom"), 1U);
  EXPECT_EQ(facets_named(*mesh, "Side"), 1U);
  EXPECT_EQ(facets_named(*mesh, "Skin"), 1U);
  EXPECT_EQ(facets_named(*mesh, "Tip"), 1U);
  EXPECT_EQ(mesh->version->facet_count(), 6U);
  EXPECT_THAT(mesh->warnings, Contains(HasSubstr("2 boundary faces had no surface id")));
  EXPECT_EQ(mesh->loads.name, "Two tets");
}

TEST(InpReader, NumbersAtTheEndsOfNamesAreIds) {
  const auto mesh =
    read(inp_nodes + inp_tets + "*Surface, name=Face30\n10, S1\n*Surface, name=FACE7\n11, S1\n");
  const auto doubled =
    read(inp_nodes + inp_tets + "*Surface, name=A1\n10, S1\n*Surface, name=B1\n10, S2\n");

  ASSERT_TRUE(mesh.has_value()) << render(mesh.error());
  EXPECT_NE(mesh->version->find_surface(30), nullptr);
  ASSERT_TRUE(doubled.has_value());
  EXPECT_EQ(doubled->version->find_surface(1)->name, "A1");
  EXPECT_EQ(doubled->version->find_surface(2)->name, "B1");
}

TEST(InpReader, AFaceOfTwoSurfacesStaysWithTheSmallerOneAndThatIsSaid) {
  const auto mesh =
    read(inp_nodes + inp_tets +
         "*Surface, name=All\n10, S1\n10, S2\n10, S4\n*Surface, name=One\n10, S2\n");

  ASSERT_TRUE(mesh.has_value()) << render(mesh.error());
  EXPECT_EQ(facets_named(*mesh, "All"), 2U);
  EXPECT_EQ(facets_named(*mesh, "One"), 1U);
  EXPECT_THAT(mesh->warnings, Contains(HasSubstr("1 of the 3 faces of \"All\"")));
}

TEST(InpReader, SectionsAreRegionsAndCarryMaterials) {
  const auto mesh = read(inp_nodes +
                         "*Element, type=C3D4\n10, 1, 2, 3, 4\n11, 2, 3, 4, 5\n"
                         "*Elset, elset=Core\n10\n*Elset, elset=Coat\n11\n"
                         "*Material, name=Steel\n*Elastic\n210000., 0.3\n*Density\n7.85e-9,\n"
                         "*Solid Section, elset=Core, material=STEEL\n"
                         "*Solid Section, elset=Coat, material=Steel\n");

  ASSERT_TRUE(mesh.has_value()) << render(mesh.error());
  EXPECT_EQ(mesh->version->regions(), (std::vector<region_info>{{1, "Core"}, {2, "Coat"}}));
  ASSERT_EQ(mesh->loads.materials.size(), 1U);
  const auto& steel = mesh->loads.materials[0];
  EXPECT_NEAR(steel.young_modulus, 210e9, 1);
  EXPECT_NEAR(steel.density, 7850, 1e-6);
  EXPECT_THAT(steel.regions, ElementsAre(1, 2));
}

TEST(InpReader, SupportsAndLoadsStandOnVerticesInSiUnits) {
  const auto mesh = read(inp_nodes + inp_tets +
                         "*Nset, nset=Base\n1, 2, 3\n*Surface, name=Top\n11, S2\n*Step\n*Static\n"
                         "*Boundary\nBase, 1, 2\n4, 3, 3, 0.5\n*Cload\n5, 2, -8.5\n"
                         "*Dsload\nTop, P, 2.\n*Dload\nEall, GRAV, 9810., 0, 0, -1\n*End Step\n");

  ASSERT_TRUE(mesh.has_value()) << render(mesh.error());
  EXPECT_EQ(mesh->loads.supports.size(), 7U);
  EXPECT_DOUBLE_EQ(mesh->loads.supports.back().value, 0.5e-3);
  ASSERT_EQ(mesh->loads.forces.size(), 1U);
  EXPECT_DOUBLE_EQ(mesh->loads.forces[0].value.y, -8.5);
  EXPECT_DOUBLE_EQ(mesh->version->position(mesh->loads.forces[0].vertex).x, 1e-3);
  ASSERT_EQ(mesh->loads.pressures.size(), 1U);
  EXPECT_DOUBLE_EQ(mesh->loads.pressures[0].value, 2e6);
  ASSERT_TRUE(mesh->loads.gravity.has_value());
  EXPECT_DOUBLE_EQ(mesh->loads.gravity->z, -9.81);
}

TEST(InpReader, WhatNothingHereCanHoldIsSaidByName) {
  const auto mesh = read(inp_nodes + inp_tets + "*Tie, name=T\nA, B\n*Step\n*Step\n");

  ASSERT_TRUE(mesh.has_value()) << render(mesh.error());
  EXPECT_THAT(mesh->warnings, Contains(HasSubstr("*TIE (line 12)")));
}

/// The same two tets as Nastran writes them: free, small and large fields, continuations.
const std::string bdf_head = "SOL 101\nCEND\nTITLE = Two tets\nSPC = 2\nLOAD = 3\nBEGIN BULK\n";
const std::string bdf_mesh =
  "GRID,1,,0.,0.,0.\n"
  "GRID           2       0      1.      0.      0.\n"
  "GRID*                  3                              0.             1.0\n*                   "
  "  0.\n"
  "GRID           4              0.      0.    1.+0\n"
  "GRID,5,,1.,1.,1.\n"
  "CTETRA,10,1,1,2,3,4\n"
  "CTETRA        11       2       2       3       4       5\n"
  "BSURFS        30                              10       1       2       3\n"
  "+             10       1       2       4\n";

TEST(BdfReader, FreeSmallAndLargeFields) {
  const auto mesh = read(bdf_head + bdf_mesh + "ENDDATA\n");

  ASSERT_TRUE(mesh.has_value()) << render(mesh.error());
  EXPECT_EQ(mesh->version->tet_count(), 2U);
  EXPECT_NEAR(total_volume(*mesh->version), 0.5e-9, 1e-20);  // 1/6 and 1/3 mm3.
  EXPECT_EQ(mesh->version->regions().size(), 2U);
  const std::array<surface_id, 1> ids{30};
  EXPECT_EQ(facets_of(*mesh->version, ids).size(), 2U);
  EXPECT_EQ(mesh->loads.name, "Two tets");
}

TEST(BdfReader, LoadsAreThoseThatTheCaseControlAsksFor) {
  const auto mesh = read(bdf_head + bdf_mesh +
                         "MAT1,7,210000.,,0.3,7.85-9\nPSOLID,1,7\nPSOLID,2,7\n"
                         "SPC1,2,123,1,THRU,3\nSPC1,9,1,5\n"
                         "FORCE,4,5,,10.,0.,1.,0.\nFORCE,5,4,,10.,0.,1.,0.\nLOAD,3,2.,1.5,4\n"
                         "PLOAD4,4,11,6.,,,,2,3\nENDDATA\n");

  ASSERT_TRUE(mesh.has_value()) << render(mesh.error());
  EXPECT_EQ(mesh->loads.supports.size(), 9U);
  ASSERT_EQ(mesh->loads.forces.size(), 1U);
  EXPECT_DOUBLE_EQ(mesh->loads.forces[0].value.y, 30);
  ASSERT_EQ(mesh->loads.pressures.size(), 1U);
  EXPECT_DOUBLE_EQ(mesh->loads.pressures[0].value, 18e6);
  ASSERT_EQ(mesh->loads.materials.size(), 1U);
  EXPECT_NEAR(mesh->loads.materials[0].density, 7850, 1e-6);
  EXPECT_THAT(mesh->loads.materials[0].regions, ElementsAre(1, 2));
}

TEST(BdfReader, NamesOfOtherProgramsComments) {
  const auto mesh =
    read(bdf_head + "$HMNAME COMP                   1\"Core\" \n$ Femap Property 2 : Coat\n" +
         bdf_mesh + "ENDDATA\n");

  ASSERT_TRUE(mesh.has_value()) << render(mesh.error());
  EXPECT_EQ(mesh->version->regions(), (std::vector<region_info>{{1, "Core"}, {2, "Coat"}}));
}

std::string unv_dataset(int number, const std::string& body) {
  return "    -1\n" + std::to_string(number) + "\n" + body + "    -1\n";
}

TEST(UnvReader, GroupsNameSurfacesAndDivideRegions) {
  const auto mesh = read(
    unv_dataset(164, "1\n1.0000000000000000D+02 1. 1.\n2.7315D+02\n") +
    unv_dataset(2411,
                "1 1 1 11\n0. 0. 0.\n2 1 1 11\n1.D0 0. 0.\n3 1 1 11\n0. 1. 0.\n4 1 1 11\n0. "
                "0. 1.\n5 1 1 11\n1. 1. 1.\n") +
    unv_dataset(2412,
                "2 41 2 1 7 3\n1 2 3\n3 41 2 1 7 3\n1 2 4\n"
                "10 111 1 1 7 4\n1 2 3 4\n11 111 1 1 7 4\n2 3 4 5\n") +
    unv_dataset(2467, "1 0 0 0 0 0 0 2\nWall\n8 2 0 0 8 3 0 0\n2 0 0 0 0 0 0 1\nCoat\n8 11 0 0\n"));

  ASSERT_TRUE(mesh.has_value()) << render(mesh.error());
  EXPECT_EQ(mesh->length_unit, "cm");
  EXPECT_EQ(facets_named(*mesh, "Wall"), 2U);
  EXPECT_EQ(mesh->version->regions(), (std::vector<region_info>{{1, ""}, {2, "Coat"}}));
  EXPECT_NEAR(total_volume(*mesh->version), 0.5e-6, 1e-17);
}

struct bad_deck {
  const char* text;
  const char* message;
  const char* where;
};

TEST(NumberSetsOfDecks, AllSetsTogetherHaveNoMoreMembersThanTheyMay) {
  number_sets_of_deck sets(10);
  auto& some = sets.set("some");

  EXPECT_TRUE(sets.add_range(some, 1, 11, 2));  // 1, 3, ..., 11: six.
  EXPECT_FALSE(sets.add_range(sets.set("others"), 1, 5, 1));
  EXPECT_FALSE(sets.add_all(sets.set("others"), some));
  EXPECT_TRUE(sets.add_range(sets.set("others"), 1, 3, 1));
  EXPECT_TRUE(sets.add(some, 12));
  EXPECT_FALSE(sets.add(some, 13));

  EXPECT_EQ(sets.find("SOME")->numbers.size() + sets.find("others")->numbers.size(), 10U);
}

TEST(Decks, WhatIsBrokenIsRefusedWithItsPlace) {
  const bad_deck rows[] = {
    {"*NODE\n1, 0, zero, 0\n", "a node's y \"zero\" is not a finite number", "line 2"},
    {"*NODE\n0, 0, 0, 0\n", "a node's number is 0, numbers start at 1", "line 2"},
    {"*NODE\n1,0,0,0\n1,1,0,0\n2,0,1,0\n3,0,0,1\n*ELEMENT,TYPE=C3D4\n1,1,2,3,1\n",
     "node 1 is listed twice", "node 1"},
    {"*NODE\n1,0,0,0\n*ELEMENT,TYPE=C3D4\n1,1,2,3,4\n", "tet 1 names node 2", "tet 1"},
    {"*NODE\n1,0,0,0\n*ELEMENT,TYPE=C3D4\n1,1,2\n*NSET,NSET=A\n1\n", "lists 2 nodes, it has 4",
     "line 4"},
    {"*ELEMENT,TYPE=C3D8\n", "elements of type \"C3D8\"", "line 1"},
    {"*NSET,NSET=A,GENERATE\n1,900000000000\n", "a set has more members", "line 2"},
    {"*NSET,NSET=A\nB\n", "names \"B\", which is neither a number nor a set", "line 2"},
    {"*NODE\n1,0,0,0\n*SURFACE,NAME=A\n7,S1\n", "names element 7, which is no tet", "line 4"},
    {"*SURFACE,NAME=A\n7,S9\n", "names face \"S9\"", "line 2"},
    {"*INCLUDE, INPUT=mesh.inp\n", "takes in another file by *INCLUDE (mesh.inp)", "line 1"},
    {"*PART, NAME=A\n*END PART\n*PART, NAME=B\n", "more than one *PART, here \"B\"", "line 3"},
    {"*CLOAD\nNOSUCH, 1, 2.\n", "a force acts on the set \"NOSUCH\"", "line 2"},
    {"*ELASTIC\n1,2\n", "*ELASTIC stands outside of a *MATERIAL", "line 1"},
    {"*HEADING\n", "the file holds no nodes", ""},
    {"BEGIN BULK\nGRID,1,,x,0.,0.\n", "a coordinate of a GRID is \"x\"", "line 2"},
    {"BEGIN BULK\nGRID,1,5,0.,0.,0.\n", "is in coordinate system 5", "line 2"},
    {"BEGIN BULK\nCHEXA,1,1,1,2,3,4,5,6\n", "holds a CHEXA", "line 2"},
    {"BEGIN BULK\nSPC1,1,1,5,THRU,99999999\n", "THRU of a SPC1 goes from 5 to 99999999", "line 2"},
    {"BEGIN BULK\nSPC1,1,9,5\n", "the components of a SPC1 are \"9\"", "line 2"},
    {"BEGIN BULK\nCTETRA,1,1,1,2,3\n", "a node of a CTETRA is \"\"", "line 2"},
    {"    -1\n  2411\n 1 1 1 1\n 0. 0.\n    -1\n", "a node's coordinate \"\"", "line 4"},
    {"    -1\n  2411\n 1 1 1 1\n", "the file ends where a node's coordinates should stand", "line"},
    {"    -1\n  2412\n 1 115 1 1 7 8\n1 2 3 4 5 6 7 8\n    -1\n", "holds a brick", "line 4"},
    {"    -1\n   781\n    -1\n    -1\n   780\n    -1\n", "dataset 780 is of an older kind", "line"},
    {"    -1\n   164\n1 x 2\n3.5D+0 1. 1.\n0.\n    -1\n", "that of no unit that is known",
     "line 4"},
    {"    -1\n  2467\n1 0 0 0 0 0 0 99999999\nA\n    -1\n", "members, but its lines have 0",
     "line"},
  };
  for (const auto& row : rows) {
    SCOPED_TRACE(row.text);
    const auto mesh = read(row.text);
    ASSERT_FALSE(mesh.has_value());
    EXPECT_THAT(mesh.error().message, HasSubstr(row.message));
    EXPECT_THAT(mesh.error().where, HasSubstr(row.where));
    EXPECT_FALSE(mesh.error().remedy.empty());
  }
}

}  // namespace
}  // namespace tedit
