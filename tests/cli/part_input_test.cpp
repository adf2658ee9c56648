// SPDX-License-Identifier: AGPL-3.0-or-later
// Commands that work on a part take a document instead of a mesh file: its version, its load cases.
#include "tests/cli/program.hpp"

#include <fstream>

namespace tedit::test {
namespace {

namespace fs = std::filesystem;

/// A cube of 1 mm: version 1, the current one, was pulled to 1.25 mm; the load case "pull".
class PartInput : public ::testing::Test {
protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    fs::copy_file(TEDIT_TEST_DATA "/documents/cube_format_1.tedit", folder_ / "cube.tedit");
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::string cube() const { return at("cube.tedit"); }

  fs::path folder_ = scratch("part");
};

TEST_F(PartInput, InfoIsOfTheCurrentVersionOrTheOneThatIsNamed) {
  const auto now = run("info --json " + cube()).parsed();
  EXPECT_EQ(now["number"], 1);
  EXPECT_NEAR(now["volume_m3"].get<double>(), 1.25e-9, 1e-15);
  EXPECT_EQ(now["load_cases"], nlohmann::json({"pull"}));
  const auto first = run("info --json " + cube() + " --version 0").parsed();
  EXPECT_EQ(first["number"], 0);
  EXPECT_NEAR(first["volume_m3"].get<double>(), 1e-9, 1e-15);
  const auto none = run("info --json " + cube() + " --version 9").parsed();
  EXPECT_EQ(none["error"]["code"], "not_found");
}

TEST_F(PartInput, AVersionOfAMeshFileIsRefused) {
  const auto refused = run("info --json " + plate + " --version 1");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.parsed()["error"]["message"].get<std::string>(), HasSubstr("is a mesh"));
}

TEST_F(PartInput, ASolveTakesTheDocumentsOwnLoads) {
  const auto own = run("solve --json --device cpu " + cube());
  ASSERT_EQ(own.status, 0) << own.out;
  const auto report = own.parsed();
  EXPECT_EQ(report["load_case"], "pull");
  const auto mesh = at("cube.msh");
  const auto loads = at("pull.json");
  const auto written = run("convert --json " + cube() + " -o " + mesh + " --load-case " + loads);
  ASSERT_EQ(written.status, 0) << written.out;
  const auto apart = run("solve --json --device cpu " + mesh + " --load-case " + loads);
  ASSERT_EQ(apart.status, 0) << apart.out;
  EXPECT_NEAR(
    report["max_von_mises_pa"].get<double>() / apart.parsed()["max_von_mises_pa"].get<double>(), 1,
    1e-6);
  const auto named = run("solve --json --device cpu " + cube() + " --load-case pull");
  EXPECT_EQ(named.parsed()["max_von_mises_pa"], report["max_von_mises_pa"]);
}

TEST_F(PartInput, ALoadCaseThatIsNeitherFileNorOfTheDocumentNamesThoseThatAre) {
  const auto refused = run("solve --json " + cube() + " --load-case push");
  EXPECT_NE(refused.status, 0);
  EXPECT_THAT(refused.parsed()["error"]["remedy"].get<std::string>(), HasSubstr("pull"));
  const auto mesh = run("solve --json " + plate);
  EXPECT_EQ(mesh.status, 2);
  EXPECT_THAT(mesh.parsed()["error"]["message"].get<std::string>(), HasSubstr("--load-case"));
}

TEST_F(PartInput, AFileOfTheSameNameAsTheDocumentsCaseGetsAnother) {
  const auto loads = at("pull.json");
  ASSERT_EQ(run("convert " + cube() + " -o " + at("x.msh") + " --load-case " + loads).status, 0);
  const auto both =
    run("solve --json --device cpu " + cube() + " --load-case pull --load-case " + loads);
  ASSERT_EQ(both.status, 0) << both.out;
  const auto cases = both.parsed()["load_cases"];
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_NE(cases[0]["load_case"], cases[1]["load_case"]);
}

TEST_F(PartInput, SelectCheckPrintAdaptAndExportReadDocuments) {
  EXPECT_EQ(run("select --json " + cube() + " --neighbours 1").status, 0);
  const auto print = run("check-print --json " + cube()).parsed();
  EXPECT_TRUE(print["watertight"].get<bool>());
  const auto deck = run("export --json " + cube() + " -o " + at("cube.inp"));
  ASSERT_EQ(deck.status, 0) << deck.out;
  EXPECT_EQ(deck.parsed()["elements"], 6);
  const auto finer =
    run("adapt --json --device cpu " + cube() + " --rounds 1 -o " + at("finer.msh"));
  ASSERT_EQ(finer.status, 0) << finer.out;
  EXPECT_TRUE(fs::exists(at("finer.msh")));
}

TEST_F(PartInput, TwoDocumentsAreComparedOrADocumentWithAMesh) {
  fs::copy_file(cube(), at("other.tedit"));
  const auto same = run("compare --json " + cube() + " " + at("other.tedit")).parsed();
  EXPECT_EQ(same["before_id"], same["after_id"]);
  const auto then = run("compare --json --device cpu " + cube() + " " + at("other.tedit") +
                        " --from 0 --to 2 --load-case pull");
  ASSERT_EQ(then.status, 0) << then.out;
  EXPECT_NE(then.parsed()["before_id"], then.parsed()["after_id"]);
  EXPECT_EQ(then.parsed()["fields"].size(), 1U);
  ASSERT_EQ(run("convert " + cube() + " -o " + at("cube.msh")).status, 0);
  const auto mixed = run("compare --json " + cube() + " " + at("cube.msh"));
  ASSERT_EQ(mixed.status, 0) << mixed.out;
  EXPECT_EQ(run("compare --json " + at("cube.msh") + " " + cube() + " --from 0").status, 2);
}

}  // namespace
}  // namespace tedit::test
