// SPDX-License-Identifier: AGPL-3.0-or-later
// What comes in from CAD files that are whole.
#include <numbers>
#include <set>

#include "tests/cad/import_program.hpp"
#include "tests/support/scratch.hpp"

namespace tedit::test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

constexpr double inch = 0.0254;

TEST(ImportedBox, IsTheBoxInEachFormat) {
  TEDIT_NEEDS_CAD();
  for (const std::string file : {"box.step", "box.igs", "box.brep"}) {
    const auto part = import_part(cad_parts + file + " --size coarse");
    // 10 x 20 x 30 mm; 2 V / A = 12000 / 2200 mm.
    EXPECT_NEAR(part["size_m"][0].get<double>(), 0.01, 1e-9) << file;
    EXPECT_NEAR(part["size_m"][1].get<double>(), 0.02, 1e-9) << file;
    EXPECT_NEAR(part["size_m"][2].get<double>(), 0.03, 1e-9) << file;
    EXPECT_NEAR(part["volume_m3"].get<double>(), 6e-6, 1e-14) << file;
    EXPECT_NEAR(part["cad_volume_m3"].get<double>(), 6e-6, 1e-14) << file;
    EXPECT_NEAR(part["edge_length_m"].get<double>(), 12.0 / 2200, 1e-9) << file;
    EXPECT_EQ(part["surfaces"].size(), 6U) << file;
    EXPECT_EQ(part["regions"].size(), 1U) << file;
    EXPECT_GT(part["tets"].get<int>(), 100) << file;
    EXPECT_GT(part["radius_ratio"]["min"].get<double>(), 0.2) << file;
    EXPECT_EQ(part["length_unit"], "mm");
    EXPECT_EQ(part["cad_unit"], file == "box.igs" ? "in" : "mm");
  }
}

TEST(ImportedBox, HasTheNamesOfPartAndFace) {
  TEDIT_NEEDS_CAD();
  const auto part = import_part(cad_parts + "box.step --size coarse");

  EXPECT_EQ(part["regions"][0]["name"], "box");
  EXPECT_EQ(part["surfaces"][0]["name"], "left wall");
  EXPECT_EQ(part["surfaces"][1]["name"], "");
  EXPECT_TRUE(part["surfaces"][0]["colour"].is_null());
  EXPECT_NEAR(part["surfaces"][0]["area_m2"].get<double>(), 6e-4, 1e-12);  // x = 0: 20 x 30 mm.
}

TEST(ImportedBox, IsTheSameMeshEachTime) {
  TEDIT_NEEDS_CAD();
  const auto first = import_part(cad_parts + "box.step");
  const auto second = import_part(cad_parts + "box.step");

  EXPECT_EQ(first["version_id"], second["version_id"]);
}

TEST(ImportedAssembly, IsTheSameMeshWhereverTheMesherLies) {
  TEDIT_NEEDS_CAD();
  const scratch_folder elsewhere;
  const auto folder = elsewhere.path() / "a folder with a name that is longer than others";
  std::filesystem::create_directories(folder);
  for (const auto* program : {"tedit-cad-reader", "tedit-cad-mesher", "tedit-mesher"})
    std::filesystem::copy_file(std::filesystem::path(TEDIT_BIN) / program, folder / program);

  const auto part = cad_parts + "as1_assembly.stp --size coarse";
  const auto here = import_part(part);
  setenv("TEDIT_LIBEXEC", folder.c_str(), 1);
  setenv("TMPDIR", folder.c_str(), 1);
  const auto there = import_part(part);
  unsetenv("TEDIT_LIBEXEC");
  unsetenv("TMPDIR");

  EXPECT_EQ(here["version_id"], there["version_id"]);
}

/// A box of six named sides; one edge is divided a hundred-thousandth of a millimetre from its end.
TEST(ImportedBox, EdgesOfNoLengthAreClosedUp) {
  TEDIT_NEEDS_CAD();
  const auto part = import_part(cad_parts + "short_edge.step --size coarse");

  ASSERT_EQ(part["surfaces"].size(), 6U);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(part["surfaces"][i]["name"], "side " + std::to_string(i + 1));
  EXPECT_NEAR(part["cad_volume_m3"].get<double>(), 6e-6, 1e-14);
  EXPECT_THAT(part["warnings"].dump(),
              ::testing::HasSubstr("edges shorter than 3.7e-05 mm were closed up, 1 in all, the "
                                   "first at 0, 1e-05, 0 mm"));
}

