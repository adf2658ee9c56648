// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "actors/node/server.hpp"
#include "base/random_token.hpp"
#include "base/stopwatch.hpp"
#include "cli/logging.hpp"
#include "cli/recipe_runner.hpp"
#include "cli/server_access.hpp"
#include "cli/token.hpp"

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
};

/// A server inside this program, with worker processes of its own (plugins may crash) and a folder
/// for its documents that goes with it.
class embedded_server {
public:
  embedded_server() = default;
  embedded_server(const embedded_server&) = delete;
  embedded_server& operator=(const embedded_server&) = delete;
  ~embedded_server() {
    server_.reset();
    std::error_code ignored;
    if (!folder_.empty())
      std::filesystem::remove_all(folder_, ignored);
  }

  expected<client::connect_options> start() {
    std::error_code code;
    auto name = (std::filesystem::temp_directory_path(code) / "tedit-run-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      return fail(ec::io_error,
                  "cannot make a folder in " + std::filesystem::temp_directory_path(code).string(),
                  "Set TMPDIR to a folder that can be written");
    folder_ = name;
    auto token = make_token();
    if (!token)
      return fail(token.error());
    server_options options;
    options.documents = folder_;
    options.token = *token;
    auto started = server::start(options);
    if (!started)
      return fail(started.error());
    server_ = std::move(*started);
    client::connect_options how;
    how.url = server_->url();
    how.token = *token;
    return how;
  }

private:
  std::filesystem::path folder_;
  std::unique_ptr<server> server_;
};

std::string describe(const recipe& steps, const recipe_runner& runner, double ms) {
  std::string text = steps.name + "\n\n" + runner.table() + "\n" + runner.details() + "\n";
  for (const auto& file : runner.files())
    text += "  wrote " + file + "\n";
  return text + "  " + pretty(ms / 1000, 3) + " s in all." +
         (steps.order == 1 ? " Fields of linear tets are previews: they understate bending.\n"
                           : " Fields of quadratic tets.\n");
}

/// The mesh that is imported before the first step, if the recipe has none of its own. Errors:
/// `bad_input`.
expected<std::optional<import_step>> mesh_for(const recipe& steps, const run_options& options) {
  const bool imports = std::ranges::any_of(
    steps.steps, [](const auto& one) { return std::holds_alternative<import_step>(one); });
  if (imports && !options.mesh.empty())
    return fail(ec::bad_input, "the recipe imports a mesh of its own", "Leave --mesh out");
  if (!imports && options.mesh.empty())
    return fail(ec::bad_input, "the recipe imports no mesh",
                "Give the part with --mesh PART.msh, or begin the recipe with an import step");
  return imports ? std::nullopt : std::optional(import_step{options.mesh, options.length_unit});
}

/// Reads the recipe with what it needs to be carried out without a window.
expected<recipe> read_for(const run_options& options, std::optional<import_step>& mesh) {
  auto steps = client::read_recipe(options.recipe);
  if (!steps)
    return steps;
  const auto wanted = mesh_for(*steps, options);
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

int run_recipe(const run_options& options, session& s) {
  start_logging("warn");
  const stopwatch clock;
  std::optional<import_step> mesh;
  auto steps = read_for(options, mesh);
  if (!steps)
    return print_error(s, steps.error());
  embedded_server own;
  auto how = options.server.empty() ? own.start() : reach_server(options.server, options.access);
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
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_recipe(*options, s); }; });
}

}  // namespace tedit::cli
