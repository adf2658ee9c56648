// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <utility>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/attachment.hpp"
#include "cli/command.hpp"
#include "cli/number_option.hpp"
#include "cli/parameters.hpp"
#include "cli/plugin_new.hpp"
#include "mesh/io/import.hpp"
#include "ops/conformance/conformance.hpp"
#include "ops/loader/catalogue.hpp"

namespace tedit::cli {

namespace {

struct test_options {
  std::string file;
  std::string mesh;
  std::string length_unit = "mm";
  std::vector<surface_id> selected;
  std::vector<std::string> pairs;
  std::vector<std::string> checks;
  unsigned repeat = 1;
  double limit_s = 10;
  bool list = false;
};

const char* outcome_name(ops::verdict outcome) {
  switch (outcome) {
    case ops::verdict::pass:
      return "PASS";
    case ops::verdict::fail:
      return "FAIL";
    case ops::verdict::not_run:
      return "----";
  }
  return "----";
}

std::string line_of(const ops::conformance_row& row) {
  std::string text = std::string(outcome_name(row.outcome)) + "  " + row.check;
  text.resize(std::max<std::size_t>(text.size(), 28), ' ');
  text += "  " + row.seen + "\n";
  if (row.outcome == ops::verdict::fail)
    text += "        rule: " + row.rule + "\n        do:   " + row.remedy + "\n";
  if (row.outcome == ops::verdict::fail)
    for (const auto& line : row.log)
      text += "        log:  " + line + "\n";
  return text;
}

nlohmann::ordered_json to_json(const ops::conformance_row& row) {
  const char* outcome = row.outcome == ops::verdict::pass   ? "pass"
                        : row.outcome == ops::verdict::fail ? "fail"
                                                            : "not_run";
  return {{"check", row.check}, {"rule", row.rule},     {"outcome", outcome},
          {"seen", row.seen},   {"remedy", row.remedy}, {"operation", row.operation},
          {"log", row.log}};
}

expected<void> check_names(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const auto& row : ops::conformance_checks())
    known.push_back(row.check);
  for (const auto& name : names)
    if (std::ranges::find(known, name) == known.end()) {
      const auto near = ops::nearest_name(name, known);
      return fail(ec::usage, "there is no check \"" + name + "\"",
                  (near.empty() ? "" : "Did you mean " + near + "? ") +
                    std::string("\"tedit plugin test --list\" prints all"));
    }
  return {};
}

expected<ops::conformance_settings> settings_of(const test_options& options) {
  ops::conformance_settings settings;
  if (auto known = check_names(options.checks); !known)
    return fail(std::move(known.error()));
  settings.checks = options.checks;
  settings.repeat = options.repeat;
  std::error_code code;
  settings.file = std::filesystem::absolute(options.file, code);
  if (!std::filesystem::is_regular_file(settings.file, code))
    return fail(ec::io_error, "there is no file " + options.file,
                "Build the plugin first; its file ends in .so");
  if (!options.mesh.empty()) {
    auto imported = import_mesh(options.mesh, options.length_unit);
    if (!imported)
      return fail(imported.error());
    settings.part = imported->version;
  }
  for (const auto id : options.selected)
    if (!settings.part || !settings.part->find_surface(id))
      return fail(ec::surface_not_found,
                  "--select names surface " + std::to_string(id) + ", which is not there",
                  "Give its mesh with --mesh; \"tedit info MESH\" lists the surfaces");
  auto values = parse_parameters(options.pairs);
  if (!values)
    return fail(values.error());
  settings.selected = options.selected;
  for (auto& [name, value] : *values)
    if (const auto& text = std::get<std::string>(value); text.starts_with('@')) {
      auto content = attach_file(text.substr(1));
      if (!content)
        return fail(content.error());
      value = std::move(*content);
    }
  settings.values = std::move(*values);
  settings.limit = std::chrono::milliseconds(static_cast<std::int64_t>(1000 * options.limit_s));
  return settings;
}

int list_checks(session& s) {
  nlohmann::ordered_json json{{"checks", nlohmann::ordered_json::array()}};
  std::string text;
  for (const auto& row : ops::conformance_checks()) {
    json["checks"].push_back({{"check", row.check}, {"rule", row.rule}});
    text += row.check + std::string(24 - std::min<std::size_t>(22, row.check.size()), ' ') +
            row.rule + "\n";
  }
  print_result(s, json, text);
  return 0;
}

int run_test(const test_options& options, session& s) {
  if (options.list)
    return list_checks(s);
  auto settings = settings_of(options);
  if (!settings)
    return print_error(s, settings.error());
  settings->cancel = s.cancel;
  std::uint32_t operation = 0;
  const auto report = ops::test_plugin(*settings, [&](const ops::conformance_row& row) {
    if (!s.json && std::exchange(operation, row.operation) != row.operation)
      print_result(s, {}, "operation " + std::to_string(row.operation) + "\n");
    if (!s.json)
      print_result(s, {}, line_of(row));
  });
  if (s.cancel.cancelled())
    return print_error(s, {ec::cancelled, "the test was interrupted", {}, {}});
  nlohmann::ordered_json json{{"plugin", report.plugin},
                              {"file", settings->file.string()},
                              {"ok", report.ok()},
                              {"checks", nlohmann::ordered_json::array()}};
  std::size_t failed = 0;
  std::size_t passed = 0;
  for (const auto& row : report.rows) {
    json["checks"].push_back(to_json(row));
    failed += row.outcome == ops::verdict::fail;
    passed += row.outcome == ops::verdict::pass;
  }
  const auto not_run = report.rows.size() - failed - passed;
  print_result(s, json,
               std::to_string(passed) + " passed, " + std::to_string(failed) + " failed, " +
                 std::to_string(not_run) + " not run: " + report.plugin +
                 (report.ok() ? " keeps the rules\n" : " does not keep the rules\n"));
  return report.ok() ? 0 : 1;
}

void add_test(CLI::App& plugin, action& chosen) {
  auto options = std::make_shared<test_options>();
  auto* command = plugin.add_subcommand(
    "test", "Run the conformance kit: every rule that a plugin must keep, as a check");
  auto* file = command->add_option("file", options->file, "The plugin (.so)");
  command->add_option("--mesh", options->mesh, "Also on this part (a Gmsh file)");
  command->add_option("--length-unit", options->length_unit, "Unit of the part's coordinates")
    ->capture_default_str();
  command
    ->add_option("--select", options->selected,
                 "Surfaces of the part that the operation accepts, separated by commas")
    ->delimiter(',');
  command->add_option(
    "--set", options->pairs,
    "A parameter as NAME=VALUE, the content of a file as NAME=@PATH; may be repeated");
  command->add_option("--limit", options->limit_s, "Seconds for one call of the plugin")
    ->capture_default_str()
    ->check(number_in({0.1, 3600, "s"}));
  command
    ->add_option("--check", options->checks,
                 "Only these checks, separated by commas, and what they rest on")
    ->delimiter(',');
  command->add_option("--repeat", options->repeat, "Run each so often, for faults that come and go")
    ->check(CLI::Range(1U, 1000000U))
    ->capture_default_str();
  auto* list = command->add_flag("--list", options->list, "Only list the checks");
  file->excludes(list);
  command->callback([options, &chosen] {
    if (options->file.empty() && !options->list)
      throw CLI::RequiredError("file");
    chosen = [options](session& s) { return run_test(*options, s); };
  });
}

struct new_options {
  std::string name;
  std::string folder = ".";
};

int run_new(const new_options& options, session& s) {
  const auto made = make_plugin_folder(options.name, options.folder);
  if (!made)
    return print_error(s, made.error());
  std::string text = "made " + made->folder.string() + "\n";
  for (const auto& file : made->files)
    text += "  " + file + "\n";
  text += "build and test it:\n  cd " + made->folder.string() +
          "\n  cmake -B build && cmake --build build && ctest --test-dir build\n";
  print_result(s, {{"folder", made->folder.string()}, {"files", made->files}}, text);
  return 0;
}

void add_new(CLI::App& plugin, action& chosen) {
  auto options = std::make_shared<new_options>();
  auto* command = plugin.add_subcommand(
    "new", "Make a folder with an operation that works, its test and its build file");
  command->add_option("name", options->name, "Its id: snake_case, for example offset_surface")
    ->required();
  command->add_option("--dir", options->folder, "Make the folder in here")->capture_default_str();
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_new(*options, s); }; });
}

}  // namespace

void add_plugin(CLI::App& app, action& chosen) {
  auto* command = app.add_subcommand("plugin", "Make and test plugins with editing operations");
  command->require_subcommand(1);
  command->fallthrough();
  add_new(*command, chosen);
  add_test(*command, chosen);
}

}  // namespace tedit::cli
