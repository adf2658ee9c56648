// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <numbers>
#include <sstream>

#include "base/child_process.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/scratch.hpp"

namespace tedit::test {
namespace {

std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// One drill hole of the plate gets another diameter, and the customer's load is solved with linear
/// tets.
json plate_recipe() {
  auto loads = json::parse(content_of(plate_loads));
  loads["loads"][0]["force"]["total_n"]["z"] = "{{force}}";
  return {{"name", "Plates"},
          {"device", "cpu"},
          {"order", 1},
          {"steps",
           {{{"import", {{"mesh", plate}}}},
            {{"load_case", loads}},
            {{"edit",
              {{"operation", "resize_bore"},
               {"surfaces", {1, 2}},
               {"parameters", {{"diameter_mm", "{{hole}}"}}}}}},
            {{"solve", json::object()}},
            {{"export", {{"stl", "{{name}}.stl"}, {"msh", "{{name}}_v{version}.msh"}}}}}}};
}

/// Four customers; the hole of the third one is as wide as the plate.
constexpr const char* four_customers =
  "name,hole,force\nA,20,-1000\nB,30,-2000\nC,900,-1000\nD,20,-2000\n";

outcome run_table(const json& recipe, const std::string& table, const std::string& more) {
  std::ofstream(scratch("recipe.json")) << recipe;
  std::ofstream(scratch("table.csv")) << table;
  return run("run --json " + scratch("recipe.json").string() + " --table " +
             scratch("table.csv").string() + " " + more);
}

std::string fresh_folder(const std::string& name) {
  std::filesystem::remove_all(scratch(name));
  return " --out " + scratch(name).string();
}

TEST(Family, ARowThatFailsStopsNobodyAndIsToldByItsStep) {
  const auto out = fresh_folder("out");
  const auto result =
    run_table(plate_recipe(), four_customers, "--report " + scratch("r.html").string() + out);

  EXPECT_EQ(result.status, 1) << result.out;
  const auto all = result.parsed();
  EXPECT_EQ(all["passed"], 3);
  EXPECT_EQ(all["failed"], 1);
  const auto rows = all["rows"];
  ASSERT_EQ(rows.size(), 4U);
  for (const auto row : {0U, 1U, 3U}) {
    EXPECT_EQ(rows[row]["status"], "passed") << rows[row];
    EXPECT_GT(rows[row]["min_safety_factor"], 0);
    EXPECT_TRUE(rows[row]["preview"]);
    EXPECT_EQ(rows[row]["files"].size(), 2U);
    EXPECT_TRUE(std::filesystem::exists(rows[row]["files"][0].get<std::string>()));
  }
  EXPECT_EQ(rows[1]["values"], (json{{"name", "B"}, {"hole", "30"}, {"force", "-2000"}}));
  // The bore is 50 mm deep, and its edges go round 21992.1 mm3 (what fill_hole adds) where a
  // cylinder of 25 mm has 24543.7: 0.89604 * pi / 4 * (30^2 - 20^2) * 50 = 17593.7 mm3.
  EXPECT_NEAR(rows[0]["volume_m3"].get<double>() - rows[1]["volume_m3"].get<double>(), 17.5937e-6,
              0.002e-6);
  // The same hole and twice the load.
  EXPECT_NEAR(rows[3]["max_displacement_m"], 2 * rows[0]["max_displacement_m"].get<double>(), 1e-9);
  EXPECT_EQ(rows[2]["status"], "failed");
  EXPECT_EQ(rows[2]["step"]["number"], 3);
  EXPECT_EQ(rows[2]["step"]["step"], "edit: resize_bore 1, 2");
  EXPECT_FALSE(rows[2]["reason"].get<std::string>().empty());
  EXPECT_EQ(rows[2]["steps"][1]["status"], "passed");
  EXPECT_EQ(rows[2]["steps"][2]["status"], "failed");
  EXPECT_EQ(rows[2]["steps"][3]["status"], "not_run");
  EXPECT_FALSE(std::filesystem::exists(scratch("out") / "C.stl"));
  const auto html = content_of(scratch("r.html"));
  if (std::filesystem::exists(TEDIT_BIN "/tedit-render")) {
    EXPECT_THAT(html, HasSubstr("src=\"data:image/png;base64,iVBORw0KGgo"));
  }
  EXPECT_LT(html.find("Parts that failed"), html.find("Parts that passed"));
  EXPECT_THAT(html, HasSubstr("edit: resize_bore 1, 2"));
}

/// The whole way: each customer's bore, in the STEP file that goes to the shop.
TEST(Family, PartsFromCadGoBackIntoCad) {
  if (!std::filesystem::exists(TEDIT_BIN "/tedit-cad-mesher"))
    GTEST_SKIP() << "this build has no OpenCASCADE";
  const json recipe{
    {"name", "Blocks"},
    {"steps",
     {{{"import", {{"mesh", TEDIT_TEST_DATA "/cad/inch_block.stp"}, {"size", "{{size}}"}}}},
      {{"edit",
        {{"operation", "drill"},
         {"surfaces", {3}},
         {"parameters", {{"diameter_mm", "{{bore}}"}, {"depth_mm", 5}}}}}},
      {{"export", {{"step", "{{name}}.step"}, {"stl", "{{name}}.stl"}}}}}}};
  const auto out = fresh_folder("cad");
  const auto result =
    run_table(recipe, "name,size,bore\nA,coarse,8\nB,medium,10\n", "--jobs 2" + out);

  ASSERT_EQ(result.status, 0) << result.out;
  const auto before =
    run("import --json " TEDIT_TEST_DATA "/cad/inch_block.stp --size coarse").parsed();
  for (const auto& [name, bore] : {std::pair("A", 8.0), std::pair("B", 10.0)}) {
    const auto file = (scratch("cad") / name).string() + ".step";
    const auto again = run("import --json " + file).parsed();
    // On the CAD model the bore is a cylinder, whatever the mesh has.
    const double drilled = 1e-9 * std::numbers::pi / 4 * bore * bore * 5;
    EXPECT_NEAR(again["cad_volume_m3"].get<double>(),
                before["cad_volume_m3"].get<double>() - drilled, 1e-15)
      << name;
  }
  for (const auto& left : std::filesystem::directory_iterator(scratch("cad")))
    EXPECT_NE(left.path().extension(), ".tedit") << left.path();
}

TEST(Family, AStepFileOfAPartThatCameFromAMeshIsRefused) {
  auto recipe = plate_recipe();
  recipe["steps"] = {recipe["steps"][0], {{"export", {{"step", "plate.step"}}}}};
  std::ofstream(scratch("recipe.json")) << recipe;
  const auto refused = run("run --json " + scratch("recipe.json").string() + fresh_folder("none"));
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.out, HasSubstr("the part has no CAD model"));
  EXPECT_THAT(refused.out, HasSubstr("import step of a CAD file"));
}

TEST(Family, ResultsAreTheSameHoweverManyRowsRunAtOnce) {
  const auto one = run_table(plate_recipe(), four_customers, "--jobs 1" + fresh_folder("one"));
  const auto three = run_table(plate_recipe(), four_customers, "--jobs 3" + fresh_folder("three"));

  ASSERT_EQ(one.status, 1) << one.out;
  EXPECT_EQ(one.parsed()["jobs"], 1);
  EXPECT_EQ(three.parsed()["jobs"], 3);
  for (std::size_t row = 0; row < 4; ++row) {
    const auto a = one.parsed()["rows"][row];
    const auto b = three.parsed()["rows"][row];
    for (const auto* key : {"name", "status", "step", "reason", "volume_m3", "mass_kg"})
      EXPECT_EQ(a.value(key, json()), b.value(key, json())) << key << " of row " << row + 1;
    // A solver begins with what it solved before: these agree to the solve's tolerance.
    for (const auto* key : {"max_displacement_m", "max_von_mises_pa", "min_safety_factor"})
      EXPECT_NEAR(a.value(key, 0.0), b.value(key, 0.0), 1e-6 * a.value(key, 0.0))
        << key << " of row " << row + 1;
    for (const std::string& file :
         {a["name"].get<std::string>() + ".stl", a["name"].get<std::string>() + "_v1.msh"})
      EXPECT_EQ(content_of(scratch("one") / file), content_of(scratch("three") / file)) << file;
  }
}

TEST(Family, WhatIsWrongInAnyRowIsSaidBeforeTheFirstIsCarriedOut) {
  const auto out = fresh_folder("out");
  const auto message = [&](const json& recipe, const std::string& table) {
    const auto result = run_table(recipe, table, out);
    EXPECT_EQ(result.status, 65) << result.out;
    const auto error = result.parsed()["error"];
    return error["message"].get<std::string>() + ". " + error["remedy"].get<std::string>();
  };
  EXPECT_THAT(message(plate_recipe(), "name,hole,force\nA,20,-1\nB,wide,-1\n"),
              HasSubstr("row 2 (line 3), column \"hole\": \"wide\" is no number, and step 3 (edit) "
                        "needs one at \"diameter_mm\""));
  EXPECT_THAT(message(plate_recipe(), "name,hole\nA,20\n"),
              HasSubstr("step 2 (load_case) asks for {{force}}"));
  EXPECT_THAT(message(plate_recipe(), "name,hole,force\nA,20,-1\nA,30,-1\n"),
              HasSubstr("rows 1 and 2 would both write A_v{version}.msh in step 5"));
  EXPECT_THAT(message(plate_recipe(), "name,hole,force\nA,20\n"), HasSubstr("line 2"));
  EXPECT_FALSE(std::filesystem::exists(scratch("out")));
}

/// The surfaces of both meshes have the numbers of the CAD model's faces.
TEST(Family, ARecipeIsReplayedOnAnotherSizeOfThePart) {
  if (!std::filesystem::exists(TEDIT_BIN "/tedit-cad-mesher"))
    GTEST_SKIP() << "built without OpenCASCADE and Gmsh";
  for (const std::string size : {"coarse", "medium"})
    ASSERT_EQ(run("import --json " TEDIT_TEST_DATA "/cad/inch_block.stp --size " + size + " -o " +
                  scratch(size + ".msh").string())
                .status,
              0);
  const json loads{{"name", "pull"},
                   {"materials", {{{"young_modulus_pa", 210e9}, {"poisson_ratio", 0.3}}}},
                   {"constraints", {{{"surfaces", {3}}, {"fixed", json::object()}}}},
                   {"loads", {{{"surfaces", {6}}, {"force", {{"total_n", {{"z", 1000}}}}}}}}};
  const json recipe{{"device", "cpu"},
                    {"order", 1},
                    {"steps",
                     {{{"import", {{"mesh", "{{name}}.msh"}}}},
                      {{"load_case", loads}},
                      {{"edit",
                        {{"operation", "resize_bore"},
                         {"surfaces", {8, 9}},
                         {"parameters", {{"diameter_mm", 8}}}}}},
                      {{"solve", json::object()}}}}};

  const auto result = run_table(recipe, "name\ncoarse\nmedium\n", fresh_folder("out"));

  ASSERT_EQ(result.status, 0) << result.out;
  const auto report = result.parsed();
  for (const auto& row : report["rows"]) {
    ASSERT_EQ(row["steps"].size(), 4U);
    for (const auto& step : row["steps"])
      EXPECT_EQ(step["status"], "passed") << row["name"] << step;
    // 25.4 * 50.8 * 76.2 mm3 less a bore 12.7 mm deep, of which a regular octagon leaves out a
    // tenth, the uneven one of the coarse mesh a little more, and a finer polygon less.
    const double block = 1e-9 * 25.4 * 50.8 * 76.2;
    const double bore = 1e-9 * std::numbers::pi / 4 * 8 * 8 * 12.7;
    EXPECT_GT(row["volume_m3"], block - bore) << row["name"];
    EXPECT_LT(row["volume_m3"], block - bore + (row["name"] == "coarse" ? 0.11 * bore : 0.06e-6))
      << row["name"];
  }
}

/// The plate with other numbers: each surface's is 1000 larger.
void write_renumbered_plate(const std::string& file) {
  ASSERT_EQ(run("convert " + plate + " -o " + scratch("plate.msh2").string()).status, 0);
  std::ifstream in(scratch("plate.msh2"));
  std::ofstream out(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    int number = 0, type = 0, tags = 0, physical = 0, entity = 0;
    std::string rest;
    // "number 2 2 physical entity a b c" is a triangle.
    if (words >> number >> type >> tags >> physical >> entity && type == 2 && tags == 2 &&
        std::getline(words, rest) && std::ranges::count(rest, ' ') == 3)
      out << number << " 2 2 " << physical << ' ' << entity + 1000 << rest << '\n';
    else
      out << line << '\n';
  }
}

/// By points, by the feature that they are of and by what an edit made.
TEST(Family, ARecipeWithoutNumbersOfSurfacesIsReplayedOnAPartWithOtherNumbers) {
  write_renumbered_plate(scratch("other.msh").string());
  const json top{{"at_mm", {-235, -49, 0}}};
  const json hole{{"at_mm", {-147.5, 45, -25}}, {"as", "hole"}};
  const json loads{{"name", "press"},
                   {"materials", {{{"young_modulus_pa", 70e9}, {"poisson_ratio", 0.3}}}},
                   {"constraints", {{{"surfaces", {hole}}, {"fixed", json::object()}}}},
                   {"loads",
                    {{{"surfaces", {{{"made_by", "pin"}, {"at_mm", {-235, -49, 20}}}}},
                      {"force", {{"total_n", {{"z", -1000}}}}}}}}};
  const json pin{
    {"profile", "circle"}, {"size_mm", 30}, {"height_mm", 20}, {"at_mm", "-235,-49,0"}};
  json recipe{
    {"device", "cpu"},
    {"order", 1},
    {"steps",
     {{{"import", {{"mesh", "{{mesh}}"}}}},
      {{"edit",
        {{"operation", "boss"}, {"surfaces", {top}}, {"parameters", pin}, {"label", "pin"}}}},
      {{"load_case", loads}},
      {{"edit",
        {{"operation", "fill_hole"},
         {"surfaces", {{{"at_mm", {147.5, 45, -25}}, {"as", "hole"}}}}}}},
      {{"solve", json::object()}}}}};
  const auto table = "mesh\n" + plate + "\n" + scratch("other.msh").string() + "\n";

  const auto result = run_table(recipe, table, fresh_folder("out"));

  ASSERT_EQ(result.status, 0) << result.out;
  const auto rows = result.parsed()["rows"];
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows)
    for (const auto& step : row["steps"])
      EXPECT_EQ(step["status"], "passed") << row["name"] << step;
  EXPECT_NEAR(rows[0]["volume_m3"].get<double>() / rows[1]["volume_m3"].get<double>(), 1, 1e-12);
  // Tets between the pin and the part are others where the file's order is another.
  EXPECT_NEAR(
    rows[0]["max_displacement_m"].get<double>() / rows[1]["max_displacement_m"].get<double>(), 1,
    0.01);

