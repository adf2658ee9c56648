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
  const auto cases = both.parsed()["cases"];
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

TEST_F(PartInput, AMeshWithItsLoadsBecomesADocument) {
  const auto made =
    run("import --json " + plate + " --load-case " + plate_loads + " -o " + at("plate.tedit"));
  ASSERT_EQ(made.status, 0) << made.out;
  EXPECT_EQ(made.parsed()["load_cases"].size(), 1U);
  EXPECT_EQ(made.parsed()["length_unit"], "mm");
  const auto own = run("solve --json --device cpu --order 1 " + at("plate.tedit")).parsed();
  const auto apart =
    run("solve --json --device cpu --order 1 " + plate + " --load-case " + plate_loads).parsed();
  EXPECT_EQ(own["version_id"], apart["version_id"]);
  EXPECT_EQ(own["max_von_mises_pa"], apart["max_von_mises_pa"]);
  const auto edited = run("edit --json " + at("plate.tedit") +
                          " --op fill_hole --surfaces 1,2 -o " + at("next.tedit"));
  ASSERT_EQ(edited.status, 0) << edited.out;
  EXPECT_EQ(run("info --json " + at("next.tedit")).parsed()["load_cases"],
            made.parsed()["load_cases"]);
  EXPECT_EQ(run("import " + plate + " -o " + at("plate.tedit")).status, 1) << "written over";
}

TEST_F(PartInput, ADeckBringsItsOwnLoads) {
  ASSERT_EQ(run("export " + cube() + " --order 1 -o " + at("cube.inp")).status, 0);
  const auto made = run("import --json " + at("cube.inp") + " -o " + at("deck.tedit"));
  ASSERT_EQ(made.status, 0) << made.out;
  EXPECT_EQ(made.parsed()["load_cases"].size(), 1U);
  EXPECT_EQ(made.parsed()["length_unit"], "m");
  EXPECT_EQ(run("solve --json --device cpu " + at("deck.tedit")).status, 0);
}

TEST_F(PartInput, WhatDoesNotGoWithAMeshIsRefusedAndNothingIsLeft) {
  ASSERT_EQ(run("convert " + cube() + " -o " + at("cube.msh")).status, 0);
  const std::tuple<std::string, const char*, const char*> wrong[] = {
    {" --load-case " + plate_loads + " -o " + at("new.tedit"), "surface_not_found",
     "names surface"},
    {" --load-case " + plate_loads + " -o " + at("new.msh"), "usage", "goes into a document"},
    {" --size fine -o " + at("new.tedit"), "usage", "has its sizes already"},
    {" --local-size 1=2 -o " + at("new.tedit"), "usage", "has its sizes already"},
  };
  for (const auto& [options, code, words] : wrong) {
    const auto refused = run("import --json " + at("cube.msh") + options).parsed();
    EXPECT_EQ(refused["error"]["code"], code) << options;
    EXPECT_THAT(refused["error"]["message"].get<std::string>(), HasSubstr(words)) << options;
    EXPECT_FALSE(fs::exists(at("new.tedit")) || fs::exists(at("new.msh"))) << options;
  }
}

TEST_F(PartInput, LoadCasesOfADocumentAreSetAndRemoved) {
  const auto loads = at("pull.json");
  ASSERT_EQ(run("convert " + cube() + " -o " + at("x.msh") + " --load-case " + loads).status, 0);
  auto harder = json::parse(std::ifstream(loads));
  harder["name"] = "harder";
  std::ofstream(at("harder.json")) << harder.dump();

  const auto listed = run("doc loads --json " + cube()).parsed();
  ASSERT_EQ(listed["load_cases"].size(), 1U);
  EXPECT_EQ(listed["load_cases"][0]["name"], "pull");
  const auto set = run("doc loads --json " + cube() + " --set " + at("harder.json")).parsed();
  EXPECT_EQ(set["load_cases"].size(), 2U);
  const auto again = run("doc loads --json " + cube() + " --set " + at("harder.json")).parsed();
  EXPECT_EQ(again["load_cases"].size(), 2U) << "it takes the place of the one of its name";
  const auto both = run("info --json " + cube()).parsed();
  EXPECT_EQ(both["load_cases"], json({"pull", "harder"}));
  EXPECT_EQ(run("doc loads --json " + cube() + " --remove pull").status, 0);
  EXPECT_EQ(run("info --json " + cube()).parsed()["load_cases"], json({"harder"}));
  const auto none = run("doc loads --json " + cube() + " --remove pull").parsed();
  EXPECT_EQ(none["error"]["code"], "not_found");
  const auto foreign = run("doc loads --json " + cube() + " --set " + plate_loads).parsed();
  EXPECT_EQ(foreign["error"]["code"], "surface_not_found");
  EXPECT_EQ(run("info --json " + cube()).parsed()["load_cases"], json({"harder"}));
  EXPECT_EQ(run("doc check " + cube()).status, 0);
}

}  // namespace
}  // namespace tedit::test
