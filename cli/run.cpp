// SPDX-License-Identifier: AGPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>

#include "base/stopwatch.hpp"
#include "cli/recipe_runner.hpp"

namespace tedit::cli {

namespace {

struct run_options {
  std::string recipe;
  std::string out = "out";
  std::string device;
};

int run_recipe(const run_options& options, session& s) {
  const stopwatch clock;
  auto steps = read_recipe(options.recipe);
  if (!steps)
    return print_error(s, steps.error());
  if (!options.device.empty())
    steps->device = options.device;
  recipe_runner runner(*steps, s, options.out);
  if (auto done = runner.run(); !done)
    return print_error(s, done.error());
  nlohmann::ordered_json json{{"name", steps->name},
                              {"steps", runner.report()},
                              {"files", runner.files()},
                              {"total_ms", clock.milliseconds()}};
  std::string text = steps->name + "\n\n" + runner.table() + "\n";
  for (const auto& file : runner.files())
    text += "  wrote " + file + "\n";
  text += "  " + pretty(clock.milliseconds() / 1000, 3) +
          " s in all. Fields of linear tets are previews: they understate bending.\n";
  print_result(s, json, text);
  return 0;
}

}  // namespace

void add_run(CLI::App& app, action& chosen) {
  auto options = std::make_shared<run_options>();
  auto* command = app.add_subcommand("run", "Carry out a recipe: import, edits, solves, exports");
  command->add_option("recipe", options->recipe, "The recipe (JSON, see docs/recipes.md)")
    ->required();
  command->add_option("--out", options->out, "Folder for exported files")->capture_default_str();
  command->add_option("--device", options->device, "Device instead of the recipe's");
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_recipe(*options, s); }; });
}

}  // namespace tedit::cli
