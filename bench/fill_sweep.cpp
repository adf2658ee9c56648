// SPDX-License-Identifier: AGPL-3.0-or-later
// fill_sweep PART_FOLDER MESH [--alone | --solve]: fills every hole that PART_FOLDER/features.json
// lists, one by one on the original mesh, given the walls alone, and with --solve solves the part's
// load case after each; with --alone, every surface of the mesh alone instead. Prints a line for
// each refusal or fault and a summary; ends with status 1 when an invariant broke.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>

#include <nlohmann/json.hpp>

#include "base/stopwatch.hpp"
#include "cli/command.hpp"
#include "cli/local_edit.hpp"
#include "fem/solver.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"

namespace {

using namespace tedit;

struct tally {
  int tried = 0;
  int filled = 0;
  int refused = 0;
  int faults = 0;
  int below_floor = 0;  ///< Worst q after < min(.15, before).
  std::vector<double> ms;
  std::vector<double> worst_after;
  double worst_volume_error = 0;
  double slowest_answer_ms = 0;
  std::map<std::string, int> reasons;
  std::vector<fem::load_case> loads;  ///< With --solve: carried over and solved after each fill.
  std::unique_ptr<fem::backend> device;
  int solved = 0;
  double worst_residual = 0;
  double worst_balance = 0;  ///< |reactions + loads| / |loads|.
};

void solve(const cli::edit_outcome& outcome, const std::string& name, tally& sum) {
  const auto& loads = outcome.load_cases.front();
  if (loads.loads.empty() || loads.constraints.empty()) {
    std::cout << "  no load or support is left after " << name << '\n';
    return;
  }
  const auto problem = fem::make_problem(*outcome.version, loads);
  const auto result = problem ? fem::solve(*problem, *sum.device, {}, {})
                              : expected<fem::solution>(tl::unexpected(problem.error()));
  if (!result) {
    ++sum.faults;
    std::cout << "  NOT SOLVED after " << name << ": " << render(result.error()) << '\n';
    return;
  }
  ++sum.solved;
  sum.worst_residual = std::max(sum.worst_residual, result->true_relative_residual);
  sum.worst_balance = std::max(
    sum.worst_balance, norm(result->reaction_n + result->applied_n) / norm(result->applied_n));
}

void try_selection(const ops::catalogue& plugins, const version_ptr& base, double base_volume,
                   const std::vector<surface_id>& surfaces, const std::string& name, bool verbose,
                   tally& sum) {
  ++sum.tried;
  const stopwatch clock;
  const auto before_id = base->id();
  const auto outcome = cli::apply_edit(plugins, base, {"fill_hole", surfaces, {}}, sum.loads, {});
  const double ms = clock.milliseconds();
  sum.slowest_answer_ms = std::max(sum.slowest_answer_ms, ms);
  if (base->id() != before_id)
    ++sum.faults;
  if (!outcome) {
    ++sum.refused;
    ++sum.reasons[std::string(code_name(outcome.error().code))];
    if (outcome.error().code == ec::postcondition_failed)
      std::cout << "  ROLLED BACK " << name << ": " << render(outcome.error()) << '\n';
    else if (verbose)
      std::cout << "  refused " << name << ": " << outcome.error().message << '\n';
    return;
  }
  ++sum.filled;
  sum.ms.push_back(ms);
  const auto& done = outcome->report;
  sum.worst_after.push_back(done.touched_min_after);
  if (done.touched_min_after < std::min(0.15, done.touched_min_before) * (1 - 1e-9))
    ++sum.below_floor;
  const double volume = total_volume(*outcome->version);
  const double error = std::abs(volume - base_volume - done.volume_change) / base_volume;
  sum.worst_volume_error = std::max(sum.worst_volume_error, error);
  if (const auto report = check_version(*outcome->version);
      !report.ok() && check_version(*base).total < report.total) {
    ++sum.faults;
    std::cout << "  FAULT " << name << ": " << to_error(report).message << '\n';
  }
  if (!outcome->load_cases.empty())
    solve(*outcome, name, sum);
}

double percentile(std::vector<double> values, double share) {
  if (values.empty())
    return 0;
  std::ranges::sort(values);
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * values.size()))];
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: fill_sweep PART_FOLDER MESH [--alone | --solve]\n";
    return 2;
  }
  const std::string mode = argc > 3 ? argv[3] : "";
  const bool alone = mode == "--alone";
  const auto imported = import_mesh(std::filesystem::path(argv[2]), "mm");
  if (!imported) {
    std::cerr << render(imported.error()) << '\n';
    return 65;
  }
  const auto plugins = ops::load_default_catalogue();
  const double volume = total_volume(*imported->version);
  tally sum;
  if (mode == "--solve") {
    auto loads = protocol::load_case_from_file(std::filesystem::path(argv[1]) / "load_case.json");
    if (!loads) {
      std::cerr << render(loads.error()) << '\n';
      return 65;
    }
    sum.loads = {*loads};
    sum.device = std::move(*fem::open_backend("cpu"));
  }
  if (alone) {
    for (const auto& row : imported->version->surfaces())
      try_selection(plugins, imported->version, volume, {row.id},
                    "surface " + std::to_string(row.id), false, sum);
  } else {
    std::ifstream in(std::filesystem::path(argv[1]) / "features.json");
    const auto features = nlohmann::json::parse(in);
    for (const auto& hole : features["holes"]) {
      const auto walls = hole["surfaces"].get<std::vector<surface_id>>();
      try_selection(plugins, imported->version, volume, walls,
                    hole["class"].get<std::string>() + " " + hole["surfaces"].dump(), true, sum);
    }
  }
  std::cout << std::filesystem::path(argv[2]).filename().string() << ": tried " << sum.tried
            << ", filled " << sum.filled << ", refused " << sum.refused << ", faults " << sum.faults
            << ", below floor " << sum.below_floor << "; ms median "
            << cli::pretty(percentile(sum.ms, 0.5), 3) << " max "
            << cli::pretty(percentile(sum.ms, 1), 3) << " (slowest answer "
            << cli::pretty(sum.slowest_answer_ms, 3) << "); worst q min "
            << cli::pretty(percentile(sum.worst_after, 0), 3) << " median "
            << cli::pretty(percentile(sum.worst_after, 0.5), 3) << "; volume error "
            << cli::pretty(sum.worst_volume_error, 2);
  if (sum.device)
    std::cout << "; solved " << sum.solved << ", residual <= " << cli::pretty(sum.worst_residual, 2)
              << ", balance <= " << cli::pretty(sum.worst_balance, 2);
  for (const auto& [reason, count] : sum.reasons)
    std::cout << "; " << reason << " " << count;
  std::cout << '\n';
  return sum.faults > 0 ? 1 : 0;
}
