// SPDX-License-Identifier: AGPL-3.0-or-later
// feature_sweep PART_FOLDER MESH [MODE]: every feature that PART_FOLDER/features.json lists, one by
// one on the original mesh, and checks of the whole version after each. Without a mode: holes are
// filled (walls given), fins taken off (one face given), plates and largest planes lowered and
// raised by 20 % of the wall; one row of a table for each. Modes:
//   --sequence           all holes one after the other, on one another's result: one row
//   --alone OPERATION    every surface of the mesh alone, by default values: a summary
//   --layers             plates and planes eroded by one layer of tets: a summary
//   --solve              holes, each solved with the part's load case: a summary
//   --cost OPERATION IDS [NAME=VALUE]...   one edit five times: a row of its cheapest run, by stage
//   --paper OPERATION IDS [NAME=VALUE]...  one edit: rows as in the paper's Table 1
// Ends with status 1 when an invariant broke.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <sstream>

#include "bench/sweep.hpp"
#include "cli/parameters.hpp"
#include "fem/solver.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"

namespace {

using namespace tedit;
using namespace tedit::bench;

/// 20 % of the wall below a surface, m, at most 20 % of the thickness that the list knows.
double slab_depth(const mesh_version& mesh, surface_id id, double listed) {
  return 0.2 * std::min(wall_thickness(mesh, id), listed > 0 ? listed : 1e300);
}

std::vector<planned_feature> all_features(const part_features& part, const mesh_version& mesh) {
  auto result = part.holes;
  result.insert(result.end(), part.fins.begin(), part.fins.end());
  for (const auto* operation : {"erode", "thicken"})
    for (const auto& [id, thickness] : part.planes) {
      if (facets_of(mesh, std::vector{id}).empty())
        continue;
      planned_feature plane{operation, {id}, {}, "plane", {}};
      const double depth = slab_depth(mesh, id, thickness);
      plane.parameters["depth"] = depth;
      plane.exact_volume = (plane.operation == "erode" ? -depth : depth) * area_of(mesh, id);
      result.push_back(std::move(plane));
    }
  return result;
}

int run_table(sweep& s, const part_features& part) {
  for (const auto& feature : all_features(part, *s.base()))
    std::cout << row_of(feature, s.attempt(s.base(), feature)) << '\n' << std::flush;
  return s.faults();
}

int run_sequence(sweep& s, const part_features& part) {
  auto mesh = s.base();
  tally sum;
  for (const auto& hole : part.holes) {
    // Steps of one hole are listed each: the fill of one completes its selection by the others.
    if (std::ranges::none_of(hole.surfaces,
                             [&](surface_id id) { return mesh->find_surface(id); })) {
      ++sum.with_another;
      continue;
    }
    const auto tried = s.attempt(mesh, hole);
    sum.add(tried);
    if (tried.outcome)
      mesh = tried.outcome->version;
  }
  std::cout << sum.text("all " + std::to_string(part.holes.size()) + " holes in sequence") << '\n';
  return s.faults();
}

int run_alone(sweep& s, const std::string& operation) {
  tally sum;
  for (const auto& row : s.base()->surfaces())
    sum.add(s.attempt(s.base(), {operation, {row.id}, {}, "surface", {}}));
  std::cout << sum.text(operation + ", every surface alone") << '\n';
  return s.faults();
}

int run_layers(sweep& s, const part_features& part) {
  tally sum;
  for (const auto& [id, thickness] : part.planes)
    sum.add(s.attempt(s.base(), {"erode", {id}, {}, "plane", {}}));
  std::cout << sum.text("erode, one layer") << '\n';
  return s.faults();
}

/// Loads that lose their surface move with the edit, so that each result can be solved.
int run_solves(sweep& s, const part_features& part, const fem::load_case& loads) {
  s.loads = {loads};
  const auto device = fem::open_backend("cpu");
  int solved = 0;
  int unsolved = 0;
  double residual = 0;
  double balance = 0;
  for (const auto& hole : part.holes) {
    const auto tried = s.attempt(s.base(), hole);
    if (!tried.outcome)
      continue;
    const auto problem =
      fem::make_problem(*tried.outcome->version, tried.outcome->load_cases.front());
    const auto result = problem ? fem::solve(*problem, **device, {}, {})
                                : expected<fem::solution>(tl::unexpected(problem.error()));
    if (!result) {
      ++unsolved;
      std::cout << "  NOT SOLVED after " << name_of(hole) << ": " << render(result.error()) << '\n';
      continue;
    }
    ++solved;
    residual = std::max(residual, result->true_relative_residual);
    balance =
      std::max(balance, norm(result->reaction_n + result->applied_n) / norm(result->applied_n));
  }
  std::cout << "solved " << solved << ", residual <= " << cli::pretty(residual, 2)
            << ", balance <= " << cli::pretty(balance, 2) << '\n';
  return s.faults() + unsolved;
}

/// "OPERATION 1,2 NAME=VALUE...".
planned_feature feature_of(const std::vector<std::string>& words) {
  planned_feature feature{words.at(0), {}, {}, "", {}};
  std::stringstream ids(words.at(1));
  for (std::string id; std::getline(ids, id, ',');)
    feature.surfaces.push_back(std::stoll(id));
  if (auto given = cli::parse_parameters({words.begin() + 2, words.end()}))
    feature.parameters = *given;
  return feature;
}

int run_cost(sweep& s, const planned_feature& feature) {
  std::optional<attempt_result> best;
  for (int i = 0; i < 5; ++i) {
    auto tried = s.attempt(s.base(), feature);
    if (!tried.outcome) {
      std::cout << "refused: " << render(tried.refusal) << '\n';
      return 1;
    }
    if (!best || tried.cpu_ms < best->cpu_ms)
      best = std::move(tried);
  }
  const auto& r = best->outcome->report;
  const double rest = r.total_ms - r.operation_ms - r.improve_ms - r.check_ms;
  std::cout << "| " << feature.operation << " | " << s.base()->tet_count() << " | +" << r.tets_added
            << " -" << r.tets_removed;
  for (const double ms : {best->cpu_ms, r.operation_ms, r.improve_ms, r.check_ms, rest})
    std::cout << " | " << cli::pretty(ms, 3);
  std::cout << " |\n";
  return s.faults();
}

void print_paper_row(const std::string& what, const mesh_version& mesh) {
  std::vector<double> volumes;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t)) {
      const auto c = mesh.corners(t);
      volumes.push_back(signed_volume(c[0], c[1], c[2], c[3]));
    }
  const auto volume = summarize(volumes);
  const auto ratio = radius_ratios(mesh);
  std::cout << "| " << what;
  for (const double v : {volume.max, volume.min, volume.median})
    std::cout << " | " << cli::pretty(v, 2);
  for (const double q : {ratio.max, ratio.min, ratio.median})
    std::cout << " | " << cli::pretty(q / 3, 4);
  std::cout << " |\n";
}

