// SPDX-License-Identifier: AGPL-3.0-or-later
// The authority whose certificates nodes on other machines show each other.
#include "certs/authority.hpp"

#include <ctime>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/utc.hpp"
#include "cli/command.hpp"

namespace tedit::cli {

namespace {

using nlohmann::ordered_json;

struct certs_options {
  std::string folder;
  std::string name;
  std::string role;
  std::string serial;
  std::vector<std::string> hosts;
  int days = 0;
  std::string output;

  /// Without -o: a folder of the node's name, here.
  [[nodiscard]] std::string output_folder() const { return output.empty() ? name : output; }
  [[nodiscard]] certs::seconds valid() const { return days * certs::day; }
};

ordered_json certs_json(const certs::certificate& one) {
  return {{"name", one.name},
          {"role", certs::role_name(one.what)},
          {"serial", one.serial},
          {"hosts", one.hosts},
          {"valid_from", utc_text(one.from)},
          {"valid_until", utc_text(one.until)},
          {"revoked", one.revoked}};
}

int run_certs_init(const certs_options& options, session& s) {
  const auto made = certs::init(options.folder, options.name, options.valid());
  if (!made)
    return print_error(s, made.error());
  print_result(
    s, {{"folder", options.folder}, {"name", made->name}, {"valid_until", utc_text(made->until)}},
    options.folder + ": the authority " + made->name + ", which ends at " + utc_text(made->until) +
      "\nWhoever has " + certs::authority_key_file +
      " can make nodes of this server: it stays on this machine, with a copy in a safe place.\n");
  return 0;
}

int print_handed_out(const certs_options& options, const certs::certificate& made, session& s,
                     const std::string& more) {
  auto json = certs_json(made);
  json["folder"] = options.output_folder();
  print_result(s, json,
               options.output_folder() + ": key and certificate of " + made.name + " (" +
                 std::string(certs::role_name(made.what)) + "), serial " + made.serial +
                 ", until " + utc_text(made.until) + "\n" + more);
  return 0;
}

int run_certs_issue(const certs_options& options, session& s) {
  const certs::order what{*certs::role_named(options.role),  // The command line takes no other.
                          options.name, options.hosts, options.valid()};
  const auto made = certs::issue(options.folder, what, options.output_folder());
  if (!made)
    return print_error(s, made.error());
  return print_handed_out(options, *made, s,
                          "Bring the folder to its machine over a way that nobody else reads, and "
                          "keep no copy.\n");
}

int run_certs_renew(const certs_options& options, session& s) {
  const auto made =
    certs::renew(options.folder, options.name, options.valid(), options.output_folder());
  if (!made)
    return print_error(s, made.error());
  return print_handed_out(options, *made, s,
                          "The one before holds until its end, unless it is revoked by its serial "
                          "(\"tedit certs list\").\n");
}

int run_certs_revoke(const certs_options& options, session& s) {
  if (options.name.empty() == options.serial.empty())
    return print_error(s, {ec::usage,
                           "say whose certificate is to hold no longer",
                           "Give either --name or --serial; \"tedit certs list\" has both",
                           {}});
  const auto ended = certs::revoke(options.folder, {options.name, options.serial});
  if (!ended)
    return print_error(s, ended.error());
  const auto file = options.folder + "/" + certs::revoked_file;
  auto json = ordered_json::array();
  std::string text;
  for (const auto& one : *ended) {
    json.push_back(certs_json(one));
    text += one.name + ", serial " + one.serial + ": holds no longer\n";
  }
  print_result(s, {{"revoked", std::move(json)}, {"list", file}},
               text + "A server heeds it within a minute when its list is " + file +
                 "; else copy that file to the server's folder.\n");
  return 0;
}

std::string certs_text(const certs::listing& all, std::int64_t now) {
  std::vector<std::vector<std::string>> table{
    {"name", "role", "serial", "valid until (UTC)", "state"}};
  for (const auto& one : all.certificates)
    table.push_back({one.name, std::string(certs::role_name(one.what)), one.serial,
                     utc_text(one.until),
                     one.revoked       ? "revoked"
                     : one.until < now ? "ended"
                                       : ""});
  const auto head = all.name + ", until " + utc_text(all.until) + "\n";
  return head + (all.certificates.empty() ? "no certificate was issued\n"
                                          : format_table(table, {1, 2, 3, 4}));
}

int run_certs_list(const certs_options& options, session& s) {
  const auto all = certs::list(options.folder);
  if (!all)
    return print_error(s, all.error());
  auto rows = ordered_json::array();
  for (const auto& one : all->certificates)
    rows.push_back(certs_json(one));
  print_result(s,
               {{"authority", {{"name", all->name}, {"valid_until", utc_text(all->until)}}},
                {"certificates", std::move(rows)}},
               certs_text(*all, static_cast<std::int64_t>(std::time(nullptr))));
  return 0;
}

// -- commands ------------------------------------------------------------------------------------

using certs_run = int (*)(const certs_options&, session&);

/// A command with the folder of an authority as its argument.
CLI::App* add_certs_command(CLI::App& certs, action& chosen, const char* name, const char* does,
                            certs_run run, const std::shared_ptr<certs_options>& options) {
  auto* command = certs.add_subcommand(name, does);
  command->add_option("folder", options->folder, "The authority's folder")->required();
  command->callback(
    [options, run, &chosen] { chosen = [options, run](session& s) { return run(*options, s); }; });
  return command;
}

void add_days(CLI::App& command, certs_options& options, certs::seconds usual, int most) {
  options.days = static_cast<int>(usual / certs::day);
  command.add_option("--days", options.days, "How long it holds, from now")
    ->check(CLI::Range(1, most))
    ->capture_default_str();
}

void add_output(CLI::App& command, certs_options& options, const char* what) {
  command.add_option("-o,--output", options.output, what);
}

void add_certs_init(CLI::App& certs, action& chosen) {
  auto options = std::make_shared<certs_options>();
  auto* command = add_certs_command(certs, chosen, "init", "Make an authority in a new folder",
                                    run_certs_init, options);
  options->name = "TEdit";
  command->add_option("--name", options->name, "Its name, as messages say it")
    ->capture_default_str();
  add_days(*command, *options, certs::authority_days, 7300);
}

void add_certs_issue(CLI::App& certs, action& chosen) {
  auto options = std::make_shared<certs_options>();
  auto* command = add_certs_command(certs, chosen, "issue",
                                    "Make a key and a certificate: what one node needs, in a "
                                    "folder of its own",
                                    run_certs_issue, options);
  std::vector<std::string> roles;
  for (const auto& row : certs::all_roles)
    roles.emplace_back(row.name);
  command->add_option("--role", options->role, "What its owner may be")
    ->required()
    ->check(CLI::IsMember(roles));
  command->add_option("--name", options->name, "Its owner's name")->required();
  command
    ->add_option("--host", options->hosts,
                 "Host name or IP address under which a server is dialled, beside its name; may be "
                 "given several times")
    ->allow_extra_args(false);
  add_days(*command, *options, certs::node_days, 7300);
  add_output(*command, *options, "The new folder; default: NAME");
}

void add_certs_renew(CLI::App& certs, action& chosen) {
  auto options = std::make_shared<certs_options>();
  auto* command = add_certs_command(certs, chosen, "renew",
                                    "Make a new key and certificate of the same name, role and "
                                    "hosts",
                                    run_certs_renew, options);
  command->add_option("--name", options->name, "Its owner's name")->required();
  add_days(*command, *options, certs::node_days, 7300);
  add_output(*command, *options,
             "The folder, default: NAME; the files of that node there are exchanged in one step");
}

void add_certs_revoke(CLI::App& certs, action& chosen) {
  auto options = std::make_shared<certs_options>();
  auto* command =
    add_certs_command(certs, chosen, "revoke",
                      "Say that certificates hold no longer; a server cuts who is connected with "
                      "one",
                      run_certs_revoke, options);
  command->add_option("--name", options->name, "All of this name");
  command->add_option("--serial", options->serial, "The one with this serial");
}

}  // namespace

void add_certs(CLI::App& app, action& chosen) {
  auto* command =
    app.add_subcommand("certs", "Make and keep the certificates of nodes on other machines");
  command->require_subcommand(1);
  command->fallthrough();
  add_certs_init(*command, chosen);
  add_certs_issue(*command, chosen);
  add_certs_renew(*command, chosen);
  add_certs_revoke(*command, chosen);
  add_certs_command(*command, chosen, "list",
                    "List the certificates that an authority issued: name, role, serial, end, "
                    "whether revoked",
                    run_certs_list, std::make_shared<certs_options>());
}

}  // namespace tedit::cli
