// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cstdlib>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/config_options.hpp"

namespace tedit::cli {

namespace {

struct show_options {
  config_options config;
  bool origin = false;
};

struct shown_value {
  std::string text;
  std::string origin;
};

/// Which variable of the environment a folder was made from, where no path is given.
std::string place_origin() {
  const char* state = std::getenv("XDG_STATE_HOME");
  return state && *state == '/' ? "environment: XDG_STATE_HOME" : "environment: HOME";
}

std::string quoted_path(const expected<std::filesystem::path>& path) {
  return path ? "\"" + path->string() + "\"" : "none: " + path.error().message;
}

/// What an environment variable or a rule of the program makes of a value that is left out.
shown_value value_of(const std::string& key, const server_config& config,
                     const config_origins& origins) {
  const auto found = origins.find(key);
  const char* sandbox = std::getenv("TEDIT_SANDBOX");
  if (key == "work.sandbox" && sandbox && std::string_view(sandbox) == "off")
    return {"\"off\"", "environment: TEDIT_SANDBOX"};
  if (key == "server.documents" && config.documents.empty())
    return {quoted_path(documents_folder(config)), place_origin()};
  if (key == "server.token_file" && config.token_file.empty())
    return {quoted_path(token_path(config)), place_origin()};
  if (key == "server.users_file" && config.users_file.empty())
    return {quoted_path(users_path(config)), "beside server.token_file"};
  return {config_text(config, key), found == origins.end() ? "default" : found->second};
}

int show_config(const show_options& given, session& s) {
  config_origins origins;
  const auto config = effective_config(given.config, &origins);
  if (!config)
    return print_error(s, config.error());
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  std::vector<std::vector<std::string>> rows{{"option", "value"}};
  std::string text;
  std::string table;
  if (given.origin)
    rows.front().emplace_back("from");
  for (const auto& key : config_keys()) {
    const auto one = value_of(key, *config, origins);
    json.push_back({{"option", key}, {"value", one.text}, {"from", one.origin}});
    rows.push_back({key, one.text});
    if (given.origin)
      rows.back().push_back(one.origin);
    const auto dot = key.find('.');
    if (key.substr(0, dot) != table) {
      table = key.substr(0, dot);
      text += (text.empty() ? "[" : "\n[") + table + "]\n";
    }
    text += key.substr(dot + 1) + " = " + one.text + "\n";
  }
  print_result(s, {{"options", json}}, given.origin ? format_table(rows, {1, 2}) : text);
  return 0;
}

}  // namespace

void add_config(CLI::App& app, action& chosen) {
  auto* command = app.add_subcommand("config", "Show the server's configuration");
  command->require_subcommand(1);
  auto options = std::make_shared<show_options>();
  auto* show = command->add_subcommand(
    "show",
    "Print every option that \"tedit serve\" would have here, with the same options, as TOML");
  add_config_options(*show, options->config);
  show->add_flag("--origin", options->origin,
                 "As a table, with where each comes from: file and line, an option, the "
                 "environment, or the default");
  show->callback(
    [options, &chosen] { chosen = [options](session& s) { return show_config(*options, s); }; });
}

}  // namespace tedit::cli
