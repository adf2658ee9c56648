// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "client/recipe.hpp"
#include "mesh/formats.hpp"
#include "protocol/convert.hpp"
#include "tests/support/scratch.hpp"

namespace tedit::client {
namespace {

using ::testing::HasSubstr;

const std::string loads_file = TEDIT_EXAMPLES "/ctc01_plate/load_case.json";

std::string text_of(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

fem::load_case loads() {
  return *protocol::load_case_from_file(loads_file);
}

/// The one step of a list.
recipe_step step(const std::string& json) {
  const auto read = recipe_from_json("[" + json + "]", "/parts");
  if (!read || read->steps.size() != 1) {
    ADD_FAILURE() << json << ": " << (read ? "not one step" : render(read.error()));
    return undo_step{};
  }
  return read->steps.front();
}

std::string refusal(const std::string& json) {
  const auto read = recipe_from_json(json);
  EXPECT_FALSE(read) << json;
  return read ? "" : render(read.error());
}

std::string step_refusal(const std::string& json) {
  return refusal("[{\"undo\": {}}, " + json + "]");
}

edit_request erosion() {
  return {"erode", {1, -2}, {{"depth", 0.002}, {"layers", std::int64_t{1}}}, {}};
}

// -- every kind -------------------------------------------------------------------------

TEST(RecipeReader, StepsThatWorkOnThePart) {
  EXPECT_EQ(step(R"({"import": {"mesh": "a.msh", "length_unit": "m"}})"),
            recipe_step(import_step{"/parts/a.msh", "m"}));
  EXPECT_EQ(
    step(R"({"import": {"mesh": "a.stp", "size": "coarse", "local_sizes_mm": {"9": 0.5}}})"),
    recipe_step(import_step{"/parts/a.stp", "mm", "coarse", {{"9", 0.5}}}));
  EXPECT_EQ(step(R"({"remove_load_case": "braking"})"),
            recipe_step(remove_load_case_step{"braking"}));
  EXPECT_EQ(step(R"({"edit": {"operation": "erode", "surfaces": [1, -2],
                              "parameters": {"depth": 0.002, "layers": 1}}})"),
            recipe_step(edit_step{erosion()}));
  EXPECT_EQ(step(R"({"go_to": 3})"), recipe_step(go_to_step{3}));
  EXPECT_EQ(step(R"({"solve": {"load_cases": "all", "energy_tolerance": 0.01}})"),
            recipe_step(solve_step{{}, true, 0.01}));
  EXPECT_EQ(step(R"({"export": {"msh": "v{version}.msh", "png": "a.png", "range_mpa": [0, 9]}})"),
            recipe_step(export_step{{{"msh", "v{version}.msh"}}, "a.png", {}, {{0., 9.}}}));
  EXPECT_EQ(step(R"({"compare": {"before": 0, "after": 2, "load_case": "pull", "vtu": "d.vtu"}})"),
            recipe_step(compare_step{0, 2, "pull", {}, "d.vtu", {}, {}}));
  EXPECT_EQ(step(R"({"compare": {"before": 3, "json": "d.json"}})"),
            recipe_step(compare_step{3, std::nullopt, {}, "d.json", {}, {}, {}}));
  EXPECT_THAT(step_refusal(R"({"compare": {"after": 1}})"), HasSubstr("needs \"before\""));
  EXPECT_THAT(step_refusal(R"({"compare": {"before": 0, "after": -1}})"),
              HasSubstr("\"after\" must be the number of a version"));
}

TEST(RecipeReader, BothSpellingsOfUndoAndOfALoadCase) {
  EXPECT_EQ(step(R"({"undo": true})"), recipe_step(undo_step{}));
  EXPECT_EQ(step(R"({"undo": {}})"), recipe_step(undo_step{}));
  EXPECT_EQ(step(R"({"redo": true})"), recipe_step(redo_step{}));
  EXPECT_EQ(step(R"({"redo": {}})"), recipe_step(redo_step{}));
  const recipe_step wanted = load_case_step{loads()};
  EXPECT_EQ(step(R"({"load_case": {"file": ")" + loads_file + R"("}})"), wanted);
  EXPECT_EQ(step(R"({"load_case": )" + text_of(loads_file) + "}"), wanted);
}

TEST(RecipeReader, AnApplyStepIsAnEditOfTheSelection) {
  auto request = erosion();
  request.surfaces.clear();
  request.loads.policy = fem::load_policy::move;
  EXPECT_EQ(step(R"({"apply": "erode", "parameters": {"depth": 0.002, "layers": 1},
                     "loads": "move"})"),
            recipe_step(apply_step{request}));
}

