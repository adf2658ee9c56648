// SPDX-License-Identifier: AGPL-3.0-or-later
// Files of all formats, as the program writes them.
#include "mesh/formats.hpp"
#include "tests/cli/program.hpp"

namespace tedit::test {
namespace {

TEST(Edit, ASuffixThatNoFormatHasIsRefusedBeforeTheWork) {
  const auto file = scratch("filled.step");

  const auto edit =
    run("edit --json " + plate + " --op fill_hole --surfaces 1,2 -o " + file.string());

  EXPECT_EQ(edit.status, 2);
  const auto said = edit.parsed()["error"];
  EXPECT_EQ(said["message"], "there is no file format \"step\" to write");
  EXPECT_THAT(said["remedy"].get<std::string>(), HasSubstr("Take msh, vtu"));
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Convert, WritesEachFormatThatItsHelpNames) {
  const auto help = run("convert --help").out;

  for (const auto one : written_formats()) {
    const std::string name(one);
    EXPECT_THAT(help, HasSubstr("." + name + " ("));
    if (name == "med" && !std::filesystem::exists(TEDIT_BIN "/tedit-med"))
      continue;  // Built without libmed.
    const auto file = scratch("plate." + name);
    const auto result = run("convert --json " + plate + " -o " + file.string());
    ASSERT_EQ(result.status, 0) << result.out;
    EXPECT_EQ(result.parsed()["format"], name);
    EXPECT_GT(std::filesystem::file_size(file), 10'000U);
  }
  EXPECT_EQ(run("convert " + plate + " -o " + scratch("plate").string()).status, 2);
}

TEST(Convert, ChangesTheUnitAndKeepsTheVersion) {
  const auto file = scratch("metres.msh");

  ASSERT_EQ(run("convert " + plate + " --output-unit m -o " + file.string()).status, 0);

  EXPECT_EQ(run("info --json --length-unit m " + file.string()).parsed()["volume_m3"],
            run("info --json " + plate).parsed()["volume_m3"]);
}

TEST(Edit, APathOfAFileParameterIsReadHere) {
  const auto none = run("edit --json " + plate + " --op combine --param file=/nowhere/knob.stl");
  const auto other =
    run("edit --json " + plate +
        " --op combine --param file=" TEDIT_TEST_DATA "/parts/ctc01_plate/features.json");

  EXPECT_THAT(none.parsed()["error"].value("message", ""),
              HasSubstr("/nowhere/knob.stl is not there"));
  EXPECT_NE(none.status, 0);
  EXPECT_NE(other.status, 0);
  EXPECT_THAT(other.parsed()["error"].value("message", ""),
              HasSubstr("\"features.json\" is of no kind that can be combined"));
}

TEST(Formats, AreListedWithWhatTheyKeep) {
  const auto listed = run("formats --json").parsed()["formats"];

  ASSERT_GE(listed.size(), file_formats.size());
  for (std::size_t i = 0; i < file_formats.size(); ++i) {
    EXPECT_EQ(listed[i]["name"], file_formats[i].name);
    EXPECT_EQ(listed[i]["reads"], file_formats[i].reads);
    EXPECT_EQ(listed[i]["writes"], file_formats[i].writes);
  }
  EXPECT_EQ(listed[0]["keeps"], (std::vector<std::string>{"tets", "regions", "surfaces", "names"}));
  EXPECT_THAT(run("formats").out, HasSubstr("a STEP file"));
}

}  // namespace
}  // namespace tedit::test
