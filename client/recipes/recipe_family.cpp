// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/recipe_family.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "client/recipes/recipe_reading.hpp"
#include "client/recipes/values.hpp"
#include "mesh/formats.hpp"

namespace tedit::client {

namespace {

/// What stands in a place of a recipe.
enum class place { text, number, file_name };

bool is_one_of(const std::string& key, std::initializer_list<const char*> keys) {
  return std::ranges::any_of(keys, [&](const char* one) { return key == one; });
}

/// Whether a parameter of an operation is a number. One that nobody offers is a text: the server
/// refuses it by name.
bool is_number(const operation_catalogue& offered, const std::string& operation,
               const std::string& parameter) {
  for (const auto& one : offered.operations)
    for (const auto& p : one.about.parameters)
      if (one.about.id == operation && (p.id == parameter || p.id + "_mm" == parameter))
        return p.type == ops::parameter_type::real || p.type == ops::parameter_type::integer;
  return false;
}

bool is_output(const std::string& kind, const std::string& key) {
  if (kind == "compare")
    return is_one_of(key, {"json", "vtu", "png"});
  return kind == "export" && (key == "png" || find_format(key) != nullptr);
}

/// A number as people type it, without a group mark; nothing for anything else.
json number_in(std::string text) {
  const auto first = text.find_first_not_of(" \t");
  const auto last = text.find_last_not_of(" \t");
  if (first == std::string::npos)
    return nullptr;
  text = text.substr(first, last - first + 1);
  if (text.size() > 1 && text.front() == '+' && text[1] != '-')
    text.erase(0, 1);
  const auto* end = text.data() + text.size();
  std::int64_t whole = 0;
  if (const auto read = std::from_chars(text.data(), end, whole);
      read.ec == std::errc() && read.ptr == end)
    return whole;
  double value = 0;
  const auto read = std::from_chars(text.data(), end, value);
  return read.ec == std::errc() && read.ptr == end && std::isfinite(value) ? json(value) : json();
}

/// Fills the places of one row.
class filler {
public:
  filler(const csv_table& table, std::size_t row, std::string name,
         const operation_catalogue& offered, const std::filesystem::path& folder)
      : table_(table), row_(row), name_(std::move(name)), offered_(offered), folder_(folder) {}

  void fill_recipe(json& body) {
    if (body.is_array())
      return fill_steps(body);
    for (const auto& [key, value] : body.items())
      if (key == "steps" && value.is_array())
        fill_steps(value);
      else
        fill(value, is_one_of(key, {"tolerance", "order"}) ? place::number : place::text, key);
  }

private:
  void fill_steps(json& steps) {
    std::size_t number = 0;
    for (auto& step : steps) {
      step_ = "step " + std::to_string(++number);
      if (!step.is_object())
        continue;
      for (const auto& [kind, body] : step.items()) {
        step_ = "step " + std::to_string(number) + " (" + kind + ")";
        fill_body(kind, body);
      }
    }
  }

  void fill_body(const std::string& kind, json& body) {
    if (!body.is_object())
      return fill(body, kind == "go_to" ? place::number : place::text, kind);
    if (body.contains("operation"))
      fill(body["operation"], place::text, "operation");
    if (kind == "load_case" && body.contains("file"))
      take_in(body);
    for (const auto& [key, value] : body.items())
      if (kind == "load_case")
        fill_loads(value, key);
      else if (kind == "edit" && key == "parameters" && value.is_object())
        fill_parameters(body["operation"], value);
      else if (kind == "edit" && key == "surfaces" && value.is_array())
        fill_surfaces(value);
      else if (key != "operation")
        fill(value, place_of(kind, key), key);
  }

  /// A load case's file that has places itself stands in the step from then on.
  void take_in(json& body) {
    fill(body["file"], place::text, "file");
    if (!body["file"].is_string())
      return;
    const auto text = text_of_file(folder_ / body["file"].get<std::string>(), 64UL << 20);
    if (!text || text->find("{{") == std::string::npos)
      return;  // What is wrong with it is told by who reads it.
    auto inside = json::parse(*text, nullptr, false);
    if (inside.is_object())
      body = std::move(inside);
  }