TEST(RecipeReader, ListsOfNumbersAndOfPointsAreTextsOfThem) {
  const auto value = [](const std::string& list) {
    const auto read = recipe_from_json(
      R"([{"edit": {"operation": "pattern", "parameters": {"a": )" + list + "}}}]", {});
    EXPECT_TRUE(read) << list << ": " << render(read.error());
    return std::get<std::string>(
      std::get<edit_step>(read->steps.front()).request.parameters.at("a"));
  };

  EXPECT_EQ(value("[1, -2.5, 1e-3]"), "1, -2.5, 0.001");
  EXPECT_EQ(value("[[0, 0, 1.5], [0, 0, 1]]"), "0, 0, 1.5; 0, 0, 1");
  EXPECT_EQ(value("[[10, 20, 30]]"), "10, 20, 30");
  EXPECT_EQ(value("[0.1]"), "0.1");
}

TEST(RecipeReader, AFileOfAParameterIsReadWithTheRecipe) {
  const test::scratch_folder folder;
  std::ofstream(folder.path() / "knob.stl") << "foobar";
  const auto read = [&](const std::string& value) {
    return recipe_from_json(
      R"([{"edit": {"operation": "combine", "parameters": {"file": )" + value + "}}}]",
      folder.path());
  };

  const auto good = read(R"({"file": "knob.stl"})");

  ASSERT_TRUE(good) << render(good.error());
  EXPECT_EQ(std::get<edit_step>(good->steps.front()).request.parameters,
            (ops::parameters{{"file", std::string("data:knob.stl;base64,Zm9vYmFy")}}));
  EXPECT_THAT(read(R"({"file": "none.stl"})").error().message, HasSubstr("is not there"));
  for (const auto* wrong :
       {R"({"path": "knob.stl"})", R"({"file": 3})", "[]", R"({"file": "knob.stl", "more": 1})"})
    EXPECT_FALSE(read(wrong)) << wrong;
}

/// Each kind of the window once, as docs/recipes.md has it.
const std::vector<std::pair<std::string, std::string>> of_window{
  {"click", R"({"click":1})"},
  {"select", R"({"select":[1,2]})"},
  {"choose", R"({"choose":"fill_hole"})"},
  {"drag", R"({"drag":40})"},
  {"drag_handle", R"({"by":[0,40.5],"drag_handle":"depth","held":true,"moves":20})"},
  {"command", R"({"command":"view.section"})"},
  {"field", R"({"field":"principal_1"})"},
  {"case", R"({"case":""})"},
  {"deform", R"({"deform":100.5})"},
  {"bands", R"({"bands":12})"},
  {"isolines", R"({"isolines":true})"},
  {"view", R"({"view":"top"})"},
  {"camera",
   R"({"camera":{"focus":[0,0,0],"parallel":false,"position":[1,0,0],"scale":0.1,"up":[0,0,1]}})"},
  {"section", R"({"section":{"at":[0,0,0],"normal":[1,0,0]}})"},
  {"section", R"({"section":null})"},
  {"box", R"({"box":[0.1,0.2,0.5,0.5],"enclosed":true})"},
  {"hidden", R"({"hidden":[]})"},
  {"probe", R"({"probe":{"at":[0,0,0],"number":1,"surface":7}})"},
  {"remove_probe", R"({"remove_probe":1})"},
  {"measure", R"({"measure":[1,2]})"},
  {"wait", R"({"wait":"final"})"},
  {"report", R"({"report":"OUT.pdf"})"},
  {"screenshot", R"({"height":1000,"screenshot":"a.png","width":1600,"window":true})"}};

