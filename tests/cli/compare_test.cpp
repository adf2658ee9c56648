// SPDX-License-Identifier: AGPL-3.0-or-later
// "tedit compare": two meshes, or two versions of a document, and their stress.
#include "tests/cli/program.hpp"

namespace tedit::test {
namespace {

namespace fs = std::filesystem;

/// The plate with one drill hole closed.
std::string filled_plate() {
  const auto file = scratch("filled.msh").string();
  EXPECT_EQ(run("edit " + plate + " --op fill_hole --surfaces 1,2 -o " + file).status, 0);
  return file;
}

TEST(Compare, APartWithItselfIsTheSame) {
  const auto got = run("compare " + plate + " " + plate + " --json");
  ASSERT_EQ(got.status, 0) << got.out;
  const auto all = got.parsed();
  EXPECT_EQ(all["before_id"], all["after_id"]);
  EXPECT_EQ(all["tets_in_common"], all["before"]["tets"]);
  EXPECT_EQ(all["deviation_m"], 0);
  for (const auto& one : all["surfaces"])
    EXPECT_FALSE(one["changed"]) << one;
}

TEST(Compare, SaysWhatAnEditChanged) {
  const auto filled = filled_plate();
  const auto got = run("compare " + plate + " " + filled + " --load-case " + plate_loads +
                       " --order 1 --device cpu -o " + scratch("d.vtu").string() + " --json");
  ASSERT_EQ(got.status, 0) << got.out;
  const auto all = got.parsed();
  EXPECT_GT(all["after"]["volume_m3"], all["before"]["volume_m3"]);
  EXPECT_GT(all["tets_in_common"], all["before"]["tets"].get<int>() / 2);
  EXPECT_LT(all["tets_in_common"], all["before"]["tets"]);
  int gone = 0;
  for (const auto& one : all["surfaces"])
    gone += one["where"] == "only_before";
  EXPECT_EQ(gone, 2) << "the two walls of the hole";
  ASSERT_EQ(all["fields"].size(), 1U);
  const auto& field = all["fields"][0];
  EXPECT_GT(field["vertices"]["same"], 0);
  EXPECT_LE(field["von_mises_fall"]["change_pa"], 0);
  EXPECT_GE(field["von_mises_rise"]["change_pa"], 0);
  EXPECT_GT(fs::file_size(scratch("d.vtu")), 0U);

  const auto again = run("compare " + filled + " " + plate + " --json").parsed();
  EXPECT_EQ(again["tets_in_common"], all["tets_in_common"]);
  EXPECT_EQ(again["before_id"], all["after_id"]);
  EXPECT_DOUBLE_EQ(again["deviation_m"], all["deviation_m"]);
}

/// Of the versions of a document; the file stays as it is.
TEST(Compare, VersionsOfADocumentAreReadFromTheFile) {
  const auto file = scratch("cube.tedit");
  fs::copy_file(TEDIT_TEST_DATA "/documents/cube_format_1.tedit", file,
                fs::copy_options::overwrite_existing);
  const auto before = fs::last_write_time(file);
  const auto got = run("compare " + file.string() + " --from 0 --to 2 --json");
  ASSERT_EQ(got.status, 0) << got.out;
  EXPECT_NE(got.parsed()["before_id"], got.parsed()["after_id"]);
  const auto head = run("compare " + file.string() + " --json").parsed();
  EXPECT_NE(head["after_id"], got.parsed()["after_id"]) << "the head is version 1";
  EXPECT_EQ(fs::last_write_time(file), before);
  EXPECT_FALSE(fs::exists(file.string() + "-wal"));
}

TEST(Compare, SaysWhatDoesNotFit) {
  const auto document = std::string("'" TEDIT_TEST_DATA "/documents/cube_format_1.tedit'");
  const std::tuple<std::string, int, const char*> wrong[] = {
    {plate, 2, "a second mesh file is needed"},
    {plate + " " + plate + " --from 1", 2, "--from and --to"},
    {plate + " " + plate + " -o d.vtu", 2, "no load case is given"},
    {plate + " " + document + " --from 1", 2, "--from and --to"},
    {document + " " + plate + " --to 1", 2, "--from and --to"},
    {document + " --from 7", 1, "there is no version 7"},
    {document + " --load-case nothing", 1, "has no load case"},
    {plate + " /nowhere.msh", 65, "nowhere.msh"},
  };
  for (const auto& [arguments, status, words] : wrong) {
    const auto got = run("compare " + arguments + " --json 2>&1 ");
    EXPECT_NE(got.status, 0) << arguments;
    EXPECT_THAT(got.out, HasSubstr(words)) << arguments;
  }
}

}  // namespace
}  // namespace tedit::test
