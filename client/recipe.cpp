// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/recipe.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <set>

#include <nlohmann/json.hpp>

#include "base/number_range.hpp"

namespace tedit::client {

namespace {

using nlohmann::json;

/// In the order of `recipe_step`.
constexpr std::array<const char*, std::variant_size_v<recipe_step>> kind_names{
  "import", "load_case", "edit", "undo", "redo", "solve", "export"};

/// Errors: thrown, `bad_input` when it is no number or out of its range.
double number(const json& value, const number_range& range, const std::string& name) {
  if (!value.is_number())
    throw error{ec::bad_input, name + " must be a number", {}, {}};
  const auto given = value.get<double>();
  if (const auto ok = check_number(given, range, name); !ok)
    throw error{ec::bad_input, ok.error().message + ". " + ok.error().remedy, {}, {}};
  return given;
}

/// The same for a whole number: neither cut off nor wrapped around.
std::int64_t whole(const json& value, const std::string& name) {
  const bool too_large = value.is_number_unsigned() && value.get<std::uint64_t>() > INT64_MAX;
  if (!value.is_number_integer() || too_large)
    throw error{ec::bad_input, name + " must be a whole number", {}, {}};
  return value.get<std::int64_t>();
}

/// Reads one step; unknown fields are errors, so that a typing mistake does not pass silently.
class step_reader {
public:
  step_reader(const json& body, std::string where, std::filesystem::path folder)
      : body_(body), where_(std::move(where)), folder_(std::move(folder)) {}

  std::string text(const char* field, const std::string& fallback, bool needed = false) {
    known_.insert(field);
    if (!body_.contains(field)) {
      if (needed)
        throw error{ec::bad_input, where_ + " needs \"" + field + "\"", {}, {}};
      return fallback;
    }
    if (!body_[field].is_string())
      throw error{ec::bad_input, where_ + ": \"" + field + "\" must be a text", {}, {}};
    return body_[field].get<std::string>();
  }

  std::filesystem::path path(const char* field) { return folder_ / text(field, {}, true); }

  std::vector<surface_id> surfaces() {
    known_.insert("surfaces");
    std::vector<surface_id> result;
    for (const auto& id : body_.value("surfaces", json::array())) {
      result.push_back(whole(id, where_ + ": each of \"surfaces\""));
    }
    return result;
  }

  ops::parameters parameters() {
    known_.insert("parameters");
    ops::parameters result;
    const auto given = body_.value("parameters", json::object());
    for (const auto& [name, value] : given.items()) {
      if (value.is_boolean())
        result[name] = value.get<bool>();
      else if (value.is_number_integer())
        result[name] = whole(value, where_ + ": parameter \"" + name + "\"");
      else if (value.is_number())
        result[name] = number(value, any_number(), where_ + ": parameter \"" + name + "\"");
      else if (value.is_string())
        result[name] = value.get<std::string>();
      else
        throw error{
          ec::bad_input, where_ + ": parameter \"" + name + "\" has no simple value", {}, {}};
    }
    return result;
  }

  std::optional<std::pair<double, double>> range(const char* field) {
    known_.insert(field);
    if (!body_.contains(field))
      return std::nullopt;
    const auto& given = body_[field];
    const auto what = where_ + ": \"" + field + "\"";
    if (!given.is_array() || given.size() != 2)
      throw error{ec::bad_input, what + " must be [least, largest]", {}, {}};
    const std::pair ends(number(given[0], any_number(), what),
                         number(given[1], any_number(), what));
    if (!(ends.first < ends.second))
      throw error{ec::bad_input, what + " must be [least, largest], the smaller one first", {}, {}};
    return ends;
  }

  fem::carry_settings loads() {
    fem::carry_settings result;
    const auto policy = fem::policy_from_name(text("loads", "drop"));
    if (!policy)
      throw error{ec::bad_input, where_ + ": " + policy.error().message, policy.error().remedy, {}};
    result.policy = *policy;
    known_.insert("keep_traction");
    const auto keep = body_.value("keep_traction", json(false));
    if (!keep.is_boolean())
      throw error{ec::bad_input, where_ + ": \"keep_traction\" must be true or false", {}, {}};
    result.keep_traction = keep.get<bool>();
    return result;
  }