TEST(ImportedBox, SaysHowLongEachStageTook) {
  TEDIT_NEEDS_CAD();
  const auto ms = import_part(cad_parts + "box.step")["timings_ms"];

  const auto of = [&](const char* stage) { return ms[stage].get<double>(); };
  EXPECT_GT(of("read"), 0);
  EXPECT_GT(of("mesh"), 0);
  EXPECT_GE(of("repair"), 0);
  EXPECT_GE(of("total"), of("read") + of("mesh") + of("repair"));
}

TEST(ImportedBox, IsFinerWhereThatIsAskedFor) {
  TEDIT_NEEDS_CAD();
  const auto coarse = import_part(cad_parts + "box.brep --size coarse");
  const auto medium = import_part(cad_parts + "box.brep --size medium");
  const auto fine = import_part(cad_parts + "box.brep --size fine");

  EXPECT_NEAR(medium["edge_length_m"].get<double>(), 6.0 / 2200, 1e-9);
  EXPECT_NEAR(fine["edge_length_m"].get<double>(), 4.0 / 2200, 1e-9);
  EXPECT_GT(medium["tets"].get<int>(), 2 * coarse["tets"].get<int>());
  EXPECT_GT(fine["tets"].get<int>(), 2 * medium["tets"].get<int>());
}

/// Facets of a surface and their mean edge, as their area says: m.
double mean_edge(const json& part, std::size_t place) {
  const auto& row = part["surfaces"][place];
  return std::sqrt(4 / std::sqrt(3) * row["area_m2"].get<double>() / row["facets"].get<double>());
}

/// x = 0 is surface 1, "left wall": 20 x 30 mm; edges are up to 5.5 mm elsewhere.
TEST(ImportedBox, IsFinerOnTheSurfaceWhereThatIsAskedFor) {
  TEDIT_NEEDS_CAD();
  const auto plain = import_part(cad_parts + "box.step --size coarse");
  const auto by_number = import_part(cad_parts + "box.step --size coarse --local-size 1=1");
  const auto by_name =
    import_part(cad_parts + "box.step --size coarse --local-size \"left wall=1\"");

  EXPECT_EQ(by_number["version_id"], by_name["version_id"]);
  EXPECT_NEAR(mean_edge(by_number, 0), 1e-3, 0.2e-3);
  // The wall across is 10 mm away.
  EXPECT_NEAR(mean_edge(by_number, 1), mean_edge(plain, 1), 1.5e-3);
  EXPECT_GT(mean_edge(by_number, 1), 2.5e-3);
  EXPECT_GT(by_number["radius_ratio"]["min"].get<double>(), 0.1);
  EXPECT_NEAR(by_number["volume_m3"].get<double>(), 6e-6, 1e-14);
  EXPECT_EQ(by_number["edge_length_m"], plain["edge_length_m"]);
}

TEST(ImportedBox, ASizeForNoSurfaceOrWithoutALengthIsRefused) {
  TEDIT_NEEDS_CAD();
  const auto said = [](const std::string& more) {
    return run("import --json " + cad_parts + "box.step " + more);
  };
  auto refused = said("--local-size 7=1");
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.out, ::testing::HasSubstr("the part has no surface \\\"7\\\""));
  EXPECT_THAT(refused.out, ::testing::HasSubstr("Its surfaces are 1 to 6"));
  for (const std::string text : {"1", "1=", "=2", "1=2mm", "1=-2", "1=nan", "1=1e9"})
    EXPECT_EQ(said("--local-size " + text).status, 2) << text;
  EXPECT_THAT(run("import --json " TEDIT_TEST_DATA "/scan/inch_block.stl --local-size 1=1").out,
              ::testing::HasSubstr("local sizes are for CAD files"));
}

