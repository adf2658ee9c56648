// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "base/logging/logging.hpp"
#include "base/stopwatch.hpp"
#include "cli/embedded_server.hpp"
#include "cli/family_run.hpp"
#include "cli/recipe_runner.hpp"
#include "cli/server_access.hpp"

namespace tedit::cli {

namespace {

struct run_options {
  std::string recipe;
  std::string mesh;
  std::string length_unit = "mm";
  std::string out = "out";
  std::string device;
  std::string server;
  server_access access;
  std::string table;
  unsigned jobs = 0;
  std::string report;
};

std::string describe(const recipe& steps, const recipe_runner& runner, double ms) {
  std::string text = steps.name + "\n\n" + runner.table() + "\n" + runner.details() + "\n";
  for (const auto& file : runner.files())
    text += "  wrote " + file + "\n";
  return text + "  " + pretty(ms / 1000, 3) + " s in all." +
         (steps.order == 1 ? " Fields of linear tets are previews: they understate bending.\n"
                           : " Fields of quadratic tets.\n");
}

}  // namespace

expected<std::optional<import_step>> mesh_for(const recipe& steps, const std::string& mesh,
                                              const std::string& length_unit) {
  const bool imports = std::ranges::any_of(
    steps.steps, [](const auto& one) { return std::holds_alternative<import_step>(one); });
  if (imports && !mesh.empty())
    return fail(ec::bad_input, "the recipe imports a mesh of its own", "Leave --mesh out");
  if (!imports && mesh.empty())
    return fail(ec::bad_input, "the recipe imports no mesh",
                "Give the part with --mesh PART.msh, or begin the recipe with an import step");
  return imports ? std::nullopt : std::optional(import_step{mesh, length_unit});
}

namespace {

/// Reads the recipe with what it needs to be carried out without a window.
expected<recipe> read_for(const run_options& options, std::optional<import_step>& mesh) {
  auto steps = client::read_recipe(options.recipe);
  if (!steps)
    return steps;
  const auto wanted = mesh_for(*steps, options.mesh, options.length_unit);
  if (!wanted)
    return fail(wanted.error());
  mesh = *wanted;
  if (auto ok = recipe_runner::check(*steps); !ok)
    return fail(ok.error());
  if (!options.device.empty())
    steps->device = options.device;
  return steps;
}

void say_passed_over(const session& s, std::size_t count) {
  if (count > 0)
    notice(s, "note: passed over " + std::to_string(count) +
                (count == 1 ? " step that" : " steps that") +
                " only the window carries out (tedit-qt --script)");
}

/// Each row of a table is a part of its own.
int run_table(const run_options& options, session& s) {
  family_options wanted;
  wanted.recipe = options.recipe;
  wanted.table = options.table;
  wanted.mesh = options.mesh;
  wanted.length_unit = options.length_unit;
  wanted.out = options.out;
  wanted.device = options.device;
  wanted.report = options.report;
  wanted.jobs = options.jobs;
  const auto reach = [&](unsigned workers, embedded_server& own) {
    return options.server.empty() ? own.start(workers)
                                  : reach_server(options.server, options.access);
  };
  wanted.remote = !options.server.empty();
  return run_family(wanted, reach, s);
}

int run_recipe(const run_options& options, session& s) {
  logging::start("warn");
  if (!options.table.empty())
    return run_table(options, s);
  if (!options.report.empty() || options.jobs > 0)
    return print_error(s, {ec::usage,
                           "--report and --jobs are for a table of parts",
                           "Name it with --table FILE.csv, or leave them out",
                           {}});
  const stopwatch clock;
  std::optional<import_step> mesh;
  auto steps = read_for(options, mesh);
  if (!steps)
    return print_error(s, steps.error());
  embedded_server own;
  auto how = options.server.empty() ? own.start(1) : reach_server(options.server, options.access);
  if (!how)
    return print_error(s, how.error());
  how->client_name = "tedit run " TEDIT_VERSION;
  const auto failures = std::make_shared<failed_solves>();
  client::events handlers;
  handlers.on_solve_status = [failures](const client::solve_status& status) {
    if (status.phase == client::solve_phase::failed)
      failures->add(status.version_id);
  };
  auto connected = client::client::connect(*how, handlers);
  if (!connected)
    return print_error(s, connected.error());
  recipe_runner runner(*steps, s, **connected, failures, options.out);
  if (auto done = runner.run(mesh); !done)
    return print_error(s, done.error());
  say_passed_over(s, runner.passed_over());
  const nlohmann::ordered_json json{{"name", steps->name},
                                    {"server", how->url},
                                    {"steps", runner.report()},
                                    {"files", runner.files()},
                                    {"passed_over", runner.passed_over()},
                                    {"total_ms", clock.milliseconds()}};
  print_result(s, json, describe(*steps, runner, clock.milliseconds()));
  return 0;
}

void add_table_options(CLI::App& command, run_options& options) {
  command.add_option("--table", options.table,
                     "A row is a part: its cells go into the recipe's {{column}} (CSV, "
                     "docs/recipes.md)");
  command
    .add_option(
      "--jobs", options.jobs,
      "Rows of the table at once; else as many as there are cores, or workers of --server")
    ->check(CLI::Range(1U, most_family_jobs));
  command.add_option("--report", options.report,
                     "Report of all rows with pictures: one file, .html or .pdf");
  command.footer(
    "example:\n"
    "  tedit run plate.json --table customers.csv --report customers.html --out parts\n"
    "With --table the exit status is 1 where a row failed; the others are carried out all the "
    "same.");
}

}  // namespace

void add_run(CLI::App& app, action& chosen) {
  auto options = std::make_shared<run_options>();
  auto* command = app.add_subcommand("run", "Carry out a recipe: import, edits, solves, exports");
  command->add_option("recipe", options->recipe, "The recipe (JSON, see docs/recipes.md)")
    ->required();
  command->add_option("--mesh", options->mesh,
                      "The part (Gmsh mesh) for a recipe that imports none, as a recorded one");
  command->add_option("--length-unit", options->length_unit, "Unit of that mesh's coordinates")
    ->capture_default_str();
  command->add_option("--out", options->out, "Folder for exported files")->capture_default_str();
  command->add_option("--device", options->device, "Device instead of the recipe's");
  command->add_option(
    "--server", options->server,
    "Work on this server (ws[s]://HOST:PORT/v1) instead of one inside this program");
  add_access_options(*command, options->access);
  add_table_options(*command, *options);
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_recipe(*options, s); }; });
}

}  // namespace tedit::cli