  recipe["steps"][3]["edit"]["surfaces"] = {92, 93};
  const auto by_numbers = run_table(recipe, table, fresh_folder("out"));
  EXPECT_EQ(by_numbers.parsed()["passed"], 1);
  EXPECT_EQ(by_numbers.parsed()["rows"][1]["code"], "surface_not_found");
}

TEST(Family, OptionsOfATableNeedOne) {
  std::ofstream(scratch("recipe.json")) << plate_recipe();
  const auto recipe = scratch("recipe.json").string();
  EXPECT_EQ(run("run --json " + recipe + " --jobs 2").status, 2);
  EXPECT_EQ(run("run --json " + recipe + " --table /nowhere.csv").status, 65);
  const auto odd = run_table(plate_recipe(), four_customers, "--report a.odt");
  EXPECT_EQ(odd.status, 2);
  EXPECT_THAT(odd.parsed()["error"]["remedy"], HasSubstr(".html"));
}

/// What is in the page is in the PDF, with as many pictures, and nothing else is left in the
/// folder.
TEST(Family, TheReportMayBeAPdf) {
  if (!std::filesystem::exists(TEDIT_BIN "/tedit-pdf"))
    GTEST_SKIP() << "this build has no Qt";
  std::filesystem::remove_all(scratch("reports"));
  std::filesystem::create_directories(scratch("reports"));
  const auto file = scratch("reports") / "customers.pdf";
  const auto result =
    run_table(plate_recipe(), four_customers, "--report " + file.string() + fresh_folder("out"));

  EXPECT_EQ(result.status, 1) << result.out;
  const auto said = [](const std::vector<std::string>& command) {
    const auto bytes = value(run_child(command, {}, {std::chrono::seconds(60), 0}, {}));
    return std::string(bytes.begin(), bytes.end());
  };
  const auto text = said({"/usr/bin/pdftotext", "-layout", file.string(), "-"});
  for (const auto* words : {"Plates", "Parts that failed", "edit: resize_bore 1, 2",
                            "Parts that passed", "Smallest safety factor"})
    EXPECT_THAT(text, HasSubstr(words));
  if (std::filesystem::exists(TEDIT_BIN "/tedit-render")) {
    const auto pictures = said({"/usr/bin/pdfimages", "-list", file.string()});
    EXPECT_GE(std::ranges::count(pictures, '\n'), 2 + 3) << pictures;
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(scratch("reports")), {}), 1);
}

}  // namespace
}  // namespace tedit::test