TEST(ImportedInchBlock, HasTheSizeOfItsInches) {
  TEDIT_NEEDS_CAD();
  const auto part = import_part(cad_parts + "inch_block.stp --size fine");

  EXPECT_EQ(part["cad_unit"], "in");
  EXPECT_NEAR(part["size_m"][0].get<double>(), 1 * inch, 1e-9);
  EXPECT_NEAR(part["size_m"][1].get<double>(), 2 * inch, 1e-9);
  EXPECT_NEAR(part["size_m"][2].get<double>(), 3 * inch, 1e-9);
  // 6 cubic inches less a blind hole of 1/4 inch diameter, half an inch deep.
  const double hole = std::numbers::pi * 0.125 * 0.125 * 0.5;
  EXPECT_NEAR(part["cad_volume_m3"].get<double>(), (6 - hole) * inch * inch * inch, 1e-11);
  EXPECT_NEAR(part["volume_m3"].get<double>() / part["cad_volume_m3"].get<double>(), 1, 5e-4);
  ASSERT_EQ(part["surfaces"].size(), 9U);
  for (const auto& surface : part["surfaces"]) {
    EXPECT_EQ(surface["name"], "PartBody");
    EXPECT_EQ(surface["colour"], "#0080ff");
  }
  EXPECT_EQ(part["regions"][0]["name"], "One Hole");
}

TEST(ImportedAssembly, HasARegionForEachSolidWithItsNameAndColour) {
  TEDIT_NEEDS_CAD();
  const auto part = import_part(cad_parts + "as1_assembly.stp --size coarse");

  std::map<std::string, int> count;
  std::map<std::string, std::set<std::string>> colours;
  for (const auto& region : part["regions"]) {
    const auto name = region["name"].get<std::string>();
    const auto kind = name.substr(0, name.find(" ("));
    ++count[kind];
    colours[kind].insert(region["colour"].get<std::string>());
    EXPECT_GT(region["tets"].get<int>(), 0);
  }
  EXPECT_EQ(count, (std::map<std::string, int>{
                     {"PLATE", 1}, {"L-BRACKET", 2}, {"BOLT", 6}, {"NUT", 8}, {"ROD", 1}}));
  EXPECT_THAT(colours["PLATE"], ElementsAre("#00ff00"));
  EXPECT_THAT(colours["L-BRACKET"], ElementsAre("#ffff00"));
  EXPECT_THAT(colours["NUT"], ElementsAre("#ff0000"));
  EXPECT_EQ(part["surfaces"].size(), 184U);
  EXPECT_NEAR(part["volume_m3"].get<double>() / part["cad_volume_m3"].get<double>(), 1, 3e-3);
  EXPECT_GT(part["radius_ratio"]["min"].get<double>(), 0.05);
}

TEST(ImportedAssembly, HasAnInterfaceWhereSolidsTouch) {
  TEDIT_NEEDS_CAD();
  const auto part = import_part(cad_parts + "as1_assembly.stp --size coarse");

  std::size_t interfaces = 0;
  for (const auto& surface : part["surfaces"]) {
    interfaces += surface.contains("interface_facets");
    if (surface.contains("interface_facets")) {
      EXPECT_EQ(surface["facets"], 0) << surface;  // The whole face lies between two solids.
    }
  }
  // Each L-bracket touches the plate, 3 bolts and 3 nuts touch their neighbours, the rod both.
  EXPECT_GE(interfaces, 18U);
  EXPECT_GT(part["interface_facets"].get<int>(), 1000);
}

TEST(ImportedAssembly, OfSolidsThatOverlapSaysSo) {
  TEDIT_NEEDS_CAD();
  const auto part = import_part(cad_parts + "overlapping_boxes.brep --size coarse");

  ASSERT_EQ(part["regions"].size(), 3U);
  for (const auto& region : part["regions"])
    EXPECT_NEAR(region["volume_m3"].get<double>(), 3e-6, 1e-14);  // Thirds of 15 x 20 x 30 mm.
  EXPECT_THAT(part["warnings"][0].get<std::string>(), HasSubstr("solids overlap (1)"));
}

