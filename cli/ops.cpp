// SPDX-License-Identifier: AGPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/server_access.hpp"
#include "client/client.hpp"
#include "ops/loader/catalogue.hpp"
#include "protocol/operation_message.hpp"

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
    case ops::parameter_type::point:
      return "point";
    case ops::parameter_type::direction:
      return "direction";
    case ops::parameter_type::vector:
      return "vector";
    case ops::parameter_type::file:
      return "file";
    case ops::parameter_type::axis:
      return "axis";
    case ops::parameter_type::plane:
      return "plane";
    case ops::parameter_type::polyline:
      return "polyline";
    case ops::parameter_type::list:
      return "list";
  }
  return "text";
}

nlohmann::ordered_json to_json(const ops::parameter_value& value) {
  return std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, value);
}

nlohmann::ordered_json to_json(const offered_operation& one) {
  using json = nlohmann::ordered_json;
  const auto& d = one.about;
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
    if (!p.instead_of.empty())
      row["instead_of"] = p.instead_of;
    parameters.push_back(std::move(row));
  }
  return {{"id", d.id},
          {"name", d.name},
          {"summary", d.summary},
          {"version", d.version},
          {"plugin", one.plugin},
          {"selection", d.selection.help},
          {"parameters", std::move(parameters)}};
}

std::string describe(const ops::operation_description& d) {
  std::string text = d.id + " " + d.version + "  " + d.summary + "\n";
  text += "    select: " + d.selection.help + "\n";
  for (const auto& p : d.parameters) {
    text += "    " + p.id + " (" + type_name(p.type);
    if (!p.unit.empty())
      text += ", " + p.unit + (p.unit == "m" ? "; or " + p.id + "_mm" : "");
    if (p.min && p.max)
      text += ", " + pretty(*p.min) + " to " + pretty(*p.max) +
              (p.type == ops::parameter_type::polyline ? " points" : "");
    text += ", default " + to_json(p.default_value).dump() + "): " + p.help + "\n";
  }
  return text;
}

/// "2 crashes".
std::string times(unsigned crashes) {
  return std::to_string(crashes) + (crashes == 1 ? " crash" : " crashes");
}

nlohmann::ordered_json to_json(const refused_operation& one) {
  nlohmann::ordered_json row{{"file", one.file}, {"reason", one.reason}};
  if (one.crashes == 0)
    return row;
  if (!one.operation.empty())
    row["operation"] = one.operation;
  row["crashes"] = one.crashes;
  row["remedy"] = one.remedy;
  return row;
}

/// A line for a plugin that is not used; one in quarantine says how to lift it.
std::string describe(const refused_operation& one) {
  if (one.crashes == 0)
    return "not used: " + one.file + ": " + one.reason + "\n";
  return "quarantined: " +
         (one.operation.empty() ? one.file : one.operation + " (" + one.file + ")") + ", " +
         times(one.crashes) + ": " + one.reason + "\n    to lift it: " + one.remedy + "\n";
}

struct ops_options {
  std::string only;
  std::string server;
  server_access access;
};

/// What a running server offers, and what it has switched off since it started.
int run_on_server(const ops_options& options, session& s) {
  auto how = reach_server(options.server, options.access);
  if (!how)
    return print_error(s, how.error());
  how->client_name = "tedit ops " TEDIT_VERSION;
  auto connected = client::client::connect(*how, {});
  if (!connected)
    return print_error(s, connected.error());
  const auto all = (*connected)->operations();
  if (!all)
    return print_error(s, all.error());
  using json = nlohmann::ordered_json;
  json result{{"server", options.server}, {"operations", json::array()}};
  std::string text;
  std::vector<std::string> ids;
  for (const auto& one : all->operations) {
    ids.push_back(one.about.id);
    if (!options.only.empty() && options.only != one.about.id)
      continue;
    text += describe(one.about);
    result["operations"].push_back(to_json(one));
  }
  if (!options.only.empty() && text.empty())
    return print_error(s, ops::unknown_operation(options.only, ids));
  result["refused"] = json::array();
  for (const auto& one : all->refused) {
    result["refused"].push_back(to_json(one));
    text += describe(one);
  }
  print_result(s, result, text.empty() ? "There are no operations.\n" : text);
  return 0;
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
    json["operations"].push_back(to_json(offered_operation{entry.description, entry.plugin}));
    json["operations"].back()["file"] = entry.file.lexically_normal().string();
    text += describe(entry.description);
  }
  for (const auto& refused : plugins.refused()) {
    const refused_operation row{
      refused.file.string(), refused.reason, {}, refused.crashes, refused.remedy};
    text += describe(row);
    json["refused"].push_back(to_json(row));
  }
  print_result(s, json, text.empty() ? "There are no operations.\n" : text);
  return 0;
}

}  // namespace

void add_ops(CLI::App& app, action& chosen) {
  auto options = std::make_shared<ops_options>();
  auto* command = app.add_subcommand("ops", "List the editing operations and their parameters");
  command->add_option("operation", options->only, "Only this one");
  command->add_option(
    "--server", options->server,
    "List those of this server (ws[s]://HOST:PORT/v1), and what it put in quarantine");
  add_access_options(*command, options->access);
  command->callback([options, &chosen] {
    chosen = [options](session& s) {
      return options->server.empty() ? run_ops(options->only, s) : run_on_server(*options, s);
    };
  });
}

}  // namespace tedit::cli
