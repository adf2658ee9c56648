// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/recipe_family.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/scratch.hpp"

namespace tedit::client {
namespace {

using ::testing::HasSubstr;

/// With an operation "stamp" of a text, a number of lines and a depth.
operation_catalogue offered() {
  offered_operation stamp;
  stamp.about.id = "stamp";
  const auto add = [&](const char* id, ops::parameter_type type) {
    ops::parameter_description p;
    p.id = id;
    p.type = type;
    stamp.about.parameters.push_back(p);
  };
  add("text", ops::parameter_type::text);
  add("lines", ops::parameter_type::integer);
  add("depth", ops::parameter_type::real);
  operation_catalogue all;
  all.operations.push_back(stamp);
  return all;
}

expected<recipe_family> family(const std::string& recipe, const std::string& table) {
  const test::scratch_folder folder;
  std::ofstream(folder.path() / "recipe.json") << recipe;
  std::ofstream(folder.path() / "table.csv") << table;
  return recipe_family::read(folder.path() / "recipe.json", folder.path() / "table.csv", offered());
}

std::string family_refusal(const std::string& recipe, const std::string& table) {
  const auto made = family(recipe, table);
  const auto checked = made ? made->check() : expected<void>(fail(made.error()));
  EXPECT_FALSE(checked) << recipe;
  return checked ? "" : render(checked.error());
}

TEST(RecipeFamily, CellsBecomeTextsAndNumbersByTheirPlace) {
  const auto made = family(
    R"([{"edit": {"operation": "stamp", "surfaces": [3, "{{wall}}"],
                  "parameters": {"text": "{{no}}", "lines": "{{no}}", "depth_mm": "{{d}}",
                                 "at_mm": ["{{d}}", 0, "{{wall}}"]}}},
        {"load_case": {"name": "{{no}}",
          "materials": [{"young_modulus_pa": 2e11, "poisson_ratio": 0.3}],
          "constraints": [{"surfaces": ["{{wall}}"], "fixed": {}}],
          "loads": [{"surfaces": [2], "force": {"total_n": {"z": "{{d}}"}}}]}},
        {"export": {"stl": "{{name}}/v{version} of {{no}}.stl", "title": "{{d}} mm"}}])",
    "no,wall,d\n007,12, -1.5 \n8,13,2e3\n");
  ASSERT_TRUE(made) << render(made.error());
  const auto first = made->recipe_of(0);
  ASSERT_TRUE(first) << render(first.error());

  const auto edit = std::get<edit_step>(first->steps[0]).request;
  EXPECT_EQ(edit.surfaces, (std::vector<surface_id>{3, 12}));
  EXPECT_EQ(std::get<std::string>(edit.parameters.at("text")), "007");
  EXPECT_EQ(std::get<std::int64_t>(edit.parameters.at("lines")), 7);
  EXPECT_EQ(std::get<double>(edit.parameters.at("depth_mm")), -1.5);
  EXPECT_EQ(std::get<std::string>(edit.parameters.at("at_mm")), "-1.5, 0, 12");
  const auto loads = std::get<load_case_step>(first->steps[1]).loads;
  EXPECT_EQ(loads.name, "007");
  EXPECT_EQ(loads.constraints[0].surfaces, std::vector<surface_id>{12});
  const auto written = std::get<export_step>(first->steps[2]);
  EXPECT_EQ(written.files.at("stl"), "1/v{version} of 007.stl");
  EXPECT_EQ(written.title, " -1.5  mm");
  const auto second = made->recipe_of(1);
  ASSERT_TRUE(second) << render(second.error());
  EXPECT_EQ(
    std::get<double>(std::get<edit_step>(second->steps[0]).request.parameters.at("depth_mm")),
    2000);
}

TEST(RecipeFamily, ARowIsCalledByItsNameElseItsIdElseItsNumber) {
  EXPECT_EQ(family("[]", "id,name\n1,a\n")->name_of(0), "a");
  EXPECT_EQ(family("[]", "x,id\n1,b\n")->name_of(0), "b");
  EXPECT_EQ(family("[]", "x\n1\n2\n")->name_of(1), "2");
}

