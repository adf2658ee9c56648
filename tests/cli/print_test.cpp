// SPDX-License-Identifier: AGPL-3.0-or-later
// Files for printing, and the checks before it, as the program makes them.
#include "tests/cli/program.hpp"

namespace tedit::test {
namespace {

const std::string cube = TEDIT_TEST_DATA "/bad/good_six_tets_cube.msh";

TEST(CheckPrint, ACubeIsWatertightAndStandsOnItsPlate) {
  const auto result = run("check-print --json --strict " + cube);

  ASSERT_EQ(result.status, 0) << result.out;
  const auto report = result.parsed();
  EXPECT_TRUE(report["watertight"].get<bool>());
  EXPECT_EQ(report["bodies"], 1);
  EXPECT_FALSE(report["findings"].get<bool>());
  EXPECT_FALSE(report.contains("thin"));
  const double side = report["high_m"][0].get<double>() - report["low_m"][0].get<double>();
  EXPECT_NEAR(report["plate_area_m2"].get<double>(), side * side, 1e-12);
  EXPECT_NEAR(report["area_m2"].get<double>(), 6 * side * side, 1e-12);
}

TEST(CheckPrint, StrictIsAnExitStatusAndMarksAreInTheFile) {
  const auto file = scratch("marked.ply");
  const auto asked =
    "check-print " + plate + " --thinner-than 20 --overhang 30 --direction 0,1,0 -o ";

  const auto result = run(asked + file.string());

  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, HasSubstr("thickness mm"));
  EXPECT_THAT(result.out, HasSubstr("lean degrees"));
  EXPECT_EQ(run("--quiet " + asked + file.string() + " --strict").status, 1);
  EXPECT_EQ(run(asked + scratch("marked.stl").string()).status, 2);
  EXPECT_EQ(run("check-print " + plate + " --direction 0,0,0").status, 1);
  EXPECT_EQ(run("check-print " + plate + " --direction 0,nan,1").status, 2);
  std::ifstream in(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  EXPECT_THAT(bytes.substr(0, 400), HasSubstr("property uchar red"));
  EXPECT_THAT(bytes, HasSubstr("\xD6\x28\x28"));
}

TEST(Convert, ColoursAFieldOfASolvedMeshAndRefusesWhatCannotHoldIt) {
  const auto solved = scratch("solved.vtu").string();
  const auto file = scratch("solved.3mf").string();
  ASSERT_EQ(
    run("solve --order 1 " + plate + " --load-case " + plate_loads + " -o " + solved).status, 0);

  const auto result = run("convert --json " + solved + " --colour von_mises -o " + file);
  ASSERT_EQ(result.status, 0) << result.out;
  const auto colours = result.parsed()["colours"];
  EXPECT_EQ(colours["by"], "von_mises_pa");
  EXPECT_GE(colours["least"].get<double>(), 0);
  EXPECT_GT(colours["most"].get<double>(), 1e6);
  EXPECT_GT(std::filesystem::file_size(file), 10'000U);

  const auto unknown = run("convert --json " + solved + " --colour temperature -o " + file);
  EXPECT_THAT(unknown.parsed()["error"].value("remedy", ""), HasSubstr("von_mises_pa"));
  const auto bare = run("convert --json " + plate + " --colour von_mises -o " + file);
  EXPECT_THAT(bare.parsed()["error"].value("message", ""), HasSubstr("no VTU file"));
  const auto flat = run("convert --json " + solved + " --colour von_mises -o " + file + ".stl");
  EXPECT_EQ(flat.status, 2);
  EXPECT_EQ(flat.parsed()["error"]["message"], "a .stl file has no colours");
}

}  // namespace
}  // namespace tedit::test
