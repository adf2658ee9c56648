// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/cli/program.hpp"

namespace tedit::test {
namespace {

TEST(Run, CarriesOutARecipeWithUndo) {
  const auto file = scratch("recipe.json");
  std::ofstream(file) << json{{"device", "cpu"},
                              {"steps",
                               {{{"import", {{"mesh", plate}}}},
                                {{"load_case", {{"file", plate_loads}}}},
                                {{"edit", {{"operation", "fill_hole"}, {"surfaces", {1, 2}}}}},
                                {{"undo", json::object()}},
                                {{"solve", json::object()}},
                                {{"export", {{"msh", "v{version}.msh"}}}}}}};

  const auto result = run("run --json " + file.string() + " --out " + scratch("out").string());

  ASSERT_EQ(result.status, 0);
  const auto steps = result.parsed()["steps"];
  // Undo gives back the very version that was imported.
  EXPECT_EQ(steps[0]["version_id"], steps[3]["version_id"]);
  EXPECT_EQ(steps[4]["version_id"], steps[0]["version_id"]);
  EXPECT_TRUE(std::filesystem::exists(scratch("out") / "v0.msh"));
}

TEST(Run, ARecipeComparesVersionsAndWritesTheirDifference) {
  const auto file = scratch("recipe.json");
  json steps{{{"import", {{"mesh", plate}}}},
             {{"load_case", {{"file", plate_loads}}}},
             {{"solve", json::object()}},
             {{"edit", {{"operation", "fill_hole"}, {"surfaces", {1, 2}}}}},
             {{"solve", json::object()}}};
  std::ifstream in(plate_loads);
  const auto name = json::parse(in)["name"];
  const auto carried_out = [&](const json& compare) {
    auto all = steps;
    all.push_back({{"compare", compare}});
    std::ofstream(file) << json{{"device", "cpu"}, {"order", 1}, {"steps", all}};
    return run("run --json " + file.string() + " --out " + scratch("compared").string());
  };

  const auto result = carried_out(
    {{"before", 0}, {"load_case", name}, {"json", "d{version}.json"}, {"vtu", "d.vtu"}});
  ASSERT_EQ(result.status, 0) << result.out;
  const auto all = result.parsed()["steps"][5];
  EXPECT_EQ(all["step"], "compare");
  EXPECT_EQ(all["after_number"], 1);
  EXPECT_GT(all["after"]["volume_m3"], all["before"]["volume_m3"]);
  ASSERT_EQ(all["fields"].size(), 1U) << all;
  EXPECT_EQ(all["fields"][0]["load_case"], name);
  EXPECT_EQ(result.parsed()["files"].size(), 2U);
  std::ifstream figures(scratch("compared") / "d1.json");
  EXPECT_EQ(json::parse(figures)["after_id"], all["after_id"]);
  std::ifstream vtu(scratch("compared") / "d.vtu", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(vtu), {}};
  for (const auto* array : {"difference_mark", "von_mises_pa_difference"})
    EXPECT_NE(bytes.find("Name=\"" + std::string(array) + "\""), std::string::npos) << array;

  const auto unnamed = carried_out({{"before", 0}, {"vtu", "d.vtu"}});
  EXPECT_EQ(unnamed.status, 65) << unnamed.out;
  EXPECT_NE(unnamed.out.find("no load case is named"), std::string::npos);
  const auto unknown = carried_out({{"before", 7}});
  EXPECT_EQ(unknown.status, 1) << unknown.out;
  EXPECT_NE(unknown.out.find("step 6 (compare): there is no version 7"), std::string::npos);
  steps.erase(2);
  const auto unsolved = carried_out({{"before", 0}, {"load_case", name}});
  EXPECT_EQ(unsolved.status, 1) << unsolved.out;
  EXPECT_NE(unsolved.out.find("no field of version 0 is at hand"), std::string::npos);
}

TEST(Run, ARecipeSaysWhatBecomesOfLoads) {
  const auto file = scratch("recipe.json");
  const auto loads = scratch("bore.json");
  std::ifstream in(plate_loads);
  auto on_bore = json::parse(in);
  on_bore["loads"][0]["surfaces"] = {1, 2};
  std::ofstream(loads) << on_bore;
  const auto with = [&](const json& policy) {
    json edit{{"operation", "fill_hole"}, {"surfaces", {1, 2}}, {"loads", policy}};
    std::ofstream(file) << json{{"steps",
                                 {{{"import", {{"mesh", plate}}}},
                                  {{"load_case", {{"file", loads}}}},
                                  {{"edit", std::move(edit)}}}}};
    return run("run --json " + file.string() + " --out " + scratch("out").string());
  };

  const auto moved = with("move");
  const auto misspelt = with("moved");

  ASSERT_EQ(moved.status, 0) << moved.out;
  EXPECT_EQ(moved.parsed()["steps"][2]["receipt"][1]["fate"], "moved") << moved.out;
  EXPECT_EQ(with("refuse").status, 1);
  EXPECT_EQ(misspelt.status, 65);
  EXPECT_NE(misspelt.parsed()["error"]["message"].get<std::string>().find("policy"),
            std::string::npos);
}

/// A recipe on the plate with two load cases, the second with twice the force.
json two_cases(const std::filesystem::path& doubled, json steps) {
  std::ifstream in(plate_loads);
  auto loads = json::parse(in);
  loads["name"] = "doubled";
  for (auto& load : loads["loads"])
    load["force"]["total_n"]["z"] = 2 * load["force"]["total_n"]["z"].get<double>();
  std::ofstream(doubled) << loads;
  json all{{{"import", {{"mesh", plate}}}},
           {{"load_case", {{"file", plate_loads}}}},
           {{"load_case", {{"file", doubled}}}}};
  for (auto& step : steps)
    all.push_back(std::move(step));
  return {{"device", "cpu"}, {"order", 1}, {"steps", std::move(all)}};
}

TEST(Run, SeveralLoadCasesHaveRowsAnEnvelopeAndAFile) {
  const auto file = scratch("recipe.json");
  std::ofstream(file) << two_cases(scratch("doubled.json"),
                                   {{{"solve", {{"load_cases", "all"}}}},
                                    {{"edit", {{"operation", "fill_hole"}, {"surfaces", {1, 2}}}}},
                                    {{"solve", {{"load_cases", "all"}}}},
                                    {{"export", {{"vtu", "v{version}.vtu"}}}},
                                    {{"solve", {{"load_cases", {"doubled"}}}}}});

  const auto out = " --out " + scratch("out").string();
  const auto result = run("run --json " + file.string() + out);
  const auto text = run("run " + file.string() + out);

  ASSERT_EQ(result.status, 0) << result.out;
  const auto steps = result.parsed()["steps"];
  const auto both = steps[5];
  ASSERT_EQ(both["cases"].size(), 2u);
  EXPECT_EQ(both["cases"][1]["load_case"], "doubled");
  EXPECT_EQ(both["cases"][1]["version_id"], steps[4]["to_version"]);
  EXPECT_EQ(both["envelope"]["max_von_mises_pa"], both["cases"][1]["max_von_mises_pa"]);
  EXPECT_EQ(both["envelope"]["max_von_mises_case"], "doubled");
  EXPECT_EQ(both["envelope"]["min_safety_factor"], both["cases"][1]["min_safety_factor"]);
  EXPECT_NEAR(both["envelope"]["max_displacement_m"],
              2 * both["cases"][0]["max_displacement_m"].get<double>(), 1e-9);
  EXPECT_TRUE(both["timings_ms"].contains("solve"));
  // A step with other settings is solved anew, with the load case that it names.
  EXPECT_EQ(steps[6]["load_case"], "doubled");
  EXPECT_FALSE(steps[6]["from_cache"]);
  EXPECT_FALSE(steps[6].contains("cases"));
  std::ifstream vtu(scratch("out") / "v1.vtu", std::ios::binary);
  EXPECT_THAT((std::string{std::istreambuf_iterator<char>(vtu), {}}),
              HasSubstr("Name=\"von_mises_pa (doubled)\""));
  ASSERT_EQ(text.status, 0);
  EXPECT_THAT(text.out, HasSubstr("field of v1: doubled"));
  EXPECT_THAT(text.out, HasSubstr("field of v1: worst"));
  EXPECT_THAT(text.out, HasSubstr("worst of all load cases:\n"));
}

TEST(Run, ASolveStepMayStopByEnergy) {
  const auto file = scratch("recipe.json");
  auto recipe = two_cases(scratch("doubled.json"),
                          {{{"solve", {{"energy_tolerance", 1e-2}}}}, {{"solve", json::object()}}});
  recipe["order"] = 2;
  std::ofstream(file) << recipe;

  const auto result = run("run --json " + file.string());

  ASSERT_EQ(result.status, 0) << result.out;
  const auto steps = result.parsed()["steps"];
  EXPECT_TRUE(steps[3]["preview"]);
  EXPECT_FALSE(steps[4]["preview"]);
  EXPECT_LE(steps[4]["true_relative_residual"], 1e-6);
  EXPECT_GT(steps[3]["true_relative_residual"], 1e-6);
}

TEST(Run, WrongLoadCasesOfASolveStepAreNamed) {
  const auto file = scratch("recipe.json");
  for (const auto& [given, words] :
       {std::pair<json, std::string>{"some", "\"load_cases\" must be a list"},
        {json::array({1, 2}), "\"load_cases\" must be a list"},
        {json::array({"doubled", "none"}), "\"none\""}}) {
    std::ofstream(file) << two_cases(scratch("doubled.json"),
                                     {{{"solve", {{"load_cases", given}}}}});
    const auto result = run("run --json " + file.string());
    EXPECT_NE(result.status, 0);
    EXPECT_THAT(result.parsed()["error"]["message"], HasSubstr(words));
  }
}

TEST(Run, NumbersOutOfRangeAreNamedAndNoneIsCutOff) {
  const auto file = scratch("recipe.json");
  const auto message = [&](const std::string& recipe) {
    std::ofstream(file) << recipe;
    const auto result = run("run --json " + file.string());
    EXPECT_EQ(result.status, 65) << recipe;
    return result.parsed()["error"]["message"].get<std::string>();
  };
  const auto step = [&](const std::string& body) { return message("{\"steps\": [" + body + "]}"); };

  EXPECT_THAT(message(R"({"order": 1.9, "steps": []})"), HasSubstr("\"order\" must be a whole"));
  EXPECT_THAT(message(R"({"tolerance": 0.5, "steps": []})"), HasSubstr("1e-12 to 0.1"));
  EXPECT_THAT(message(R"({"tolerance": 1e999, "steps": []})"), HasSubstr("no JSON"));
  EXPECT_THAT(step(R"({"solve": {"energy_tolerance": 7}})"), HasSubstr("1e-09 to 0.5"));
  EXPECT_THAT(step(R"({"export": {"png": "a.png", "range_mpa": [9, 1]}})"), HasSubstr("smaller"));
  EXPECT_THAT(step(R"({"edit": {"operation": "erode", "surfaces": [18446744073709551615]}})"),
              HasSubstr("\"surfaces\" must be a whole number"));
  EXPECT_THAT(step(R"({"edit": {"operation": "erode", "parameters": {"depth": 1e300}}})"),
              HasSubstr("parameter \"depth\" is 1e+300"));
}

TEST(Run, ATypingMistakeInARecipeIsNamed) {
  const auto file = scratch("recipe.json");
  std::ofstream(file) << R"({"steps": [{"import": {"mash": "a.msh", "mesh": "a.msh"}}]})";

  const auto result = run("run --json " + file.string());

  EXPECT_EQ(result.status, 65);
  EXPECT_THAT(result.parsed()["error"]["message"], HasSubstr("mash"));
}

/// All that the program says to people.
std::string said(const std::string& arguments) {
  const auto file = scratch("said");
  (void)std::system((program + " " + arguments + " >/dev/null 2>" + file.string()).c_str());
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Run, AListOfStepsAloneWorksOnTheMeshThatIsGiven) {
  const auto file = scratch("steps.json");
  std::ifstream loads(plate_loads);
  std::ofstream(file) << json{{{"load_case", json::parse(loads)}},
                              {{"select", {1, 2}}},
                              {{"edit", {{"operation", "fill_hole"}, {"surfaces", {1, 2}}}}},
                              {{"undo", true}},
                              {{"go_to", 1}},
                              {{"wait", "final"}}};
  const auto with = " --mesh " + plate;

  const auto result = run("run --json " + file.string() + with);

  ASSERT_EQ(result.status, 0) << result.out;
  const auto steps = result.parsed()["steps"];
  ASSERT_EQ(steps.size(), 5u);
  EXPECT_EQ(steps[0]["step"], "import");
  EXPECT_EQ(steps[1]["name"], json::parse(std::ifstream(plate_loads))["name"]);
  EXPECT_EQ(steps[3]["version_id"], steps[0]["version_id"]);
  EXPECT_EQ(steps[4]["step"], "goto");
  EXPECT_EQ(steps[4]["version_id"], steps[2]["version_id"]);
  EXPECT_EQ(result.parsed()["passed_over"], 2);
  EXPECT_THAT(said("run " + file.string() + with),
              HasSubstr("passed over 2 steps that only the window carries out"));
}

TEST(Run, ARecipeHasOneMeshFromInsideOrOutside) {
  const auto file = scratch("recipe.json");
  const auto message = [&](const json& steps, const std::string& options) {
    std::ofstream(file) << steps;
    const auto result = run("run --json " + file.string() + options);
    EXPECT_EQ(result.status, 65) << result.out;
    const auto error = result.parsed()["error"];
    return error["message"].get<std::string>() + ": " + error["remedy"].get<std::string>();
  };
  const json solve{{"solve", json::object()}};
  const json import{{"import", {{"mesh", plate}}}};

  EXPECT_THAT(message(json::array({solve}), ""), HasSubstr("--mesh PART.msh"));
  EXPECT_THAT(message(json::array({import, solve}), " --mesh " + plate), HasSubstr("Leave --mesh"));
}

TEST(Run, WhatChangesThePartInTheWindowAloneIsRefusedBeforeAnythingIsDone) {
  const auto file = scratch("steps.json");
  for (const json& step : {json{{"apply", "fill_hole"}}, json{{"command", "edit.undo"}},
                           json{{"command", "loads.remove"}}}) {
    std::ofstream(file) << json{{{"select", {1, 2}}}, step};
    const auto result = run("run --json " + file.string() + " --mesh /nowhere.msh");
    EXPECT_EQ(result.status, 65);
    const auto error = result.parsed()["error"];
    EXPECT_THAT(error["message"], HasSubstr("step 2 (" + step.begin().key() + ")")) << result.out;
    EXPECT_THAT(error["remedy"], HasSubstr("Write")) << result.out;
  }
}

TEST(Run, ChangedLoadsAreSolvedAnewOnTheSameVersion) {
  const auto file = scratch("recipe.json");
  std::ifstream in(plate_loads);
  auto twice = json::parse(in);
  auto& force = twice["loads"][0]["force"]["total_n"]["z"];
  force = 2 * force.get<double>();
  const json solve{{"solve", json::object()}};
  json steps{{{"import", {{"mesh", plate}}}},
             {{"load_case", {{"file", plate_loads}}}},
             solve,
             {{"load_case", twice}},
             solve};
  const auto carried_out = [&] {
    std::ofstream(file) << json{{"device", "cpu"}, {"order", 1}, {"steps", steps}};
    return run("run --json " + file.string());
  };

  const auto doubled = carried_out();
  steps.push_back({{"remove_load_case", twice["name"]}});
  steps.push_back(solve);
  const auto bare = carried_out();

  ASSERT_EQ(doubled.status, 0) << doubled.out;
  const auto fields = doubled.parsed()["steps"];
  EXPECT_FALSE(fields[4]["from_cache"]);
  EXPECT_NEAR(fields[4]["max_displacement_m"], 2 * fields[2]["max_displacement_m"].get<double>(),
              1e-9);
  EXPECT_EQ(bare.status, 1) << bare.out;  // Nothing is left to solve.
  EXPECT_THAT(bare.parsed()["error"]["message"], HasSubstr("step 7 (solve): "));
}

}  // namespace
}  // namespace tedit::test
