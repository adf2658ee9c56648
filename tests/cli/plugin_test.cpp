// SPDX-License-Identifier: AGPL-3.0-or-later
// "tedit plugin" as a person or a script uses it.
#include "tests/cli/program.hpp"

namespace tedit::test {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// An empty folder of the running test.
fs::path fresh_folder() {
  const auto folder = scratch("new");
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

TEST(PluginNew, MakesAFolderWithoutPlaceholders) {
  const auto folder = fresh_folder();

  const auto made = run("plugin new my_offset --dir " + folder.string() + " --json");

  EXPECT_EQ(made.status, 0);
  const auto told = made.parsed();
  EXPECT_EQ(told["folder"], (folder / "my_offset").string());
  for (const auto& file : told["files"])
    EXPECT_THAT(content(folder / "my_offset" / file.get<std::string>()),
                ::testing::Not(::testing::ContainsRegex("@[A-Z_]+@")));
  EXPECT_THAT(content(folder / "my_offset/operation.cpp"), HasSubstr("TEDIT_PLUGIN(\"my_offset\""));
  EXPECT_THAT(content(folder / "my_offset/operation.cpp"), HasSubstr("\"My offset\""));
  EXPECT_THAT(content(folder / "my_offset/tests/my_offset_test.cpp"), HasSubstr("TEST(MyOffset,"));
  EXPECT_THAT(content(folder / "my_offset/CMakeLists.txt"), HasSubstr("NAME my_offset"));
  EXPECT_THAT(content(folder / "my_offset/README.md"), HasSubstr("cmake -B build"));
}

TEST(PluginNew, RefusesWhatItCannotMakeWithAReason) {
  const auto folder = fresh_folder();
  const auto at = " --json --dir " + folder.string();
  for (const char* name : {"MyOp", "my-op", "1op", "my__op", "_op", "op_", "../op", "é"}) {
    const auto refused = run("plugin new \"" + std::string(name) + "\"" + at);
    EXPECT_EQ(refused.status, 2) << name;
    EXPECT_THAT(refused.parsed()["error"]["message"].get<std::string>(), HasSubstr("snake_case"));
  }
  EXPECT_EQ(run("plugin new " + std::string(41, 'a') + at).status, 2);
  EXPECT_TRUE(fs::is_empty(folder)) << "refusals leave nothing behind";

  ASSERT_EQ(run("plugin new twice" + at).status, 0);
  std::ofstream(folder / "twice/operation.cpp") << "mine";
  const auto again = run("plugin new twice" + at);
  EXPECT_NE(again.status, 0);
  EXPECT_THAT(again.parsed()["error"]["message"].get<std::string>(), HasSubstr("there already"));
  EXPECT_EQ(content(folder / "twice/operation.cpp"), "mine");
}

TEST(PluginTest, TheBuiltInOperationKeepsTheRulesOnAPart) {
  const auto tested =
    run("plugin test " TEDIT_BIN "/../lib/tedit/plugins/fill_hole.so --json --mesh " + parts +
        "holes_block/holes_block.coarse.msh");

  EXPECT_EQ(tested.status, 0);
  const auto json = tested.parsed();
  EXPECT_EQ(json["ok"], true);
  EXPECT_GE(json["checks"].size(), 45u);
  for (const auto& row : json["checks"])
    EXPECT_EQ(row["outcome"], "pass") << row.dump();
}

TEST(PluginTest, AFileThatIsNotThereIsNamed) {
  const auto refused = run("plugin test /nowhere/x.so --json");

  EXPECT_EQ(refused.parsed()["error"]["code"], "io_error");
  EXPECT_NE(refused.status, 0);
}

TEST(PluginTest, ASelectionNeedsItsMesh) {
  const auto refused =
    run("plugin test " TEDIT_BIN "/../lib/tedit/plugins/fill_hole.so --select 5 --json");

  EXPECT_EQ(refused.parsed()["error"]["code"], "surface_not_found");
}

TEST(PluginTest, TheManualNamesEveryCheck) {
  const auto list = run("plugin test --list --json").parsed();
  const auto manual = content(TEDIT_SOURCE_DIR "/docs/plugins.md");

  ASSERT_GE(list["checks"].size(), 45u);
  for (const auto& row : list["checks"])
    EXPECT_THAT(manual, HasSubstr("`" + row["check"].get<std::string>() + "`"));
}

}  // namespace
}  // namespace tedit::test
