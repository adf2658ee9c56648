// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/family_result.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace tedit::cli {

namespace {

constexpr std::size_t most_columns_of_steps = 8;

nlohmann::ordered_json step_json(const family_step& step) {
  nlohmann::ordered_json json{
    {"number", step.number}, {"step", step.what}, {"status", status_name(step.status)}};
  if (step.passed_over)
    json["passed_over"] = true;
  if (step.status != family_status::not_run)
    json["ms"] = step.ms;
  return json;
}

template <class T>
void put(nlohmann::ordered_json& json, const char* key, const std::optional<T>& value) {
  if (value)
    json[key] = *value;
}

nlohmann::ordered_json row_json(const family_row& row) {
  nlohmann::ordered_json json{{"row", row.number}, {"name", row.name}};
  json["values"] = nlohmann::ordered_json::object();
  for (const auto& [column, cell] : row.cells)
    json["values"][column] = cell;
  json["status"] = status_name(row.status);
  if (const auto* step = row.failed_step())
    json["step"] = {{"number", step->number}, {"step", step->what}};
  if (row.failure) {
    json["code"] = code_name(row.failure->code);
    json["reason"] = row.failure->message;
    json["remedy"] = row.failure->remedy;
  }
  put(json, "volume_m3", row.volume_m3);
  put(json, "mass_kg", row.mass_kg);
  put(json, "max_displacement_m", row.max_displacement_m);
  put(json, "max_von_mises_pa", row.max_von_mises_pa);
  put(json, "min_safety_factor", row.min_safety_factor);
  if (row.max_von_mises_pa) {
    json["preview"] = row.preview;
    json["relative_error_estimate"] = row.error_estimate;
  }
  if (!row.singularity.empty())
    json["max_von_mises_is"] = row.singularity;
  if (!row.picture_missing.empty())
    json["picture_missing"] = row.picture_missing;
  json["steps"] = nlohmann::ordered_json::array();
  for (const auto& step : row.steps)
    json["steps"].push_back(step_json(step));
  json["files"] = row.files;
  json["ms"] = row.ms;
  return json;
}

std::string cell_of(const std::optional<double>& value, double scale, int digits = 4) {
  return value ? pretty(scale * *value, digits) : "";
}

std::vector<std::string> text_row(const family_row& row) {
  return {std::to_string(row.number),
          row.name,
          status_name(row.status),
          cell_of(row.mass_kg, 1),
          cell_of(row.volume_m3, 1e6, 6),
          cell_of(row.max_displacement_m, 1e3),
          cell_of(row.max_von_mises_pa, 1e-6),
          cell_of(row.min_safety_factor, 1, 3),
          pretty(1e-3 * row.ms, 3)};
}

std::string step_word(const family_step& step) {
  if (step.status == family_status::not_run)
    return "not reached";
  return step.passed_over ? "passed over" : status_name(step.status);
}

/// A line for each step: of few rows how it went in each, else how often.
std::string steps_text(const family_result& result) {
  const auto& first = *std::ranges::max_element(
    result.rows, {}, [](const family_row& row) { return row.steps.size(); });
  const bool each = result.rows.size() <= most_columns_of_steps;
  std::vector<std::vector<std::string>> lines{{"step"}};
  if (each)
    for (const auto& row : result.rows)
      lines[0].push_back(row.name);
  else
    lines[0] = {"step", "passed", "failed", "not reached"};
  for (std::size_t i = 0; i < first.steps.size(); ++i) {
    std::vector<std::string> line{std::to_string(first.steps[i].number) + " " +
                                  first.steps[i].what};
    std::size_t counts[3] = {};
    for (const auto& row : result.rows) {
      const auto step = i < row.steps.size() ? row.steps[i] : family_step{};
      ++counts[static_cast<std::size_t>(step.status)];
      if (each)
        line.push_back(step_word(step));
    }
    for (const auto count : counts)
      if (!each)
        line.push_back(std::to_string(count));
    lines.push_back(std::move(line));
  }
  return format_table(lines);
}

std::string failures_text(const family_result& result) {
  std::string text;
  for (const auto& row : result.rows) {
    if (row.status != family_status::failed || !row.failure)
      continue;
    const auto* step = row.failed_step();
    text += "  row " + std::to_string(row.number) + " (" + row.name + ") failed" +
            (step ? " in step " + std::to_string(step->number) + " (" + step->what + ")" : "") +
            ": " + render(*row.failure) + "\n";
  }
  return text.empty() ? text : text + "\n";
}

}  // namespace

const char* status_name(family_status status) noexcept {
  switch (status) {
    case family_status::passed:
      return "passed";
    case family_status::failed:
      return "failed";
    case family_status::not_run:
      break;
  }
  return "not_run";
}

const family_step* family_row::failed_step() const {
  const auto found = std::ranges::find(steps, family_status::failed, &family_step::status);
  return found == steps.end() ? nullptr : &*found;
}

std::size_t family_result::count(family_status status) const {
  return static_cast<std::size_t>(std::ranges::count(rows, status, &family_row::status));
}

std::size_t family_result::yielding() const {
  return static_cast<std::size_t>(std::ranges::count_if(
    rows, [](const family_row& row) { return row.min_safety_factor.value_or(1) < 1; }));
}

nlohmann::ordered_json to_json(const family_result& result) {
  nlohmann::ordered_json json{{"name", result.name},
                              {"table", result.table},
                              {"server", result.server},
                              {"jobs", result.jobs}};
  json["rows"] = nlohmann::ordered_json::array();
  for (const auto& row : result.rows)
    json["rows"].push_back(row_json(row));
  for (const auto status : {family_status::passed, family_status::failed, family_status::not_run})
    json[status_name(status)] = result.count(status);
  json["safety_factor_below_1"] = result.yielding();
  if (!result.report.empty())
    json["report"] = result.report;
  json["total_ms"] = result.ms;
  return json;
}

std::string describe(const family_result& result) {
  std::vector<std::vector<std::string>> lines{{"row", "name", "status", "mass kg", "volume cm3",
                                               "max displ. mm", "max von Mises MPa",
                                               "safety factor", "s"}};
  for (const auto& row : result.rows)
    lines.push_back(text_row(row));
  std::string text = result.name + "\n\n" + format_table(lines, {1, 2}) + "\n" +
                     steps_text(result) + "\n" + failures_text(result) + "  " +
                     std::to_string(result.count(family_status::passed)) + " of " +
                     std::to_string(result.rows.size()) + " rows passed";
  if (const auto failed = result.count(family_status::failed); failed > 0)
    text += ", " + std::to_string(failed) + " failed";
  if (const auto left = result.count(family_status::not_run); left > 0)
    text += ", " + std::to_string(left) + " were not carried out";
  if (const auto weak = result.yielding(); weak > 0)
    text += "; " + std::to_string(weak) + " with a safety factor below 1";
  text += ".\n";
  if (!result.report.empty())
    text += "  wrote " + result.report + "\n";
  return text + "  " + pretty(result.ms / 1000, 3) + " s, " + std::to_string(result.jobs) +
         (result.jobs == 1 ? " row at a time.\n" : " rows at a time.\n");
}

}  // namespace tedit::cli