TEST(RecipeReader, StepsOfTheWindowAreCarriedAsTheyStand) {
  for (const auto& [kind, json] : of_window) {
    const auto read = step(json);
    EXPECT_EQ(read, recipe_step(window_step{kind, json}));
    EXPECT_EQ(kind_of(read), kind);
    EXPECT_TRUE(is_of_window(read)) << kind;
  }
  EXPECT_TRUE(is_of_window(apply_step{}));
  EXPECT_FALSE(is_of_window(edit_step{}));
}

TEST(RecipeReader, ARecipeIsAnObjectOrAListAlone) {
  const auto whole = recipe_from_json(
    R"({"name": "n", "device": "cpu", "tolerance": 1e-4, "order": 1, "steps": [{"undo": {}}]})");
  ASSERT_TRUE(whole) << render(whole.error());
  EXPECT_EQ(*whole, (recipe{"n", "cpu", 1e-4, 1, {undo_step{}}}));
  const auto alone = recipe_from_json(R"([{"undo": {}}])");
  ASSERT_TRUE(alone);
  EXPECT_EQ(alone->steps, whole->steps);
  EXPECT_EQ(alone->order, 2);
}

// -- refusals -----------------------------------------------------------------------------

TEST(RecipeReader, WhatIsUnknownIsNamedWithItsStep) {
  const std::pair<const char*, const char*> cases[] = {
    {R"({"clik": 1})", "step 2: there is no step \"clik\""},
    {R"({"clik": 1})", "go_to"},  // All that there are.
    {R"({"undo": true, "redo": true})", "step 2 is two at once"},
    {R"({})", "step 2 must be"},
    {R"(7)", "step 2 must be"},
    {R"({"import": {"mash": "a.msh", "mesh": "a"}})",
     "step 2 (import) has an unknown field \"mash\""},
    {R"({"import": {}})", "step 2 (import) needs \"mesh\""},
    {R"({"undo": {"twice": true}})", "step 2 (undo) has an unknown field \"twice\""},
    {R"({"edit": {"operation": "x"}, "loads": "drop"})", "step 2 (edit) has fields beside"},
    {R"({"apply": "erode", "parametres": {}})",
     "step 2 (apply) has an unknown field \"parametres\""},
    {R"({"screenshot": "a.png", "widht": 7})",
     "step 2 (screenshot) has an unknown field \"widht\""},
    {R"({"camera": {"position": [0, 0, 1], "focus": [0, 0, 0]}})", "step 2 (camera) needs \"up\""},
    {R"({"section": {"at": [0, 0, 0], "normal": [0, 0, 1], "side": 1}})", "unknown field \"side\""},
    {R"({"load_case": {"file": "/nowhere.json"}})", "step 2 (load_case): "},
    {R"({"load_case": {"name": "a", "lods": []}})", "lods"},
    {R"({"load_case": {"file": ")" TEDIT_EXAMPLES R"(/ctc01_plate/load_case.json", "name": "a"}})",
     "step 2 (load_case) has an unknown field \"name\""},
    {R"({"import": {"mesh": "a.stp", "size": "finest"}})",
     "\"size\" must be one of coarse, medium, fine"},
    {R"({"wait": "preview"})", "step 2 (wait) must be \"ready\" or \"final\""}};
  for (const auto& [json, words] : cases)
    EXPECT_THAT(step_refusal(json), HasSubstr(words)) << json;
}