TEST(RecipeFamily, WhatCannotBeFilledInIsRefusedWithRowColumnAndStep) {
  const std::string stamp =
    R"([{"edit": {"operation": "stamp", "parameters": {"depth": "{{d}}"}}}])";
  EXPECT_THAT(family_refusal(stamp, "d\n1\n\"2,5\"\n"),
              HasSubstr("row 2 (line 3), column \"d\": \"2,5\" is no number, and step 1 (edit) "
                        "needs one at \"depth\""));
  EXPECT_THAT(family_refusal(stamp, "d,x\n1,1\n,1\n"),
              HasSubstr("row 2 (line 3), column \"d\": \"\""));
  EXPECT_THAT(family_refusal(stamp, "d\n5 mm\n"), HasSubstr("without its unit"));
  EXPECT_THAT(family_refusal(stamp, "d\ninf\n"), HasSubstr("\"inf\" is no number"));
  EXPECT_THAT(family_refusal(stamp, "depth\n1\n"),
              HasSubstr("step 1 (edit) asks for {{d}}, and the table has no such column. Its "
                        "columns are depth"));
  EXPECT_THAT(family_refusal(R"([{"import": {"mesh": "{{d"}}])", "d\n1\n"),
              HasSubstr("{{ without }}"));
  EXPECT_THAT(
    family_refusal(R"([{"load_case": {"loads": [{"force": {"total_n": {"x": "{{f}}"}}}]}}])",
                   "f\nmuch\n"),
    HasSubstr("row 1 (line 2), column \"f\": \"much\" is no number, and step 1 "
              "(load_case) needs one at \"x\""));
  EXPECT_THAT(family_refusal(R"({"order": "{{o}}", "steps": []})", "o\n2\n3\n"),
              HasSubstr("row 2 (line 3): the recipe: \"order\" must be 1"));
}

TEST(RecipeFamily, RowsThatWouldWriteTheSameFileAreRefused) {
  const auto exported = [](const std::string& name) {
    return R"([{"solve": {}}, {"export": {"stl": ")" + name + "\"}}]";
  };
  EXPECT_THAT(family_refusal(exported("a.stl"), "x\n1\n2\n"),
              HasSubstr("rows 1 and 2 would both write a.stl in step 2"));
  EXPECT_THAT(family_refusal(exported("{{name}}.stl"), "name\nb\na\nb\n"),
              HasSubstr("rows 1 and 3 would both write b.stl"));
  EXPECT_THAT(family_refusal(exported("./{{x}}.stl"), "x\n../b\n"),
              HasSubstr("column \"x\": \"../b\" cannot be part of a file's name"));
  EXPECT_TRUE(family(exported("{{name}}.stl"), "x\n1\n1\n")->check());
}

TEST(RecipeFamily, ACellIsNoRecipe) {
  const auto made = family(R"([{"remove_load_case": "{{a}}"}])", "a,b\n\"{{b}}\"\"}\",2\n");
  ASSERT_TRUE(made);
  EXPECT_EQ(std::get<remove_load_case_step>(made->recipe_of(0)->steps[0]).name, "{{b}}\"}");
}

TEST(RecipeFamily, CellsSayWhichSurfacesAreMeant) {
  const auto made = family(
    R"([{"edit": {"operation": "stamp", "label": "{{no}}", "surfaces": [
          {"name": "{{wall}}"}, {"at_mm": ["{{x}}", 0, 2], "within_mm": "{{x}}"}]}}])",
    "no,wall,x\n007,12,1.5\n");
  ASSERT_TRUE(made) << render(made.error());
  const auto first = made->recipe_of(0);
  ASSERT_TRUE(first) << render(first.error());
  const auto& step = std::get<edit_step>(first->steps[0]);
  EXPECT_EQ(step.label, "007");
  EXPECT_THAT(step.references, ::testing::ElementsAre(
                                 surface_reference{.name = "12"},
                                 surface_reference{.at_mm = vec3{1.5, 0, 2}, .within_mm = 1.5}));
}

TEST(RecipeFamily, ALoadCaseInAFileOfItsOwnHasPlacesToo) {
  const test::scratch_folder folder;
  std::ofstream(folder.path() / "recipe.json") << R"([{"load_case": {"file": "{{kind}}.json"}}])";
  std::ofstream(folder.path() / "pull.json") << R"({"name": "pull {{n}}",
    "materials": [{"young_modulus_pa": 2e11, "poisson_ratio": 0.3}],
    "constraints": [{"surfaces": [1], "fixed": {}}],
    "loads": [{"surfaces": [2], "force": {"total_n": {"z": "{{n}}"}}}]})";
  std::ofstream(folder.path() / "table.csv") << "kind,n\npull,-250\npull,much\npush,1\n";
  const auto made =
    recipe_family::read(folder.path() / "recipe.json", folder.path() / "table.csv", offered());
  ASSERT_TRUE(made) << render(made.error());
  const auto first = made->recipe_of(0);
  ASSERT_TRUE(first) << render(first.error());
  const auto& loads = std::get<load_case_step>(first->steps[0]).loads;
  EXPECT_EQ(loads.name, "pull -250");
  EXPECT_EQ(std::get<fem::force>(loads.loads.at(0).kind).total_n.z, -250);
  const auto second = made->recipe_of(1);
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, HasSubstr("column \"n\": \"much\" is no number"));
  const auto third = made->recipe_of(2);
  ASSERT_FALSE(third);
  EXPECT_THAT(third.error().message, HasSubstr("push.json"));
}

}  // namespace
}  // namespace tedit::client
