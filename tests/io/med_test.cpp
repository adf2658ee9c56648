// SPDX-License-Identifier: AGPL-3.0-or-later
// MED files, which the program tedit-med reads and writes.
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text.hpp"
#include "mesh/build_version.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/io/group_names.hpp"
#include "mesh/io/import.hpp"
#include "mesh/io/med_content.hpp"
#include "tests/support/scratch.hpp"

namespace tedit {
namespace {

using test::value;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::filesystem::path files = TEDIT_TEST_DATA "/med";

/// Two tets over and under the triangle 1 2 3, each a region, each outer side a surface.
version_ptr pair_of_tets(const std::string& name = "Bore") {
  raw_mesh raw;
  raw.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {0, 0, -2}};
  raw.tets = {{{0, 1, 2, 3}}, {{0, 2, 1, 4}}};
  raw.tet_regions = {3, 8};
  raw.triangles = {{{0, 1, 3}, 12}, {{1, 2, 3}, 12}, {{2, 0, 3}, 12},
                   {{0, 1, 4}, -5}, {{1, 2, 4}, -5}, {{2, 0, 4}, -5}};
  raw.surface_names = {{12, name}};
  raw.region_names = {{3, "Steel"}};
  return build_version(std::move(raw), 1e-3)->version;
}

std::string written(const mesh_version& mesh, const std::string& unit = "mm",
                    const std::string& title = "part") {
  std::string bytes;
  value(write_as("med", &bytes, mesh, {.length_unit = unit, .title = title}));
  return bytes;
}

med_content content_of(const std::string& bytes) {
  return value(content_from(value(ask_med(bytes))));
}

/// Through a file.
expected<imported_mesh> read(const med_content& content) {
  const auto bytes = ask_med(to_bytes(content));
  if (!bytes)
    return fail(bytes.error());
  return import_mesh_bytes(*bytes, "mm");
}

const med_content::family* family_of(const med_content& content, std::int32_t number) {
  const auto found = std::ranges::find(content.families, number, &med_content::family::number);
  return found == content.families.end() ? nullptr : &*found;
}

std::vector<std::string> groups_of(const med_content& content, std::int32_t family) {
  const auto* found = family_of(content, family);
  return found ? found->groups : std::vector<std::string>{};
}

std::string name_of(const mesh_version& mesh, surface_id surface) {
  const auto* row = mesh.find_surface(surface);
  return row ? row->name : "none";
}

TEST(Med, TwoTetsAreWrittenAsMedHasThem) {
  const auto bytes = written(*pair_of_tets());

  EXPECT_EQ(bytes.substr(0, 8), "\x89HDF\r\n\x1a\n");
  const auto content = content_of(bytes);
  EXPECT_EQ(content.name, "part");
  EXPECT_EQ(content.unit, "mm");
  EXPECT_THAT(content.coordinates, ElementsAre(0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, -2));
  // The second and third corner are the other way round than ours.
  EXPECT_THAT(content.tets.nodes, ElementsAre(1, 3, 2, 4, 1, 2, 3, 5));
  EXPECT_THAT(content.tets.families, ElementsAre(-3, -4));
  EXPECT_THAT(content.triangles.families, ElementsAre(-1, -1, -1, -2, -2, -2));
  EXPECT_THAT(groups_of(content, -1), ElementsAre("surface -5"));
  EXPECT_THAT(groups_of(content, -2), ElementsAre("surface 12: Bore"));
  EXPECT_THAT(groups_of(content, -3), ElementsAre("region 3: Steel"));
  EXPECT_THAT(groups_of(content, -4), ElementsAre("region 8"));
  ASSERT_NE(family_of(content, 0), nullptr);
  EXPECT_EQ(family_of(content, 0)->name, "FAMILLE_ZERO");
  EXPECT_THAT(content.notices, IsEmpty());
}

TEST(Med, TheSameMeshGivesTheSameBytes) {
  EXPECT_EQ(written(*pair_of_tets()), written(*pair_of_tets()));
}

TEST(Med, AMeshIsNamedAsThePartWhereThatCanBeALinkOfHdf5) {
  EXPECT_EQ(content_of(written(*pair_of_tets(), "mm", "a/b\n")).name, "a_b_");
  EXPECT_EQ(content_of(written(*pair_of_tets(), "mm", "..")).name, "part");
  EXPECT_EQ(content_of(written(*pair_of_tets(), "mm", std::string(70, 'x'))).name,
            std::string(64, 'x'));
}

TEST(Med, NamesLongerThanAGroupGoOnInAnother) {
  std::string name = "Bohrung \xc3\xa4\xc3\xb6\xc3\xbc ";
  while (name.size() < 180)
    name += "und noch eine \xc3\x9f ";
  name += "!";
  const auto mesh = pair_of_tets(name);

  const auto bytes = written(*mesh);

  const auto groups = groups_of(content_of(bytes), -2);
  EXPECT_EQ(groups.size(), 3U);
  for (const auto& group : groups) {
    EXPECT_LE(group.size(), longest_med_group);
    EXPECT_TRUE(is_utf8(group));
  }
  EXPECT_THAT(groups, Contains(::testing::StartsWith("surface 12 (2): ")));
  const auto again = value(import_mesh_bytes(bytes, "mm"));
  EXPECT_EQ(name_of(*again.version, 12), name);
}

TEST(Med, AGroupsNameIsTakenApartAsItWasMade) {
  const std::string name(200, 'x');
  for (const auto& group : names_of_group("surface", INT64_MIN, name, 80))
    EXPECT_LE(group.size(), 80U);
  EXPECT_EQ(own_group("surface 12 (2): more", "surface")->part, 2U);
  EXPECT_FALSE(own_group("surface 12 (0): more", "surface").has_value());
  EXPECT_FALSE(own_group("surface twelve", "surface").has_value());
  EXPECT_FALSE(own_group("surfaces 12", "surface").has_value());
}

TEST(Med, WhatSalomesLibraryWroteIsReadWithItsGroups) {
  const auto mesh = value(import_mesh(files / "salome.med", "mm"));

  EXPECT_THAT(mesh.warnings, IsEmpty());
  EXPECT_EQ(mesh.version->tet_count(), 2U);
  // (1/6) (8 + 16) of a cube of 2 mm's corner and of the tet on it.
  EXPECT_NEAR(total_volume(*mesh.version), 4e-9, 1e-20);
  EXPECT_THAT(mesh.version->surfaces(),
              ElementsAre(surface_info{1, "back wall"}, surface_info{2, "foot"}));
  EXPECT_THAT(mesh.version->regions(),
              ElementsAre(region_info{1, "steel"}, region_info{2, "Solid 7"}));
}

TEST(Med, QuadraticTetsOfSalomesLibraryAreReadByTheirCorners) {
  const auto straight = value(import_mesh(files / "salome_quadratic.med", "mm"));
  const auto bent = value(import_mesh(files / "salome_bent.med", "mm"));

  EXPECT_THAT(straight.warnings, ElementsAre("2 tets have nodes on their edges; they are read as "
                                             "straight tets of their four corners"));
  // The middle of the edge from (0, 0, 0) to (2, 0, 0) is at z = -0.1.
  EXPECT_THAT(bent.warnings,
              ElementsAre(HasSubstr("1 of these nodes lie off the straight edge, by up to 0.1 "
                                    "(5 % of the edge) at (1, 0, -0.1)")));
  for (const auto* mesh : {&straight, &bent}) {
    EXPECT_NEAR(total_volume(*mesh->version), 4e-9, 1e-20);
    EXPECT_EQ(mesh->version->surfaces().size(), 2U);
    EXPECT_EQ(mesh->version->facet_count(), 6U);
  }
}

// -- what others write, made by hand ---------------------------------------------------------

/// The two tets again, all faces in the family -1.
med_content plain() {
  med_content content;
  content.name = "part";
  content.coordinates = {0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, -2};
  content.tets = {{1, 3, 2, 4, 1, 2, 3, 5}, {-2, -3}};
  content.triangles = {{1, 4, 2, 2, 4, 3, 3, 4, 1, 1, 2, 5, 2, 3, 5, 3, 1, 5},
                       {-1, -1, -1, -1, -1, -1}};
  content.families = {{-1, "skin", {}}, {-2, "upper", {"all", "upper"}}, {-3, "lower", {"all"}}};
  return content;
}

TEST(MedGroups, AFamilyWithoutGroupsIsASurfaceOfItsName) {
  EXPECT_THAT(value(mesh_from(plain())).mesh.surface_names, ElementsAre(surface_info{1, "skin"}));
}

TEST(MedGroups, ATetHasOneRegionSoOverlapsAreTold) {
  const auto made = value(mesh_from(plain()));

  EXPECT_THAT(made.mesh.tet_regions, ElementsAre(1, 2));
  EXPECT_THAT(made.mesh.region_names, ElementsAre(region_info{1, "upper"}, region_info{2, "all"}));
  EXPECT_THAT(made.notices,
              ElementsAre("a tet has one region: groups of tets that overlap others are not kept: "
                          "\"all\""));
}

TEST(MedGroups, ANumberAtTheEndOfEachNameIsTheId) {
  auto content = plain();
  content.families = {{-1, "f", {"Face 40"}}, {-2, "u", {"Solid 7"}}, {-3, "l", {"Solid 4"}}};
  const auto made = value(mesh_from(content));

  EXPECT_THAT(made.mesh.surface_names, ElementsAre(surface_info{40, "Face 40"}));
  EXPECT_THAT(made.mesh.region_names,
              ElementsAre(region_info{7, "Solid 7"}, region_info{4, "Solid 4"}));
  EXPECT_THAT(made.notices, IsEmpty());
}

TEST(MedGroups, OfNodesMakeSurfacesWhereNoFaceIsInAGroup) {
  auto content = plain();
  content.triangles = {};
  content.node_families = {1, 1, 1, 2, 0};
  content.families.push_back({1, "edge", {"top"}});
  content.families.push_back({2, "tip", {"top"}});
  const auto mesh = value(read(content));

  EXPECT_EQ(mesh.version->surfaces().front().name, "top");
}

TEST(MedGroups, WithoutAnyTheMeshIsOneRegion) {
  auto content = plain();
  content.families.clear();

  EXPECT_THAT(value(mesh_from(content)).mesh.tet_regions, ElementsAre(1, 1));
}

TEST(MedGroups, AFaceInThousandsOfGroupsIsRefused) {
  auto content = plain();
  for (int i = 0; i < 100; ++i)
    content.families.front().groups.push_back("group " + std::to_string(i));
  const auto made = mesh_from(content);

  ASSERT_FALSE(made.has_value());
  EXPECT_EQ(made.error().message, "the groups hold each face more than 64 times on average");
}

TEST(MedContent, TheUnitOfTheAxesCountsWhereItIsOne) {
  auto content = plain();
  content.unit = "cm";
  EXPECT_EQ(value(read(content)).length_unit, "cm");
  content.unit = "parsec";
  const auto made = value(mesh_from(content));
  EXPECT_EQ(made.length_unit, "");
  EXPECT_THAT(made.notices,
              Contains("the file says that its lengths are in \"parsec\", which is no "
                       "unit that is known"));
}

/// What is said of this content.
std::string told(const med_content& content) {
  const auto made = mesh_from(content);
  return made ? "nothing"
              : made.error().message + " | " + made.error().remedy + " | " + made.error().where;
}

TEST(MedContent, IsCheckedBeforeItIsUsed) {
  EXPECT_EQ(told(plain()), "nothing");
  auto nan = plain();
  nan.coordinates[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(told(nan), "a coordinate of node 2 is no number (nan) | Write the file again | node 2");
  auto far = plain();
  far.coordinates[14] = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(told(far), "a coordinate of node 5 is infinite | Write the file again | node 5");
  for (const auto& [number, text] :
       {std::pair(6, "6"), std::pair(0, "0"), std::pair(-7, "-7"),
        std::pair(INT32_MAX, "2147483647"), std::pair(INT32_MIN, "-2147483648")}) {
    auto astray = plain();
    astray.tets.nodes[7] = number;
    EXPECT_EQ(told(astray),
              "tet 2 names node " + std::string(text) +
                ", which does not exist | Write the file with all of its nodes | tet 2");
  }
  auto face = plain();
  face.triangles.nodes[0] = 9;
  EXPECT_EQ(told(face),
            "triangle 1 names node 9, which does not exist | Write the file with all "
            "of its nodes | triangle 1");
  auto none = plain();
  none.tets = {};
  EXPECT_THAT(told(none), HasSubstr("the mesh has no volume elements (tets)"));
}

TEST(MedContent, IsTakenWholeOrNotAtAll) {
  const auto bytes = to_bytes(plain());
  ASSERT_TRUE(content_from(bytes).has_value());

  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_FALSE(content_from(std::span(bytes).first(length)).has_value()) << length;
  auto more = bytes;
  more.push_back(0);
  EXPECT_FALSE(content_from(more).has_value());
  auto uneven = plain();
  uneven.tets.nodes.pop_back();
  EXPECT_FALSE(content_from(to_bytes(uneven)).has_value());
  uneven = plain();
  uneven.node_families = {1};
  EXPECT_FALSE(content_from(to_bytes(uneven)).has_value());
}

/// A program that a file took over may answer anything.
TEST(MedContent, OfChanceIsRefusedOrRead) {
  const auto sound = to_bytes(plain());
  std::mt19937 chance(1);
  std::size_t taken = 0;
  std::size_t refused = 0;
  for (unsigned i = 0; i < 20'000; ++i) {
    auto bytes = sound;
    for (unsigned k = 0; k < 1 + i % 4; ++k)
      bytes[chance() % bytes.size()] = static_cast<char>(chance());
    auto content = content_from(bytes);
    if (!content)
      continue;
    const auto made = mesh_from(std::move(*content));
    ++(made ? taken : refused);
    if (!made) {
      ASSERT_NE(made.error().message, "");
    }
  }
  EXPECT_GT(taken, 1000U);
  EXPECT_GT(refused, 1000U);
}

// -- the program -----------------------------------------------------------------------------

/// In the place of tedit-med stands a script. One that does not read what it is given raises
/// SIGPIPE, which all our programs ignore.
class MedProgram : public ::testing::Test {
protected:
  MedProgram() : before_(std::signal(SIGPIPE, SIG_IGN)) {
    setenv("TEDIT_LIBEXEC", folder_.path().c_str(), 1);
  }
  ~MedProgram() override {
    unsetenv("TEDIT_LIBEXEC");
    std::signal(SIGPIPE, before_);
  }

  error told_by(const std::string& lines) {
    const auto program = folder_.path() / "tedit-med";
    std::ofstream(program) << "#!/bin/sh\n" << lines << "\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const auto mesh = import_mesh(files / "salome.med", "mm");
    return mesh ? error{} : mesh.error();
  }

  test::scratch_folder folder_;
  void (*before_)(int);
};

TEST_F(MedProgram, ThatIsNotThereIsToldWithTheRemedy) {
  const auto mesh = import_mesh(files / "salome.med", "mm");

  ASSERT_FALSE(mesh.has_value());
  EXPECT_EQ(mesh.error().code, ec::service_unavailable);
  EXPECT_EQ(mesh.error().message, "this installation reads and writes no MED files: there is no " +
                                    (folder_.path() / "tedit-med").string());
  EXPECT_THAT(mesh.error().remedy, HasSubstr("libmedc-dev"));
}

TEST_F(MedProgram, ThatDiesCostsTheFileAlone) {
  const auto crashed = told_by("kill -SEGV $$");
  EXPECT_EQ(crashed.code, ec::bad_input);
  EXPECT_EQ(crashed.message, "tedit-med crashed (signal 11) while it was reading the file");
  EXPECT_THAT(crashed.remedy, HasSubstr("Write the mesh as .unv"));
  EXPECT_EQ(crashed.where, (files / "salome.med").string());
  EXPECT_EQ(told_by("exit 7").message,
            "tedit-med gave up (exit status 7) while it was reading the file");
  EXPECT_EQ(told_by("kill -PROF $$").message,
            "tedit-med found no end while it was reading the file");
}

TEST_F(MedProgram, WhatItAnswersIsAStrangersWord) {
  EXPECT_THAT(told_by("exec cat /dev/zero").message, HasSubstr("wrote more than"));
  EXPECT_EQ(told_by("true").message, "the answer of tedit-med is no mesh");
  EXPECT_EQ(told_by("printf TDETTMD1").message, "the answer of tedit-med is no mesh");
  EXPECT_EQ(told_by("printf 'TDETTMD1\\377\\377\\377\\377\\377\\377\\377\\377'").message,
            "the answer of tedit-med is no mesh");
  EXPECT_EQ(told_by("head -c 4096 /dev/urandom").message, "the answer of tedit-med is no mesh");
}

}  // namespace
}  // namespace tedit
