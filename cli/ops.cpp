// SPDX-License-Identifier: AGPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "ops/loader/catalogue.hpp"

namespace tedit::cli {

namespace {

const char* type_name(ops::parameter_type type) {
  switch (type) {
    case ops::parameter_type::boolean:
      return "boolean";
    case ops::parameter_type::integer:
      return "integer";
    case ops::parameter_type::real:
      return "real";
    case ops::parameter_type::text:
      return "text";
    case ops::parameter_type::choice:
      return "choice";
  }
  return "text";
}

nlohmann::ordered_json to_json(const ops::parameter_value& value) {
  return std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, value);
}

nlohmann::ordered_json to_json(const ops::catalogue::entry& entry) {
  using json = nlohmann::ordered_json;
  const auto& d = entry.description;
  json parameters = json::array();
  for (const auto& p : d.parameters) {
    json row{{"id", p.id},     {"name", p.name}, {"type", type_name(p.type)},
             {"unit", p.unit}, {"help", p.help}, {"default", to_json(p.default_value)}};
    if (p.min)
      row["min"] = *p.min;
    if (p.max)
      row["max"] = *p.max;
    if (!p.choices.empty())
      row["choices"] = p.choices;
    parameters.push_back(std::move(row));
  }
  return {{"id", d.id},
          {"name", d.name},
          {"summary", d.summary},
          {"version", d.version},
          {"plugin", entry.plugin},
          {"file", entry.file.lexically_normal().string()},
          {"selection", d.selection.help},
          {"parameters", std::move(parameters)}};
}

std::string describe(const ops::catalogue::entry& entry) {
  const auto& d = entry.description;
  std::string text = d.id + " " + d.version + "  " + d.summary + "\n";
  text += "    select: " + d.selection.help + "\n";
  for (const auto& p : d.parameters) {
    text += "    " + p.id + " (" + type_name(p.type);
    if (!p.unit.empty())
      text += ", " + p.unit + (p.unit == "m" ? "; or " + p.id + "_mm" : "");
    if (p.min && p.max)
      text += ", " + pretty(*p.min) + " to " + pretty(*p.max);
    text += ", default " + to_json(p.default_value).dump() + "): " + p.help + "\n";
  }
  return text;
}

int run_ops(const std::string& only, session& s) {
  const auto plugins = ops::load_default_catalogue();
  nlohmann::ordered_json json{{"operations", nlohmann::ordered_json::array()},
                              {"refused", nlohmann::ordered_json::array()}};
  std::string text;
  if (!only.empty()) {
    if (const auto found = plugins.find(only); !found)
      return print_error(s, found.error());
  }
  for (const auto& entry : plugins.entries()) {
    if (!only.empty() && entry.description.id != only)
      continue;
    json["operations"].push_back(to_json(entry));
    text += describe(entry);
  }
  for (const auto& refused : plugins.refused()) {
    json["refused"].push_back({{"file", refused.file.string()}, {"reason", refused.reason}});
    text += "not used: " + refused.file.string() + ": " + refused.reason + "\n";
  }
  print_result(s, json, text.empty() ? "There are no operations.\n" : text);
  return 0;
}

}  // namespace

void add_ops(CLI::App& app, action& chosen) {
  auto only = std::make_shared<std::string>();
  auto* command = app.add_subcommand("ops", "List the editing operations and their parameters");
  command->add_option("operation", *only, "Only this one");
  command->callback([only, &chosen] { chosen = [only](session& s) { return run_ops(*only, s); }; });
}

}  // namespace tedit::cli