int run_paper(sweep& s, const planned_feature& feature) {
  const auto tried = s.attempt(s.base(), feature);
  print_paper_row("before " + feature.operation, *s.base());
  if (tried.outcome)
    print_paper_row("after " + feature.operation, *tried.outcome->version);
  else
    std::cout << "refused: " << render(tried.refusal) << '\n';
  return s.faults();
}

int run(const std::filesystem::path& folder, const std::string& mesh, const std::string& mode,
        const std::vector<std::string>& rest) {
  const auto imported = import_mesh(std::filesystem::path(mesh), "mm");
  if (!imported) {
    std::cerr << render(imported.error()) << '\n';
    return 65;
  }
  sweep s(imported->version);
  const auto part = read_features(folder);
  if (mode == "--sequence")
    return run_sequence(s, part) > 0 ? 1 : 0;
  if (mode == "--alone")
    return run_alone(s, rest.empty() ? "fill_hole" : rest.front()) > 0 ? 1 : 0;
  if ((mode == "--cost" || mode == "--paper") && rest.size() >= 2)
    return (mode == "--cost" ? run_cost : run_paper)(s, feature_of(rest)) > 0 ? 1 : 0;
  if (mode == "--layers")
    return run_layers(s, part) > 0 ? 1 : 0;
  if (mode != "--solve")
    return run_table(s, part) > 0 ? 1 : 0;
  const auto loads = protocol::load_case_from_file(folder / "load_case.json");
  if (!loads) {
    std::cerr << render(loads.error()) << '\n';
    return 65;
  }
  return run_solves(s, part, *loads) > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 3) {
    std::cerr << "usage: feature_sweep PART_FOLDER MESH [--sequence | --alone OPERATION | --layers "
                 "| --solve | --cost OPERATION IDS | --paper OPERATION IDS]\n";
    return 2;
  }
  const std::vector<std::string> rest(argv + std::min(argc, 4), argv + argc);
  return run(argv[1], argv[2], argc > 3 ? argv[3] : "", rest);
} catch (const std::exception& why) {
  std::fprintf(stderr, "%s\n", why.what());
  return 1;
}
