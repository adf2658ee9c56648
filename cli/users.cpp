// SPDX-License-Identifier: AGPL-3.0-or-later
// Who may use a server, and as what.
#include <chrono>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "actors/gateway/users.hpp"
#include "base/utc.hpp"
#include "certs/folders.hpp"
#include "cli/command.hpp"
#include "cli/config.hpp"

namespace tedit::cli {

namespace {

using gateway::access_role;
using gateway::user_file;
using nlohmann::ordered_json;

constexpr std::int64_t hour_s = 3600;
constexpr std::int64_t day_s = 24 * hour_s;
constexpr std::int64_t most_days = 3650;

struct users_options {
  std::optional<std::filesystem::path> config_file;
  std::string file;
  std::string name;
  std::string role = "edit";
  std::string expires = "90d";
  std::string output;
  std::int64_t number = 0;
};

/// "90d", "12h", "never"; when that is. Errors: `usage`.
expected<std::optional<std::int64_t>> read_end(const std::string& text) {
  if (text == "never")
    return std::nullopt;
  const auto digits = text.find_first_not_of("0123456789");
  const bool fits = digits != 0 && digits != std::string::npos && digits + 1 == text.size() &&
                    digits <= 5 && (text.back() == 'd' || text.back() == 'h');
  const auto seconds =
    fits ? std::stoll(text.substr(0, digits)) * (text.back() == 'd' ? day_s : hour_s) : 0;
  if (seconds < hour_s || seconds > most_days * day_s)
    return fail(ec::usage, "\"" + text + "\" is no time for which a token can hold",
                "Give hours or days, up to " + std::to_string(most_days) +
                  " days, as \"90d\" or \"12h\", or \"never\"");
  return gateway::seconds_now() + seconds;
}

expected<user_file> open_users(const users_options& options) {
  if (!options.file.empty())
    return user_file::open(options.file);
  return load_config(options.config_file)
    .and_then([](const server_config& config) { return users_path(config); })
    .and_then([](const std::filesystem::path& file) { return user_file::open(file); });
}

std::string end_text(const std::optional<std::int64_t>& until) {
  return until ? utc_text(*until) : "never";
}

/// Shows a token, or writes it to a file that its owner alone may read.
int hand_out(const users_options& options, const gateway::new_token& token,
             std::optional<std::int64_t> until, session& s) {
  ordered_json json{{"user", options.name},
                    {"number", token.number},
                    {"until", until ? ordered_json(utc_text(*until)) : ordered_json()}};
  const auto head = "token " + std::to_string(token.number) + " of " + options.name +
                    (until ? ", which ends at " + utc_text(*until) : ", which does not end");
  if (options.output.empty()) {
    json["token"] = token.text;
    print_result(s, json,
                 head + "\n  " + token.text +
                   "\nIt is shown this once. Give it to its user over a way that nobody else "
                   "reads.\n");
    return 0;
  }
  if (auto ok = certs::write_new(options.output, token.text + "\n"); !ok)
    return print_error(s, ok.error());
  json["file"] = options.output;
  print_result(s, json, head + ", is in " + options.output + "\n");
  return 0;
}

int run_users_add(const users_options& options, session& s) {
  const auto until = read_end(options.expires);
  if (!until)
    return print_error(s, until.error());
  auto users = open_users(options);
  if (!users)
    return print_error(s, users.error());
  const auto role = *gateway::access_role_named(options.role);  // There is no other.
  const auto token = users->add(options.name, role, *until);
  return token ? hand_out(options, *token, *until, s) : print_error(s, token.error());
}

int run_users_token(const users_options& options, session& s) {
  const auto until = read_end(options.expires);
  if (!until)
    return print_error(s, until.error());
  auto users = open_users(options);
  if (!users)
    return print_error(s, users.error());
  const auto token = users->add_token(options.name, *until);
  return token ? hand_out(options, *token, *until, s) : print_error(s, token.error());
}

/// A change that says nothing but that it was made.
template <class Change>
int change_users(const users_options& options, session& s, const std::string& done, Change change) {
  auto users = open_users(options);
  if (!users)
    return print_error(s, users.error());
  if (auto ok = change(*users); !ok)
    return print_error(s, ok.error());
  print_result(s, {{"done", done}}, done + "\n");
  return 0;
}

int run_users_role(const users_options& options, session& s) {
  return change_users(
    options, s, options.name + " has the role " + options.role, [&](user_file& users) {
      return users.set_role(options.name, *gateway::access_role_named(options.role));
    });
}

int run_users_withdraw(const users_options& options, session& s) {
  return change_users(options, s,
                      "token " + std::to_string(options.number) +
                        " holds no longer; who is connected with it is cut off within a minute",
                      [&](user_file& users) { return users.withdraw(options.number); });
}

int run_users_remove(const users_options& options, session& s) {
  return change_users(
    options, s,
    options.name + " is no user any more; who is connected so is cut off within a minute",
    [&](user_file& users) { return users.remove(options.name); });
}

int run_users_list(const users_options& options, session& s) {
  auto users = open_users(options);
  if (!users)
    return print_error(s, users.error());
  const auto all = users->list();
  if (!all)
    return print_error(s, all.error());
  auto rows = ordered_json::array();
  std::vector<std::vector<std::string>> table{{"name", "role", "token", "ends (UTC)", "state"}};
  const auto now = gateway::seconds_now();
  for (const auto& user : *all) {
    const std::string role(gateway::name_of(user.role));
    auto tokens = ordered_json::array();
    if (user.tokens.empty())
      table.push_back({user.name, role, "none", "", ""});
    for (const auto& token : user.tokens) {
      const bool ended = token.until && *token.until <= now;
      tokens.push_back(
        {{"number", token.number},
         {"made", utc_text(token.made)},
         {"until", token.until ? ordered_json(utc_text(*token.until)) : ordered_json()},
         {"ended", ended}});
      table.push_back({user.name, role, std::to_string(token.number), end_text(token.until),
                       ended ? "ended" : ""});
    }
    rows.push_back({{"name", user.name}, {"role", role}, {"tokens", std::move(tokens)}});
  }
  print_result(s, {{"users", std::move(rows)}},
               all->empty() ? "there are no users\n" : format_table(table, {1, 2, 3, 4}));
  return 0;
}

// -- commands ------------------------------------------------------------------------------------

using users_run = int (*)(const users_options&, session&);

CLI::App* add_users_command(CLI::App& users, action& chosen, const char* name, const char* does,
                            users_run run, const std::shared_ptr<users_options>& options) {
  auto* command = users.add_subcommand(name, does);
  command->add_option("--users-file", options->file,
                      "The file of the users; default: the one of the configuration");
  command->add_option("--config", options->config_file,
                      "Configuration (TOML) instead of $XDG_CONFIG_HOME/tedit/config.toml");
  command->callback(
    [options, run, &chosen] { chosen = [options, run](session& s) { return run(*options, s); }; });
  return command;
}

/// A command about one user.
CLI::App* add_user_command(CLI::App& users, action& chosen, const char* name, const char* does,
                           users_run run, const std::shared_ptr<users_options>& options) {
  auto* command = add_users_command(users, chosen, name, does, run, options);
  command->add_option("name", options->name, "The user's name")->required();
  return command;
}

void add_role(CLI::App& command, users_options& options) {
  std::vector<std::string> roles;
  for (const auto& row : gateway::access_roles)
    roles.emplace_back(row.name);
  command
    .add_option("--role", options.role,
                "view: look and export; edit: change documents, too; admin: also delete them")
    ->required()
    ->check(CLI::IsMember(roles));
}

void add_token_options(CLI::App& command, users_options& options) {
  command
    .add_option("--expires", options.expires,
                "How long the token holds, in days or hours (90d, 12h), or \"never\"")
    ->capture_default_str();
  command.add_option("-o,--output", options.output,
                     "Write the token to this new file instead of showing it");
}

}  // namespace

void add_users(CLI::App& app, action& chosen) {
  auto* users = app.add_subcommand("users", "Say who may use a server, and as what");
  users->require_subcommand(1);
  users->fallthrough();
  const auto made = [] { return std::make_shared<users_options>(); };
  auto options = made();
  auto* add = add_user_command(*users, chosen, "add", "Make a user and a first token",
                               run_users_add, options);
  add_role(*add, *options);
  add_token_options(*add, *options);
  options = made();
  add_token_options(*add_user_command(*users, chosen, "token", "Make one more token for a user",
                                      run_users_token, options),
                    *options);
  options = made();
  add_role(
    *add_user_command(*users, chosen, "role", "Give a user another role", run_users_role, options),
    *options);
  options = made();
  add_users_command(*users, chosen, "withdraw", "End a token; a user may have others",
                    run_users_withdraw, options)
    ->add_option("number", options->number, "The token's number, as \"list\" shows it")
    ->required();
  add_user_command(*users, chosen, "remove", "Forget a user and end all tokens", run_users_remove,
                   made());
  add_users_command(*users, chosen, "list", "List users, roles and tokens", run_users_list, made());
}

}  // namespace tedit::cli
