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

}  // namespace
}  // namespace tedit::test