TEST(RecipeReader, AnotherTypeIsAnErrorAndNotNothing) {
  const std::pair<const char*, const char*> cases[] = {
    {R"({"undo": 1})", "step 2 (undo): write {\"undo\": {...}}"},
    {R"({"edit": "erode"})", "step 2 (edit): write"},
    {R"({"edit": {"operation": "erode", "surfaces": 7}})", "\"surfaces\" must be a list"},
    {R"({"edit": {"operation": "erode", "surfaces": [7.5]}})", "must be a whole number"},
    {R"({"edit": {"operation": "erode", "parameters": [1]}})", "\"parameters\" must be"},
    {R"({"edit": {"operation": "erode", "parameters": {"a": [true]}}})", "parameter \"a\""},
    {R"({"edit": {"operation": "erode", "parameters": {"a": [[[1]]]}}})", "parameter \"a\""},
    {R"({"edit": {"operation": "erode", "parameters": {"a": [1e300]}}})", "parameter \"a\""},
    {R"({"edit": {"operation": "erode", "parameters": {"a": null}}})", "a list, or"},
    {R"({"import": {"mesh": "a.stp", "local_sizes_mm": [1]}})", "must be {\"name\": number"},
    {R"({"import": {"mesh": "a.stp", "local_sizes_mm": {"9": 0}}})", "\"9\" is 0"},
    {R"({"edit": {"operation": "erode", "keep_traction": 1}})", "must be true or false"},
    {R"({"go_to": -1})", "step 2 (go_to): \"go_to\" must be the number of a version"},
    {R"({"go_to": 4294967296})", "must be the number of a version"},
    {R"({"remove_load_case": 1})", "must be a text"},
    {R"({"click": "1"})", "step 2 (click) must be a whole number"},
    {R"({"drag": "far"})", "step 2 (drag) must be a whole number"},
    {R"({"drag_handle": "depth"})", "step 2 (drag_handle) needs \"by\""},
    {R"({"select": 7})", "step 2 (select) must be a list"},
    {R"({"select": [true]})", "each of step 2 (select) must be a whole number"},
    {R"({"isolines": 1})", "step 2 (isolines) must be true or false"},
    {R"({"screenshot": "a.png", "window": 1})", "step 2 (screenshot): \"window\" must be true"},
    {R"({"screenshot": "a.png", "width": "wide"})", "\"width\" must be a whole number"},
    {R"({"camera": [0, 0, 1]})", "step 2 (camera) must be {\"position\""},
    {R"({"camera": {"position": "far", "focus": [0, 0, 0], "up": [0, 0, 1]}})",
     "step 2 (camera): \"position\" must be a list of 3"},
    {R"({"camera": {"position": [0, 0], "focus": [0, 0, 0], "up": [0, 0, 1]}})",
     "\"position\" must be a list of 3"},
    {R"({"section": false})", "step 2 (section) must be"}};
  for (const auto& [json, words] : cases)
    EXPECT_THAT(step_refusal(json), HasSubstr(words)) << json;
}

