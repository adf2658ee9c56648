// SPDX-License-Identifier: AGPL-3.0-or-later
// Surface files on the command line.
#include <numbers>

#include "tests/cad/import_program.hpp"
#include "tests/scan/surfaces.hpp"

namespace tedit::test {
namespace {

std::string stl_file(const std::string& name, const soup& triangles) {
  return write_scratch(name, stl_of(triangles)).string();
}

TEST(ImportedStl, OfACubeHasItsPlanesAndVolume) {
  const auto part = import_part(stl_file("cube.stl", cube_soup(10)) + " --size coarse");

  EXPECT_EQ(part["surfaces"].size(), 6U);
  EXPECT_EQ(part["surfaces"][2]["name"], "plane 3");
  EXPECT_NEAR(part["volume_m3"].get<double>(), 1e-6, 1e-15);
  EXPECT_NEAR(part["cad_volume_m3"].get<double>(), 1e-6, 1e-15);
  EXPECT_NEAR(part["deviation_m"].get<double>(), 0, 1e-12);
  EXPECT_NEAR(part["edge_length_m"].get<double>(), 1e-3 * 2 * 1000 / 600, 1e-12);
  EXPECT_GT(part["radius_ratio"]["min"].get<double>(), 0.1);
  EXPECT_EQ(part["length_unit"], "mm");
  EXPECT_EQ(part["cad_unit"], "mm");
  for (const char* stage : {"read", "mesh", "repair", "total"})
    EXPECT_GE(part["timings_ms"][stage].get<double>(), 0) << stage;
}

TEST(ImportedStl, IsInTheUnitThatIsAskedFor) {
  const auto file = stl_file("cube.stl", cube_soup(1));
  const auto part = import_part(file + " --size coarse --unit inch");

  EXPECT_EQ(part["cad_unit"], "in");
  EXPECT_NEAR(part["volume_m3"].get<double>(), std::pow(0.0254, 3), 1e-14);
  EXPECT_EQ(refusal_of(cad_parts + "box.step --unit cm", 1)["code"], "invalid_argument");
}

TEST(ImportedCylinder, IsRoundThoughTheFileHasTwelveWalls) {
  const auto mesh = scratch("pin.msh").string();
  const auto part =
    import_part(stl_file("pin.stl", cylinder_soup(4, 10, 12)) + " --size fine -o " + mesh);

  ASSERT_EQ(part["surfaces"].size(), 3U);
  EXPECT_EQ(part["surfaces"][1]["name"], "cylinder 2 d 8 mm");
  // The file's chords lie 4 (1 - cos 15) mm within the round wall, the mesh's vertices on it.
  EXPECT_NEAR(part["deviation_m"].get<double>(), 4e-3 * (1 - std::cos(std::numbers::pi / 12)),
              2e-5);
  EXPECT_GT(part["volume_m3"].get<double>(), part["cad_volume_m3"].get<double>());
  EXPECT_LT(part["volume_m3"].get<double>(), std::numbers::pi * 16 * 10 * 1e-9);
  // An operation that asks for a cylinder finds it.
  const auto wider =
    run("edit --json " + mesh + " --op resize_bore --surfaces 2 --param diameter_mm=8.2 -o " +
        scratch("wider.msh").string());
  EXPECT_EQ(wider.status, 0) << wider.out;
}

TEST(ImportedPart, FromATessellationHasTheBoreAndLosesIt) {
  const auto mesh = scratch("block.msh").string();
  const auto closed = scratch("closed.msh").string();
  const auto part = import_part(TEDIT_TEST_DATA "/scan/inch_block.stl --size medium -o " + mesh);

  // Nine CAD faces, of which the two halves of the bore are one surface.
  ASSERT_EQ(part["surfaces"].size(), 8U);
  std::string bore;
  for (const auto& one : part["surfaces"]) {
    const auto name = one["name"].get<std::string>();
    const bool is_wall = name.starts_with("cylinder");
    // 6.35 mm wide; its end is the smallest plane.
    if (is_wall) {
      EXPECT_TRUE(name.ends_with(" d 6.35 mm")) << name;
    }
    if (is_wall || one["area_m2"].get<double>() < 4e-5)
      bore += (bore.empty() ? "" : ",") + std::to_string(one["id"].get<int>());
  }
  EXPECT_NEAR(part["volume_m3"].get<double>() / part["cad_volume_m3"].get<double>(), 1, 1e-3);
  EXPECT_GT(part["radius_ratio"]["min"].get<double>(), 0.05);
  const auto edit =
    run("edit --json " + mesh + " --op fill_hole --surfaces " + bore + " -o " + closed);
  ASSERT_EQ(edit.status, 0) << edit.out;
  const double inch = 0.0254;
  EXPECT_NEAR(run("info --json " + closed).parsed()["volume_m3"].get<double>(),
              6 * inch * inch * inch, 1e-11);
}

TEST(ImportedSurface, ThatIsBrokenIsRefusedWithFileAndPlace) {
  const auto cube = cube_soup(10);
  const auto open = refusal_of(stl_file("open.stl", soup(cube.begin() + 1, cube.end())), 65);
  EXPECT_EQ(open["code"], "bad_input");
  EXPECT_THAT(open["message"].get<std::string>(), HasSubstr("it has 1 hole, the longest is 34.14"));
  EXPECT_THAT(open["where"].get<std::string>(), HasSubstr("open.stl"));
  const auto cut = refusal_of(write_scratch("cut.stl", stl_of(cube).substr(0, 300)).string(), 65);
  EXPECT_THAT(cut["where"].get<std::string>(), HasSubstr("cut.stl, byte 80"));
  EXPECT_FALSE(std::filesystem::exists(scratch("open.msh")));
}

TEST(ImportedSurface, AsADocumentHasNoModel) {
  const auto document = scratch("cube.tedit").string();
  std::filesystem::remove(document);
  import_part(stl_file("cube.stl", cube_soup(10)) + " --size coarse -o " + document);

  const auto said = run("export --json " + document + " -o " + scratch("cube.step").string());
  EXPECT_NE(said.status, 0);
  EXPECT_THAT(said.parsed()["error"]["message"].get<std::string>(), HasSubstr("no CAD model"));
}

}  // namespace
}  // namespace tedit::test