  solve_step solve() {
    solve_step result;
    known_.insert("load_cases");
    if (const auto given = body_.value("load_cases", json::array()); given == "all")
      result.all_load_cases = true;
    else if (given.is_array() &&
             std::ranges::all_of(given, [](const json& name) { return name.is_string(); }))
      result.load_cases = given.get<std::vector<std::string>>();
    else
      throw error{
        ec::bad_input, where_ + ": \"load_cases\" must be a list of names, or \"all\"", {}, {}};
    known_.insert("energy_tolerance");
    if (body_.contains("energy_tolerance"))
      result.energy_tolerance =
        number(body_["energy_tolerance"], {1e-9, 0.5, {}}, where_ + ": \"energy_tolerance\"");
    return result;
  }

  void finish() const {
    for (const auto& [name, value] : body_.items())
      if (!known_.contains(name))
        throw error{ec::bad_input, where_ + " has an unknown field \"" + name + "\"", {}, {}};
  }

private:
  const json& body_;
  std::string where_;
  std::filesystem::path folder_;
  std::set<std::string> known_;
};

recipe_step make_step(const std::string& kind, step_reader& in) {
  if (kind == "import")
    return import_step{in.path("mesh"), in.text("length_unit", "mm")};
  if (kind == "load_case")
    return load_case_step{in.path("file")};
  if (kind == "edit")
    return edit_step{{in.text("operation", {}, true), in.surfaces(), in.parameters(), in.loads()}};
  if (kind == "undo")
    return undo_step{};
  if (kind == "redo")
    return redo_step{};
  if (kind == "solve")
    return in.solve();
  return export_step{in.text("vtu", {}), in.text("png", {}),   in.text("msh", {}),
                     in.text("stl", {}), in.text("title", {}), in.range("range_mpa")};
}

recipe parse(const json& body, const std::filesystem::path& folder) {
  const std::set<std::string> kinds(kind_names.begin(), kind_names.end());
  recipe result;
  if (!body.is_object() || !body.contains("steps") || !body["steps"].is_array())
    throw error{ec::bad_input, "a recipe is an object with a list \"steps\"", {}, {}};
  for (const auto& [name, value] : body.items())
    if (name != "name" && name != "device" && name != "tolerance" && name != "order" &&
        name != "steps")
      throw error{ec::bad_input, "the recipe has an unknown field \"" + name + "\"", {}, {}};
  result.name = body.value("name", std::string{});
  result.device = body.value("device", std::string("auto"));
  if (body.contains("tolerance"))
    result.tolerance = number(body["tolerance"], {1e-12, 0.1, {}}, "\"tolerance\"");
  const auto order = body.contains("order") ? whole(body["order"], "\"order\"") : 2;
  if (order != 1 && order != 2)
    throw error{ec::bad_input, "\"order\" must be 1 (linear tets) or 2 (quadratic)", {}, {}};
  result.order = static_cast<int>(order);
  std::size_t number = 0;
  for (const auto& step : body["steps"]) {
    const std::string where = "step " + std::to_string(++number);
    if (!step.is_object() || step.size() != 1 || !kinds.contains(step.begin().key()))
      throw error{ec::bad_input,
                  where + " must be one of import, load_case, edit, undo, redo, solve, export",
                  {},
                  {}};
    const auto kind = step.begin().key();
    if (!step.begin().value().is_object())
      throw error{ec::bad_input, where + ": write {\"" + kind + "\": {...}}", {}, {}};
    step_reader in(step.begin().value(), where + " (" + kind + ")", folder);
    result.steps.push_back(make_step(kind, in));
    in.finish();
  }
  return result;
}

}  // namespace

const char* kind_of(const recipe_step& step) {
  return kind_names[step.index()];
}

bool is_recipe(const std::filesystem::path& file) {
  std::ifstream in(file);
  const auto body = json::parse(in, nullptr, false);
  return body.is_object() && body.contains("steps");
}

expected<recipe> read_recipe(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in)
    return fail(ec::io_error, "cannot read the recipe " + file.string(),
                "Check the path and its permissions");
  try {
    return parse(json::parse(in), file.parent_path());
  } catch (const error& e) {
    return fail(e.code, e.message, "See docs/recipes.md", file.string());
  } catch (const json::exception& e) {
    return fail(ec::bad_input, std::string("this is no JSON: ") + e.what(), "See docs/recipes.md",
                file.string());
  }
}

}  // namespace tedit::client
