// SPDX-License-Identifier: AGPL-3.0-or-later
// What the tables hold together, and what is no file at all.
#include <sys/stat.h>

#include <algorithm>
#include <set>

#include <gmock/gmock.h>

#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"
#include "tests/broken/table.hpp"
#include "tests/support/scratch.hpp"

namespace tedit::test {
namespace {

using ::testing::HasSubstr;

const std::vector<std::string> tables{"msh",  "vtu",       "inp",    "bdf", "unv",  "med",
                                      "stl",  "obj",       "ply",    "3mf", "step", "iges",
                                      "brep", "load_case", "recipe", "csv", "tedit"};

TEST(BrokenFiles, AreThreeHundredAtLeastAndNoneIsThereTwice) {
  std::size_t refused = 0;
  for (const auto& table : tables) {
    std::set<std::string> names;
    std::set<std::string> contents;
    for (const auto& file : broken_files(table)) {
      refused += !file.is_taken;
      EXPECT_TRUE(names.insert(file.name).second) << table << ": " << file.name;
      EXPECT_TRUE(contents.insert(file.bytes).second) << table << ": " << file.name;
    }
  }
  EXPECT_GE(refused, 300U);
}

TEST(NoFileAtAll, IsToldWithItsPathAndARemedy) {
  const scratch_folder folder;
  const auto pipe = folder.path() / "pipe.msh";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::pair<std::filesystem::path, const char*> rows[] = {
    {folder.path(), "it is no regular file"},
    {pipe, "it is no regular file"},
    {folder.path() / "none.msh", "there is no such file"}};
  for (const auto& [path, words] : rows) {
    const auto mesh = import_mesh(path, "mm");

    ASSERT_FALSE(mesh.has_value());
    EXPECT_EQ(mesh.error().code, ec::io_error);
    EXPECT_THAT(mesh.error().message, HasSubstr(path.string()));
    EXPECT_THAT(mesh.error().message, HasSubstr(words));
    EXPECT_NE(mesh.error().remedy, "");
  }
}

/// A pipe into which nobody writes must not be waited for.
TEST(NoFileAtAll, IsNoLoadCase) {
  const scratch_folder folder;
  const auto pipe = folder.path() / "pipe.json";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const auto& path : {folder.path(), pipe}) {
    const auto loads = protocol::load_case_from_file(path);

    ASSERT_FALSE(loads.has_value());
    EXPECT_EQ(loads.error().code, ec::io_error);
    EXPECT_THAT(loads.error().message, HasSubstr(path.string()));
    EXPECT_NE(loads.error().remedy, "");
  }
}

}  // namespace
}  // namespace tedit::test
