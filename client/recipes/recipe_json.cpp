// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <span>

#include "base/part_sizes.hpp"
#include "client/recipe.hpp"
#include "client/recipes/field_reader.hpp"
#include "client/recipes/recipe_reading.hpp"
#include "client/recipes/reference_json.hpp"
#include "client/recipes/values.hpp"
#include "client/recipes/window_rules.hpp"
#include "mesh/formats.hpp"
#include "protocol/convert.hpp"

namespace tedit::client {

namespace {

constexpr std::size_t most_steps = 100'000;

// -- fields: one list for who reads and who writes -------------------------------------------

template <class Io>
void fields_of(Io& io, import_step& s) {
  io.needed("mesh", s.mesh);
  io.other("length_unit", s.length_unit);
  io.one_word("size", s.size, part_sizes);
  io.other("local_sizes_mm", s.local_sizes_mm, {1e-3, 1e6, "mm"});
}

template <class Io>
void fields_of(Io& io, load_case_step& s) {
  io.whole(s.loads, s.references);
}

template <class Io>
void fields_of(Io& io, remove_load_case_step& s) {
  io.needed("remove_load_case", s.name);
}

template <class Io>
void changes_of(Io& io, edit_request& request) {
  io.other("parameters", request.parameters);
  io.other("loads", request.loads.policy);
  io.other("keep_traction", request.loads.keep_traction);
}

template <class Io>
void fields_of(Io& io, edit_step& s) {
  io.needed("operation", s.request.operation);
  io.surfaces("surfaces", s.request.surfaces, s.references);
  changes_of(io, s.request);
  io.other("label", s.label);
}

template <class Io>
void fields_of(Io&, undo_step&) {}

template <class Io>
void fields_of(Io&, redo_step&) {}

template <class Io>
void fields_of(Io& io, go_to_step& s) {
  io.needed("go_to", s.version);
}

template <class Io>
void fields_of(Io& io, solve_step& s) {
  io.cases("load_cases", s);
  io.other("energy_tolerance", s.energy_tolerance, {1e-9, 0.5, {}});
}

template <class Io>
void fields_of(Io& io, export_step& s) {
  for (const auto& format : file_formats)
    if (format.writes)
      io.one_of(std::string(format.name), s.files);
  io.one_of(step_format, s.files);
  io.other("png", s.png);
  io.other("title", s.title);
  io.other("range_mpa", s.range_mpa);
}

template <class Io>
void fields_of(Io& io, compare_step& s) {
  io.needed("before", s.before);
  io.other("after", s.after);
  io.other("load_case", s.load_case);
  io.other("json", s.json);
  io.other("vtu", s.vtu);
  io.other("png", s.png);
  io.other("title", s.title);
}

template <class Io>
void fields_of(Io& io, apply_step& s) {
  io.needed("apply", s.request.operation);
  changes_of(io, s.request);
}

template <class Io>
void fields_of(Io& io, recipe& r) {
  io.other("name", r.name);
  io.other("device", r.device);
  io.other("tolerance", r.tolerance, {1e-12, 0.1, {}});
  io.other("order", r.order);
}

// -- reading ---------------------------------------------------------------------------------

template <class Step>
recipe_step read_as(field_reader& in) {
  Step result;
  fields_of(in, result);
  return result;
}

/// A kind whose fields this program works with itself.
struct known_kind {
  const char* name;
  bool has_body;  ///< Its fields stand in an object of their own, not in the step itself.
  recipe_step (*read)(field_reader& in);
};

/// In the order of `recipe_step`.
constexpr known_kind known_kinds[] = {{"import", true, read_as<import_step>},
                                      {"load_case", true, read_as<load_case_step>},
                                      {"remove_load_case", false, read_as<remove_load_case_step>},
                                      {"edit", true, read_as<edit_step>},
                                      {"undo", true, read_as<undo_step>},
                                      {"redo", true, read_as<redo_step>},
                                      {"go_to", false, read_as<go_to_step>},
                                      {"solve", true, read_as<solve_step>},
                                      {"export", true, read_as<export_step>},
                                      {"compare", true, read_as<compare_step>},
                                      {"apply", false, read_as<apply_step>}};
static_assert(std::size(known_kinds) + 1 == std::variant_size_v<recipe_step>);

const known_kind* find_known(const std::string& name) {
  const auto* found = std::ranges::find(known_kinds, name, &known_kind::name);
  return found == std::end(known_kinds) ? nullptr : found;
}

std::string all_kinds() {
  std::string result;
  for (const auto& one : known_kinds)
    result += std::string(result.empty() ? "" : ", ") + one.name;
  return result + window_kinds();
}

/// The one field of a step that is a kind.
std::string kind_in(const json& step, const std::string& where) {
  if (!step.is_object() || step.empty())
    refuse(where + " must be {\"edit\": {...}} or the like");
  std::string kind;
  for (const auto& [name, value] : step.items()) {
    if (!find_known(name) && !is_window_kind(name))
      continue;
    if (!kind.empty())
      refuse(where + " is two at once, \"" + kind + "\" and \"" + name + "\"",
             "Write a step for each");
    kind = name;
  }
  if (kind.empty())
    refuse(where + ": there is no step \"" + step.begin().key() + "\"",
           "The steps are " + all_kinds());
  return kind;
}

recipe_step read_step(const json& step, std::string where, const std::filesystem::path& folder) {
  const auto kind = kind_in(step, where);
  where += " (" + kind + ")";
  const auto* known = find_known(kind);
  if (!known) {
    check_window_step(step, kind, where);
    return window_step{kind, step.dump()};
  }
  const auto none = json::object();
  const bool bare = step[kind] == true && (kind == "undo" || kind == "redo");
  const auto& body = bare ? none : known->has_body ? step[kind] : step;
  if (!body.is_object())
    refuse(where + ": write {\"" + kind + "\": {...}}");
  if (known->has_body && step.size() > 1)
    refuse(where + " has fields beside \"" + kind + "\"");
  field_reader in(body, where, folder);
  auto result = known->read(in);
  in.finish();
  return result;
}

}  // namespace

recipe recipe_from(const json& body, const std::filesystem::path& folder) {
  recipe result;
  const json* steps = body.is_array() ? &body : nullptr;
  if (body.is_object()) {
    field_reader in(body, "the recipe", folder);
    fields_of(in, result);
    in.ignore("steps");
    in.finish();
    steps = body.contains("steps") ? &body["steps"] : nullptr;
  }
  if (!steps || !steps->is_array())
    refuse("a recipe is an object with a list \"steps\", or the list alone");
  for (const auto& step : list_from(*steps, 0, most_steps, "\"steps\""))
    result.steps.push_back(
      read_step(step, "step " + std::to_string(result.steps.size() + 1), folder));
  check_labels(result.steps);
  return result;
}

namespace {

// -- writing ---------------------------------------------------------------------------------

/// Writes the fields that are not as usual.
class field_writer {
public:
  nlohmann::ordered_json body = nlohmann::ordered_json::object();

