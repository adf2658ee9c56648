// SPDX-License-Identifier: AGPL-3.0-or-later
#include "edit/adapt.hpp"

#include <memory>
#include <numeric>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/stopwatch.hpp"
#include "cli/command.hpp"
#include "cli/number_option.hpp"
#include "cli/part_input.hpp"
#include "cli/solver_options.hpp"
#include "fem/load_cases.hpp"
#include "mesh/io/formats.hpp"

namespace tedit::cli {

namespace {

/// Where the limit lets no more tets than this come out, by those there are, a solution is not
/// worth it.
constexpr double worth_a_round = 1.02;

struct adapt_options {
  part_input part;
  std::vector<std::string> load_cases;
  double error_percent = 5;
  std::size_t most_tets = 1000000;
  int rounds = 6;
  std::string output;
  solver_options solver;
};

/// One solution, and what is known after it.
struct adapt_round {
  std::uint32_t tets = 0;
  double error = 0;  ///< The largest of the load cases.
  double max_von_mises_pa = 0;
  double ms = 0;  ///< Solution and refinement.
};

struct adapt_outcome {
  version_ptr mesh;
  std::vector<adapt_round> rounds;
  double volume_change = 0;  ///< m^3.
  std::string why;           ///< It ended: "reached", "rounds" or "tets".
};

nlohmann::ordered_json to_json(const adapt_outcome& outcome, const adapt_options& options) {
  nlohmann::ordered_json json{{"wanted_error", options.error_percent / 100},
                              {"relative_error_before", outcome.rounds.front().error},
                              {"relative_error_after", outcome.rounds.back().error},
                              {"reached", outcome.why == "reached"},
                              {"ended_by", outcome.why},
                              {"tets_before", outcome.rounds.front().tets},
                              {"tets_after", outcome.rounds.back().tets},
                              {"volume_change_m3", outcome.volume_change},
                              {"rounds", nlohmann::ordered_json::array()}};
  for (const auto& r : outcome.rounds)
    json["rounds"].push_back({{"tets", r.tets},
                              {"relative_error_estimate", r.error},
                              {"max_von_mises_pa", r.max_von_mises_pa},
                              {"ms", r.ms}});
  return json;
}

std::string describe(const adapt_outcome& outcome, const adapt_options& options) {
  std::vector<std::vector<std::string>> rows{
    {"round", "tets", "error estimate %", "max von Mises MPa", "s"}};
  for (std::size_t i = 0; i < outcome.rounds.size(); ++i) {
    const auto& r = outcome.rounds[i];
    rows.push_back({std::to_string(i), std::to_string(r.tets), pretty(100 * r.error, 3),
                    pretty(1e-6 * r.max_von_mises_pa), pretty(1e-3 * r.ms, 3)});
  }
  const auto wanted = pretty(options.error_percent, 3) + " %";
  const auto said = outcome.why == "reached"  ? "the error is at most " + wanted
                    : outcome.why == "rounds" ? "not " + wanted + " after so many rounds (--rounds)"
                                              : "not " + wanted + " within the limit (--tets)";
  return format_table(rows) + "  " + said + "\n";
}

fem::solve_settings settings_of(const adapt_options& options) {
  fem::solve_settings settings;
  settings.tolerance = options.solver.tolerance;
  return settings;
}

std::vector<case_error> errors_of(const fem::solved_cases& solved) {
  std::vector<case_error> result;
  for (const auto& one : solved.cases)
    result.push_back(
      {one.element_error,
       2 * one.strain_energy_j +
         std::transform_reduce(one.element_error.begin(), one.element_error.end(), 0.0, std::plus{},
                               [](float e) { return static_cast<double>(e) * e; })});
  return result;
}

adapt_round round_of(const mesh_version& mesh, const fem::solved_cases& solved) {
  adapt_round result{mesh.tet_count()};
  for (const auto& one : solved.cases) {
    result.error = std::max(result.error, one.relative_error);
    result.max_von_mises_pa = std::max(result.max_von_mises_pa, one.max_von_mises_pa);
  }
  return result;
}

/// Solves and refines in turn. Errors: those of the solver; `finish_edit`'s in the first round.
expected<adapt_outcome> adapt(version_ptr mesh, const std::vector<fem::load_case>& loads,
                              const adapt_options& options, fem::backend& device, session& s) {
  adapt_outcome outcome{std::move(mesh), {}, 0, {}};
  for (int round = 0;; ++round) {
    stopwatch clock;
    auto set = fem::make_cases(*outcome.mesh, loads, options.solver.order);
    if (!set)
      return fail(set.error());
    const auto solved = fem::solve_cases(*set, device, settings_of(options), make_execution(s));
    if (!solved)
      return fail(solved.error());
    outcome.rounds.push_back(round_of(*outcome.mesh, *solved));
    auto& now = outcome.rounds.back();
    now.ms = clock.milliseconds();
    outcome.why = now.error <= options.error_percent / 100 ? "reached"
                  : round == options.rounds                ? "rounds"
                                                           : "";
    if (!outcome.why.empty())
      return outcome;
    const auto finer =
      refine_by_error(outcome.mesh, set->problem, errors_of(*solved),
                      {options.error_percent / 100, options.most_tets}, make_execution(s));
    now.ms = clock.milliseconds();
    if (!finer && finer.error().code != ec::invalid_parameter)
      return fail(finer.error());
    if (!finer || finer->version->tet_count() < worth_a_round * now.tets) {
      outcome.why = "tets";
      return outcome;
    }
    outcome.mesh = finer->version;
    outcome.volume_change += finer->volume_change;
  }
}

int run_adapt(const adapt_options& options, session& s) {
  const auto format = output_format(options.output);
  if (!options.output.empty() && !format)
    return print_error(s, format.error());
  const auto part = read_input(options.part, s);
  if (!part)
    return print_error(s, part.error());
  const auto loads = cases_of(options.part, *part, options.load_cases);
  if (!loads)
    return print_error(s, loads.error());
  const auto device = fem::open_backend(options.solver.device);
  if (!device)
    return print_error(s, device.error());
  const auto outcome = adapt(part->mesh.version, *loads, options, **device, s);
  if (!outcome)
    return print_error(s, outcome.error());
  if (!options.output.empty())
    if (const auto written = write_as((*format)->name, options.output, *outcome->mesh,
                                      {.length_unit = options.part.length_unit});
        !written)
      return print_error(s, written.error());
  print_result(s, to_json(*outcome, options), describe(*outcome, options));
  return 0;
}

}  // namespace

void add_adapt(CLI::App& app, action& chosen) {
  auto options = std::make_shared<adapt_options>();
  auto* command =
    app.add_subcommand("adapt", "Refine a mesh where the estimated error is, until it is small");
  add_part_options(*command, options->part, "Unit of coordinates in both files");
  command
    ->add_option("--load-case", options->load_cases,
                 std::string(load_case_help) + ". All are to be that exact")
    ->allow_extra_args(false);
  command
    ->add_option("--error", options->error_percent,
                 "Wanted error of the stress in the energy norm, as it is estimated, %")
    ->check(number_in({0.1, 50, {}}))
    ->capture_default_str();
  command->add_option("--tets", options->most_tets, "At most so many tets")
    ->check(CLI::Range(std::size_t{1000}, std::size_t{20000000}))
    ->capture_default_str();
  command->add_option("--rounds", options->rounds, "At most so many refinements")
    ->check(CLI::Range(1, 20))
    ->capture_default_str();
  command->add_option("-o,--output", options->output,
                      "Write the new mesh: " + written_formats_text());
  add_solver_options(*command, options->solver);
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_adapt(*options, s); }; });
}

}  // namespace tedit::cli