  void fill_surfaces(json& list) {
    for (auto& item : list)
      if (!item.is_object())
        fill(item, place::number, "surfaces");
      else
        for (const auto& [key, value] : item.items())
          fill(value, is_word(key) ? place::text : place::number, key);
  }

  /// Of a reference to surfaces, and of a load case.
  static bool is_word(const std::string& key) {
    return is_one_of(key, {"name", "file", "warning", "made_by", "as"});
  }

  static place place_of(const std::string& kind, const std::string& key) {
    if (is_output(kind, key))
      return place::file_name;
    return is_one_of(key, {"surfaces", "energy_tolerance", "range_mpa", "before", "after"})
             ? place::number
             : place::text;
  }

  /// Of a load case all is numbers but the names.
  void fill_loads(json& value, const std::string& key) {
    if (value.is_object()) {
      for (const auto& [inner, part] : value.items())
        fill_loads(part, inner);
      return;
    }
    if (value.is_array()) {
      for (auto& part : value)
        fill_loads(part, key);
      return;
    }
    fill(value, is_word(key) ? place::text : place::number, key);
  }

  void fill_parameters(const json& operation, json& parameters) {
    const auto of = operation.is_string() ? operation.get<std::string>() : std::string();
    for (const auto& [id, value] : parameters.items())
      fill(value, value.is_array() || is_number(offered_, of, id) ? place::number : place::text,
           id);
  }

  /// Down into lists and objects, whose key is the last one before.
  void fill(json& value, place where, const std::string& key) {
    if (value.is_structured()) {
      for (auto& part : value)
        fill(part, where, key);
      return;
    }
    if (!value.is_string())
      return;
    const auto text = value.get<std::string>();
    if (text.find("{{") == std::string::npos)
      return;
    const bool alone = text.starts_with("{{") && text.find("}}") == text.size() - 2;
    if (where == place::number && alone)
      value = as_number(text, key);
    else
      value = filled(text, where);
  }

  std::string filled(const std::string& text, place where) const {
    std::string result;
    std::size_t from = 0;
    for (auto at = text.find("{{"); at != std::string::npos; at = text.find("{{", from)) {
      const auto end = text.find("}}", at);
      if (end == std::string::npos)
        refuse(step_ + " has {{ without }}: \"" + text + "\"", "Write {{column}}");
      const auto column = text.substr(at + 2, end - at - 2);
      const auto& cell = cell_of(column);
      if (where == place::file_name)
        check_file_name(cell, column);
      result += text.substr(from, at - from) + cell;
      from = end + 2;
    }
    return result + text.substr(from);
  }

  const std::string& cell_of(const std::string& column) const {
    const auto found = std::ranges::find(table_.columns, column);
    if (found != table_.columns.end())
      return table_.rows[row_].cells[static_cast<std::size_t>(found - table_.columns.begin())];
    if (column == "name")
      return name_;
    std::string known;
    for (const auto& one : table_.columns)
      known += (known.empty() ? "" : ", ") + one;
    refuse(step_ + " asks for {{" + column + "}}, and the table has no such column",
           "Its columns are " + known);
  }

  json as_number(const std::string& text, const std::string& key) const {
    const auto column = text.substr(2, text.size() - 4);
    const auto& cell = cell_of(column);
    auto result = number_in(cell);
    if (result.is_null())
      refuse(where(column) + ": \"" + cell + "\" is no number, and " + step_ + " needs one at \"" +
               key + "\"",
             "Write a number with a point, without its unit: 12.5");
    return result;
  }

  void check_file_name(const std::string& cell, const std::string& column) const {
    const bool bad = cell.empty() || cell == "." || cell == ".." || cell.size() > 200 ||
                     std::ranges::any_of(cell, [](unsigned char c) {
                       return c < 0x20 || c == 0x7F || c == '/' || c == '\\';
                     });
    if (bad)
      refuse(where(column) + ": \"" + cell + "\" cannot be part of a file's name, as " + step_ +
               " wants it",
             "Leave out / and \\, and write 1 to 200 bytes");
  }