  template <class T>
  void needed(const char* field, const T& value) {
    body[field] = plain(value);
  }
  template <class T>
  void other(const char* field, const T& value, const number_range& = {}) {
    if (value != T{})
      body[field] = plain(value);
  }
  void one_of(const std::string& field, const std::map<std::string, std::string>& all) {
    if (const auto found = all.find(field); found != all.end())
      body[field] = found->second;
  }
  void one_word(const char* field, const std::string& value, std::span<const std::string_view>) {
    other(field, value);
  }
  void cases(const char* field, const solve_step& s) {
    if (s.all_load_cases)
      body[field] = "all";
    else
      other(field, s.load_cases);
  }
  void surfaces(const char* field, const std::vector<surface_id>& ids,
                const std::vector<surface_reference>& references) {
    other(field, ids);
    if (!ids.empty())
      put_references(body[field], references);
  }
  void whole(const fem::load_case& loads, const std::vector<surface_reference>& references) {
    body = nlohmann::ordered_json::parse(protocol::load_case_to_json(loads));
    put_all_references(body, references);
  }

private:
  template <class T>
  static const T& plain(const T& value) {
    return value;
  }
  static std::string plain(const std::filesystem::path& value) { return value.string(); }
  static std::uint32_t plain(const std::optional<std::uint32_t>& value) { return *value; }
  static std::string_view plain(fem::load_policy value) { return fem::policy_name(value); }
  static json plain(const std::optional<std::pair<double, double>>& value) {
    return {value->first, value->second};
  }
  static json plain(const ops::parameters& values) {
    json result;
    for (const auto& [id, value] : values)
      std::visit([&, &id = id](const auto& simple) { result[id] = simple; }, value);
    return result;
  }
};

}  // namespace

std::string to_json(const recipe_step& step) {
  if (const auto* of_window = std::get_if<window_step>(&step))
    return of_window->json;
  field_writer out;
  const auto write = [&](auto s) {
    if constexpr (!std::is_same_v<decltype(s), window_step>)
      fields_of(out, s);
  };
  std::visit(write, step);
  const auto& kind = known_kinds[step.index()];
  const auto whole =
    kind.has_body ? nlohmann::ordered_json{{kind.name, std::move(out.body)}} : std::move(out.body);
  return whole.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string to_json(const recipe& what) {
  recipe usual;
  recipe wanted = what;
  field_writer before;
  field_writer out;
  fields_of(before, usual);
  fields_of(out, wanted);
  std::string result = "{";
  for (const auto& [field, value] : out.body.items())
    if (before.body.value(field, json()) != value)
      result += json(field).dump() + ": " + value.dump() + ",\n ";
  result += "\"steps\": [";
  for (std::size_t i = 0; i < what.steps.size(); ++i)
    result += (i == 0 ? "\n  " : ",\n  ") + to_json(what.steps[i]);
  return result + "\n]}\n";
}

const char* kind_of(const recipe_step& step) {
  const auto* of_window = std::get_if<window_step>(&step);
  return of_window ? of_window->kind.c_str() : known_kinds[step.index()].name;
}

bool is_of_window(const recipe_step& step) {
  return std::holds_alternative<apply_step>(step) || std::holds_alternative<window_step>(step);
}

expected<recipe> recipe_from_json(std::string_view text, const std::filesystem::path& folder) {
  try {
    return recipe_from(parse_json(text), folder);
  } catch (const error& e) {
    return fail(e.code, e.message, e.remedy.empty() ? "See docs/recipes.md" : e.remedy, e.where);
  }
}

}  // namespace tedit::client
