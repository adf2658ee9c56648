// SPDX-License-Identifier: AGPL-3.0-or-later
// round_sweep MESH [close|open] [--every N] [--verbose]: rounds the edges between every pair (or
// every N-th one) of neighbouring flat and round surfaces of a mesh, each alone on the original
// mesh, with 0.5, 1 and 2 times the edge length there. Times are CPU time, the mesher's too. Prints
// a line for each edit with --verbose, and for each that broke a promise; then a summary. Ends with
// status 1 when an invariant broke.
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <map>
#include <numbers>
#include <set>

#include "cli/command.hpp"
#include "edit/make_edit.hpp"
#include "mesh/features/rims.hpp"
#include "mesh/io/import.hpp"
#include "mesh/quality.hpp"
#include "ops/shapes/rounding/round_chains.hpp"

namespace {

using namespace tedit;

struct tally {
  int tried = 0;
  int done = 0;
  int faults = 0;
  int below_floor = 0;  ///< Worst q after < min(.15, before).
  std::vector<double> ms;
  std::vector<double> added;
  std::vector<double> worst;
  double radius_error = 0;  ///< Of r, at the vertices of the new surfaces.
  int volumes = 0;          ///< Edits with a formula for their volume.
  double volume_error = 0;  ///< Of the formula's value.
  std::map<std::string, int> reasons;
};

/// Pairs of surfaces with an edge of the kind between them.
std::set<std::pair<surface_id, surface_id>> pairs_of(const mesh_version& mesh, double side) {
  std::set<std::pair<surface_id, surface_id>> result;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      for (int i = 0; i < 3; ++i) {
        const auto a = mesh.facet(f).surface;
        const auto b = mesh.facet(facet_across(mesh, f, i)).surface;
        if (a < b && side * (material_angle(mesh, f, i) - std::numbers::pi) > 0.09)
          result.emplace(a, b);
      }
  return result;
}

/// CPU time of this process and of its children that ended, ms.
double cpu_ms() {
  double sum = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage use{};
    getrusage(who, &use);
    for (const auto& t : {use.ru_utime, use.ru_stime})
      sum += 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  }
  return sum;
}

double figure_of(const edit_report& report, const std::string& id) {
  for (const auto& f : report.figures)
    if (f.id == id)
      return f.value;
  return 0;
}

/// Largest distance of a vertex of the new surfaces from the rolling ball, over r.
double radius_error(const mesh_version& before, const mesh_version& after,
                    const ops::round_plan& plan, double radius) {
  double worst = 0;
  for (const auto& row : after.surfaces()) {
    if (before.find_surface(row.id))
      continue;
    for (const auto f : facets_of(after, std::vector{row.id}))
      for (const auto v : after.facet(f).v) {
        double least = 1e300;
        const vec3 p = after.position(v);
        for (const auto& chain : plan.chains) {
          const ops::rolling_ball ball(plan.shapes.at(chain.a), plan.shapes.at(chain.b), radius,
                                       plan.side);
          auto nearest = chain.path.front();
          for (const auto u : chain.path)
            if (norm(before.position(u) - p) < norm(before.position(nearest) - p))
              nearest = u;
          if (const auto c = ball.centre(before.position(nearest)))
            if (const auto d = ball.distance(p, *c))
              least = std::min(least, std::abs(*d) / radius);
        }
        worst = std::max(worst, least);
      }
  }
  return worst;
}

/// The change of volume of one straight edge between two planes that ends at planes across it, m^3.
std::optional<double> formula(const mesh_version& mesh, const ops::round_plan& plan, double radius,
                              int segments) {
  if (plan.chains.size() != 1 || plan.chains.front().closed)
    return std::nullopt;
  const auto& chain = plan.chains.front();
  const auto& a = plan.shapes.at(chain.a);
  const auto& b = plan.shapes.at(chain.b);
  if (!a.flat() || !b.flat())
    return std::nullopt;
  const vec3 edge = mesh.position(chain.path.back()) - mesh.position(chain.path.front());
  for (const auto& corner : plan.corners)
    for (const auto s : corner.fan.sectors)
      if (s != chain.a && s != chain.b &&
          (!plan.shapes.at(s).flat() ||
           norm(cross(plan.shapes.at(s).shape.axis, normalized(edge))) > 1e-6))
        return std::nullopt;
  const double bend =
    std::atan2(norm(cross(a.shape.axis, b.shape.axis)), dot(a.shape.axis, b.shape.axis));
  const double section =
    radius * radius * (std::tan(0.5 * bend) - 0.5 * segments * std::sin(bend / segments));
  return plan.side * section * norm(edge);
}