TEST(ImportedPart, LosesAFaceThatIsTooNarrowAndNamesIt) {
  TEDIT_NEEDS_CAD();
  // The box with the edge at x = 10, y = 0 cut off by 0.01 mm.
  const auto part = import_part(cad_parts + "narrow_face.brep --size coarse");

  ASSERT_EQ(part["warnings"].size(), 1U);
  const auto said = part["warnings"][0].get<std::string>();
  ASSERT_THAT(said, HasSubstr("went into their neighbours (1): surface "));
  const int gone = std::stoi(said.substr(said.rfind(' ')));
  EXPECT_EQ(part["surfaces"].size(), 6U);
  for (const auto& surface : part["surfaces"])
    EXPECT_NE(surface["id"], gone);
  EXPECT_NEAR(part["surface_moved_m"].get<double>(), std::sqrt(2.0) * 1e-5, 1e-9);
  EXPECT_GT(part["radius_ratio"]["min"].get<double>(), 0.2);
  EXPECT_NEAR(part["volume_m3"].get<double>(), 6e-6, 6e-6 * 1e-3);
}

/// A block of 60 x 40 x 30 mm with a slot of 10 x 4 x 5 mm in its top, and a hole of 3.2 mm across
/// the slot, 0.3 mm above its floor.
TEST(ImportedPart, KeepsTheNarrowStripBetweenAHoleAndAnEdge) {
  TEDIT_NEEDS_CAD();
  const auto part = import_part(cad_parts + "narrow_strip.brep --size coarse");

  EXPECT_LT(part["surface_moved_m"].get<double>(), 1e-6);
  EXPECT_TRUE(part["warnings"].empty()) << part["warnings"];
  const double slot = 10 * 4 * 5;
  const double hole = std::numbers::pi * 1.6 * 1.6 * (7 - 4);
  // The hole is a polygon.
  EXPECT_NEAR(part["volume_m3"].get<double>() * 1e9, 60 * 40 * 30 - slot - hole, 0.2 * hole);
  EXPECT_GT(part["radius_ratio"]["min"].get<double>(), 0.05);
}

/// A box of 10 x 20 x 30 mm with an edge cut off by 0.1 mm, which a coarse mesh does not have.
TEST(ImportedPart, SaysWhereItsSurfaceMovedFar) {
  TEDIT_NEEDS_CAD();
  const auto part = import_part(cad_parts + "narrow_chamfer.brep --size coarse");

  EXPECT_NEAR(part["surface_moved_m"].get<double>(), std::sqrt(2.0) * 1e-4, 1e-9);
  ASSERT_EQ(part["warnings"].size(), 2U);
  EXPECT_THAT(part["warnings"][1].get<std::string>(),
              HasSubstr("the surface moved there by up to 0.141 mm"));
}

TEST(ImportedPart, IsEditedAndKeepsItsNames) {
  TEDIT_NEEDS_CAD();
  const auto mesh = scratch("block.msh").string();
  const auto closed = scratch("closed.msh").string();
  import_part(cad_parts + "inch_block.stp --size medium -o " + mesh);

  const auto edit = run("edit --json " + mesh + " --op fill_hole --surfaces 8,9 -o " + closed);

  ASSERT_EQ(edit.status, 0) << edit.out;
  const auto info = run("info --json " + closed).parsed();
  EXPECT_NEAR(info["volume_m3"].get<double>(), 6 * inch * inch * inch, 1e-11);
  EXPECT_EQ(info["surfaces"][1]["name"], "PartBody");
  EXPECT_EQ(info["regions"][0]["name"], "One Hole");
}

TEST(StepWithAnnotations, ThatKillTheReaderComesInWithoutThem) {
  TEDIT_NEEDS_CAD();
  auto text = text_of_file(cad_parts + "box.step");
  // OpenCASCADE 7.6.3 dies of a tolerance without a datum.
  text.insert(text.rfind("ENDSEC;"),
              "#9001=PERPENDICULARITY_TOLERANCE('eye','',#9002,#4,());\n"
              "#9002=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.1),#346);\n");
  const auto part = import_part(write_scratch("noted.step", text).string() + " --size coarse");

  EXPECT_NEAR(part["volume_m3"].get<double>(), 6e-6, 1e-14);
  EXPECT_THAT(part["warnings"][0].get<std::string>(),
              HasSubstr("annotations (tolerances, datums, notes) were left out, 1 in all"));
}

}  // namespace
}  // namespace tedit::test