TEST(RecipeReader, NumbersAreFiniteAndInRangeAndSizesBounded) {
  const auto camera = [](const std::string& x) {
    return R"({"camera": {"position": [)" + x + R"(, 0, 0], "focus": [0, 0, 0], "up": [0, 0, 1]}})";
  };
  EXPECT_THAT(step_refusal(camera("1e999")), HasSubstr("no JSON"));
  EXPECT_THAT(step_refusal(camera("NaN")), HasSubstr("no JSON"));
  EXPECT_THAT(step_refusal(camera("1e30")), HasSubstr("\"position\" is 1e+30"));
  EXPECT_THAT(step_refusal(R"({"drag": 1000000000})"), HasSubstr("step 2 (drag) is 1e+09"));
  EXPECT_THAT(step_refusal(R"({"screenshot": "a.png", "width": 1000000})"), HasSubstr("\"width\""));
  EXPECT_THAT(step_refusal(R"({"screenshot": "a.png", "height": 200})"), HasSubstr("240"));
  EXPECT_THAT(step_refusal(R"({"screenshot": "a.png", "height": 0})"), HasSubstr("\"height\""));
  EXPECT_THAT(step_refusal(R"({"box": [0, 0, 2, 1]})"), HasSubstr("each of step 2 (box) is 2"));
  EXPECT_THAT(step_refusal(R"({"probe": {"number": 0, "surface": 1, "at": [0, 0, 0]}})"),
              HasSubstr("step 2 (probe): \"number\" is 0"));
  EXPECT_THAT(step_refusal(R"({"click": 18446744073709551615})"), HasSubstr("whole number"));

  std::string ids = "1";
  for (int i = 0; i < 1'000'000; ++i)
    ids += ",1";
  EXPECT_THAT(step_refusal("{\"select\": [" + ids + "]}"), HasSubstr("at most 100000"));
  EXPECT_THAT(step_refusal(R"({"edit": {"operation": "a", "surfaces": [)" + ids + "]}}"),
              HasSubstr("at most 100000"));
  EXPECT_THAT(step_refusal(R"({"command": ")" + std::string(5000, 'a') + "\"}"),
              HasSubstr("at most 4096"));
  EXPECT_THAT(refusal(std::string(1'000'000, '[')), HasSubstr("nested more than 64"));
  EXPECT_THAT(step_refusal(R"({"load_case": {"name": )" + std::string(100'000, '[')),
              HasSubstr("nested more than 64"));
}

TEST(RecipeReader, TheWholeIsCheckedToo) {
  EXPECT_THAT(refusal("7"), HasSubstr("or the list alone"));
  EXPECT_THAT(refusal(R"({"name": "n"})"), HasSubstr("a list \"steps\""));
  EXPECT_THAT(refusal(R"({"steps": {}})"), HasSubstr("a list \"steps\""));
  EXPECT_THAT(refusal(R"({"name": 7, "steps": []})"), HasSubstr("\"name\" must be a text"));
  EXPECT_THAT(refusal(R"({"nam": "n", "steps": []})"), HasSubstr("unknown field \"nam\""));
  EXPECT_THAT(refusal(R"({"order": 3, "steps": []})"), HasSubstr("must be 1"));
  EXPECT_THAT(refusal(R"({"order": 4294967298, "steps": []})"), HasSubstr("must be 1"));
  const auto missing = read_recipe("/nowhere/recipe.json");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ec::io_error);
  const auto endless = read_recipe("/dev/zero");
  ASSERT_FALSE(endless);
  EXPECT_EQ(endless.error().code, ec::io_error);
  EXPECT_THAT(endless.error().remedy, HasSubstr("64 MiB"));
}

// -- written and read again -----------------------------------------------------------------

rc::Gen<std::string> any_word() {
  return rc::gen::map(rc::gen::container<std::string>(rc::gen::inRange(0, 6)), [](std::string raw) {
    std::string word;
    for (const char c : raw)
      word += std::string_view("az\"\\\n/")[static_cast<std::size_t>(c)];
    return word + "x";
  });
}

rc::Gen<double> any_finite() {
  return rc::gen::map(
    rc::gen::pair(rc::gen::arbitrary<double>(), rc::gen::inRange(0, 3)), [](auto p) {
      const double x = std::isfinite(p.first) ? std::clamp(p.first, -1e30, 1e30) : 1.0;
      return p.second == 0 ? std::round(x) : x;
    });
}

edit_request any_request(bool with_surfaces) {
  edit_request result;
  result.operation = *any_word();
  if (with_surfaces)
    result.surfaces = *rc::gen::arbitrary<std::vector<surface_id>>();
  const auto names = *rc::gen::container<std::vector<std::string>>(any_word());
  for (const auto& name : names)
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        result.parameters[name] = *rc::gen::arbitrary<bool>();
        break;
      case 1:
        result.parameters[name] = *rc::gen::arbitrary<std::int64_t>();
        break;
      case 2:
        result.parameters[name] = *any_finite();
        break;
      default:
        result.parameters[name] = *any_word();
    }
  result.loads = {
    *rc::gen::element(fem::load_policy::drop, fem::load_policy::move, fem::load_policy::refuse),
    *rc::gen::arbitrary<bool>()};
  return result;
}

fem::load_case any_loads() {
  auto result = loads();
  result.name = "load case " + std::to_string(*rc::gen::arbitrary<int>());
  if (auto* force = std::get_if<fem::force>(&result.loads.front().kind))
    force->total_n = {*any_finite(), *any_finite(), *any_finite()};
  return result;
}