  std::string where(const std::string& column) const {
    return "row " + std::to_string(row_ + 1) + " (line " + std::to_string(table_.rows[row_].line) +
           "), column \"" + column + "\"";
  }

  const csv_table& table_;
  std::size_t row_;
  std::string name_;
  const operation_catalogue& offered_;
  const std::filesystem::path& folder_;
  std::string step_ = "the recipe";
};

}  // namespace

struct recipe_family::parts {
  json body;
  operation_catalogue offered;
};

recipe_family::recipe_family(std::unique_ptr<parts> made, csv_table table,
                             std::filesystem::path folder)
    : table_(std::move(table)), folder_(std::move(folder)), parts_(std::move(made)) {
  // nop
}

recipe_family::recipe_family(recipe_family&&) noexcept = default;
recipe_family::~recipe_family() = default;

expected<recipe_family> recipe_family::read(const std::filesystem::path& recipe,
                                            const std::filesystem::path& table,
                                            const operation_catalogue& offered) {
  auto rows = read_csv(table);
  if (!rows)
    return fail(rows.error());
  const auto text = recipe_text(recipe);
  if (!text)
    return fail(text.error());
  try {
    auto made = std::make_unique<parts>(parts{parse_json(*text), offered});
    return recipe_family(std::move(made), std::move(*rows), recipe.parent_path());
  } catch (const error& e) {
    return fail(e.code, e.message, e.remedy,
                recipe.string() + (e.where.empty() ? "" : ", " + e.where));
  }
}

std::string recipe_family::name_of(std::size_t row) const {
  for (const auto* column : {"name", "id"})
    if (const auto found = std::ranges::find(table_.columns, column); found != table_.columns.end())
      return table_.rows[row].cells[static_cast<std::size_t>(found - table_.columns.begin())];
  return std::to_string(row + 1);
}

expected<recipe> recipe_family::recipe_of(std::size_t row) const {
  try {
    auto body = parts_->body;
    filler(table_, row, name_of(row), parts_->offered, folder_).fill_recipe(body);
    try {
      return recipe_from(body, folder_);
    } catch (error& e) {
      e.message = "row " + std::to_string(row + 1) + " (line " +
                  std::to_string(table_.rows[row].line) + "): " + e.message;
      throw;
    }
  } catch (const error& e) {
    return fail(e.code, e.message, e.remedy.empty() ? "See docs/recipes.md" : e.remedy);
  }
}

expected<void> recipe_family::check() const {
  std::map<std::string, std::size_t> writers;
  for (std::size_t row = 0; row < table_.rows.size(); ++row) {
    const auto recipe = recipe_of(row);
    if (!recipe)
      return fail(recipe.error());
    for (const auto& [step, file] : files_of(*recipe)) {
      const auto path = std::filesystem::path(file).lexically_normal().string();
      const auto [first, is_new] = writers.emplace(path, row);
      if (!is_new && first->second != row)
        return fail(ec::bad_input,
                    "rows " + std::to_string(first->second + 1) + " and " +
                      std::to_string(row + 1) + " would both write " + path + " in step " +
                      std::to_string(step),
                    "Put {{name}} into the file's name, and give each row another name");
    }
  }
  return {};
}

std::vector<std::pair<std::size_t, std::string>> files_of(const recipe& what) {
  std::vector<std::pair<std::size_t, std::string>> result;
  const auto add = [&](std::size_t step, const std::string& file) {
    if (!file.empty())
      result.emplace_back(step + 1, file);
  };
  for (std::size_t i = 0; i < what.steps.size(); ++i) {
    if (const auto* written = std::get_if<export_step>(&what.steps[i])) {
      for (const auto& [format, file] : written->files)
        add(i, file);
      add(i, written->png);
    }
    if (const auto* compared = std::get_if<compare_step>(&what.steps[i]))
      for (const auto* file : {&compared->json, &compared->vtu, &compared->png})
        add(i, *file);
  }
  return result;
}

}  // namespace tedit::client