void try_pair(const ops::catalogue& plugins, const version_ptr& base, double base_volume,
              const ops::round_plan& plan, std::pair<surface_id, surface_id> pair, double factor,
              bool verbose, tally& sum) {
  const double radius = factor * plan.chains.front().mean_edge;
  edit_request request{plan.side > 0 ? "close" : "open", {pair.first, pair.second}, {}};
  request.parameters["radius"] = radius;
  ++sum.tried;
  const auto name = "surfaces " + std::to_string(pair.first) + " and " +
                    std::to_string(pair.second) + ", r " + cli::pretty(1e3 * radius, 3) + " mm";
  const double start = cpu_ms();
  const auto before_id = base->id();
  const auto outcome = make_edit(plugins, base, request, {}, {}, {});
  const double ms = cpu_ms() - start;
  if (base->id() != before_id)
    ++sum.faults;
  if (!outcome) {
    const auto& e = outcome.error();
    ++sum.reasons[std::string(code_name(e.code))];
    if (verbose || e.code == ec::postcondition_failed)
      std::cout << "  " << code_name(e.code) << " " << name << ": " << e.message << '\n';
    return;
  }
  ++sum.done;
  const auto& report = outcome->report;
  sum.ms.push_back(ms);
  sum.added.push_back(static_cast<double>(report.tets_added));
  const auto ratios = report.ratios.value_or(touched_ratios{1, 1, 1});  // A rounding makes tets.
  sum.worst.push_back(ratios.min_after);
  sum.below_floor += ratios.min_after < std::min(0.15, ratios.min_before) * (1 - 1e-9);
  const double error = radius_error(*base, *outcome->version, plan, radius);
  sum.radius_error = std::max(sum.radius_error, error);
  double off = -1;
  if (const auto volume =
        formula(*base, plan, radius, static_cast<int>(figure_of(report, "segments")))) {
    off = std::abs(total_volume(*outcome->version) - base_volume - *volume) / std::abs(*volume);
    ++sum.volumes;
    sum.volume_error = std::max(sum.volume_error, off);
  }
  if (verbose)
    std::cout << "  done " << name << ": q " << cli::pretty(ratios.min_before, 3) << " -> "
              << cli::pretty(ratios.min_after, 3) << ", radius off " << cli::pretty(error, 2)
              << ", volume off " << cli::pretty(off, 2) << ", " << cli::pretty(ms, 3) << " ms\n";
  if (const auto check = check_version(*outcome->version);
      !check.ok() && check_version(*base).total < check.total) {
    ++sum.faults;
    std::cout << "  FAULT " << name << ": " << to_error(check).message << '\n';
  }
}

double percentile(std::vector<double> values, double share) {
  if (values.empty())
    return 0;
  std::ranges::sort(values);
  return values[std::min(values.size() - 1,
                         static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

}  // namespace

int main(int argc, char** argv) try {
  std::set<std::string> options(argv + 1, argv + argc);
  if (argc < 2) {
    std::cerr << "usage: round_sweep MESH [close|open] [--every N] [--verbose]\n";
    return 2;
  }
  std::size_t every = 1;
  for (int i = 2; i + 1 < argc; ++i)
    if (std::string(argv[i]) == "--every")
      every = std::max(1ul, std::stoul(argv[i + 1]));
  const auto imported = import_mesh(std::filesystem::path(argv[1]), "mm");
  if (!imported) {
    std::cerr << render(imported.error()) << '\n';
    return 65;
  }
  const auto& base = imported->version;
  const auto plugins = ops::load_default_catalogue();
  const double volume = total_volume(*base);
  int faults = 0;
  for (const std::string operation : {"close", "open"}) {
    if (options.contains(operation == "close" ? "open" : "close"))
      continue;
    const double side = operation == "close" ? 1 : -1;
    tally sum;
    int pairs = 0;
    std::size_t index = 0;
    for (const auto& pair : pairs_of(*base, side)) {
      if (index++ % every != 0)
        continue;
      const auto plan = ops::find_chains(*base, {pair.first, pair.second}, side);
      ++pairs;
      if (!plan) {
        ++sum.reasons["not found: " + std::string(code_name(plan.error().code))];
        if (options.contains("--verbose"))
          std::cout << "  skipped " << pair.first << " " << pair.second << ": "
                    << plan.error().message << '\n';
        continue;
      }
      for (const double factor : {0.5, 1.0, 2.0})
        try_pair(plugins, base, volume, *plan, pair, factor, options.contains("--verbose"), sum);
    }
    faults += sum.faults;
    std::cout << std::filesystem::path(argv[1]).filename().string() << " " << operation
              << ": pairs " << pairs << ", tried " << sum.tried << ", done " << sum.done
              << ", faults " << sum.faults << ", below min(.15, before) " << sum.below_floor
              << "; tets added median " << percentile(sum.added, 0.5) << "; worst q min "
              << cli::pretty(percentile(sum.worst, 0), 3) << " median "
              << cli::pretty(percentile(sum.worst, 0.5), 3) << "; radius error "
              << cli::pretty(sum.radius_error, 2) << "; volume error "
              << cli::pretty(sum.volume_error, 2) << " of " << sum.volumes << "; CPU ms median "
              << cli::pretty(percentile(sum.ms, 0.5), 3) << " max "
              << cli::pretty(percentile(sum.ms, 1), 3);
    for (const auto& [reason, count] : sum.reasons)
      std::cout << "; " << reason << " " << count;
    std::cout << '\n';
  }
  return faults > 0 ? 1 : 0;
} catch (const std::exception& why) {
  std::fprintf(stderr, "%s\n", why.what());
  return 1;
}