TEST(RecipeReader, EachFormatHasItsKey) {
  for (const auto& format : file_formats) {
    const std::string name(format.name);
    const auto read = recipe_from_json(R"([{"export": {")" + name + R"(": "a"}}])");
    ASSERT_TRUE(read.has_value()) << name;
    EXPECT_EQ(read->steps.front(), recipe_step(export_step{{{name, "a"}}, {}, {}, {}}));
  }
  EXPECT_TRUE(recipe_from_json(R"([{"export": {"step": "a.step"}}])").has_value());
  EXPECT_FALSE(recipe_from_json(R"([{"export": {"stpe": "a.step"}}])").has_value());
}

export_step any_export() {
  export_step result{{}, *any_word(), *any_word(), {}};
  for (const auto format : written_formats())
    if (const auto name = *any_word(); !name.empty())
      result.files[std::string(format)] = name;
  const double low = *any_finite();
  if (*rc::gen::arbitrary<bool>() && low < 1e29)
    result.range_mpa = {low, low + 1 + std::abs(low)};
  return result;
}

compare_step any_comparison() {
  compare_step result{*rc::gen::arbitrary<std::uint32_t>(),
                      {},
                      *any_word(),
                      *any_word(),
                      *any_word(),
                      *any_word(),
                      *any_word()};
  if (*rc::gen::arbitrary<bool>())
    result.after = *rc::gen::arbitrary<std::uint32_t>();
  return result;
}

solve_step any_solve() {
  if (*rc::gen::arbitrary<bool>())
    return {{}, true, 0.25};
  return {*rc::gen::container<std::vector<std::string>>(any_word()), false,
          *rc::gen::element(0.0, 1e-9, 0.1)};
}

recipe_step any_step() {
  switch (*rc::gen::inRange(0, 12)) {
    case 0:
      return import_step{"/" + *any_word(),
                         *any_word(),
                         *rc::gen::element<std::string>("", "coarse", "medium", "fine"),
                         {{*any_word(), *rc::gen::element(1e-3, 0.5, 1e6)}}};
    case 1:
      return load_case_step{any_loads()};
    case 2:
      return remove_load_case_step{*any_word()};
    case 3:
      return edit_step{any_request(true)};
    case 4:
      return undo_step{};
    case 5:
      return redo_step{};
    case 6:
      return go_to_step{*rc::gen::arbitrary<std::uint32_t>()};
    case 7:
      return any_solve();
    case 8:
      return any_export();
    case 9:
      return any_comparison();
    case 10:
      return apply_step{any_request(false)};
    default: {
      const auto& [kind, json] = *rc::gen::elementOf(of_window);
      return window_step{kind, json};
    }
  }
}

RC_GTEST_PROP(RecipeWriter, WhatIsWrittenIsReadAsTheSame, ()) {
  recipe wanted{
    *any_word(), *any_word(), *rc::gen::element(1e-6, 1e-12, 0.1), *rc::gen::element(1, 2), {}};
  const int count = *rc::gen::inRange(0, 6);
  for (int i = 0; i < count; ++i)
    wanted.steps.push_back(any_step());

  const auto text = to_json(wanted);
  const auto read = recipe_from_json(text);
  if (!read)
    RC_FAIL(render(read.error()) + "\n" + text);
  for (int i = 0; i < count; ++i)  // Named one by one, to be read.
    if (read->steps[static_cast<std::size_t>(i)] != wanted.steps[static_cast<std::size_t>(i)])
      RC_FAIL("step " + std::to_string(i + 1) + " in\n" + text + "became\n" + to_json(*read));
  RC_ASSERT(*read == wanted);
}

TEST(RecipeWriter, EachStepHasALineOfItsOwn) {
  recipe small{"Own", "auto", 1e-6, 2, {undo_step{}, go_to_step{3}}};
  EXPECT_EQ(to_json(small),
            "{\"name\": \"Own\",\n \"steps\": [\n  {\"undo\":{}},\n  {\"go_to\":3}\n]}\n");
}

}  // namespace
}  // namespace tedit::client
