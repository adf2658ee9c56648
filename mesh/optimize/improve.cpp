// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/optimize/improve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/optimize/local_moves.hpp"
#include "mesh/optimize/thorough.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

/// The region with its rings: the tets that may change.
std::unordered_set<tet_id> grow(const mesh_builder& mesh, const std::vector<tet_id>& region,
                                int rings) {
  std::unordered_set<tet_id> result;
  std::unordered_set<vertex_id> frontier;
  for (const auto t : region)
    if (t < mesh.tet_slots() && mesh.is_live_tet(t) && result.insert(t).second)
      frontier.insert(mesh.tet_at(t).v.begin(), mesh.tet_at(t).v.end());
  std::unordered_set<vertex_id> done;
  for (int ring = 0; ring < rings; ++ring) {
    std::unordered_set<vertex_id> next;
    for (const auto v : frontier) {
      if (!done.insert(v).second)
        continue;
      for (const auto t : mesh.star(v))
        if (result.insert(t).second)
          next.insert(mesh.tet_at(t).v.begin(), mesh.tet_at(t).v.end());
    }
    frontier = std::move(next);
  }
  return result;
}

double worst_of(const mesh_builder& mesh, const std::unordered_set<tet_id>& tets) {
  double worst = 1;
  for (const auto t : tets)
    if (mesh.is_live_tet(t))
      worst = std::min(worst, radius_ratio(mesh.corners(t)));
  return worst;
}

/// Tets of the set below a quality, worst first; ties by id, so that runs repeat.
std::vector<tet_id> bad_tets(const mesh_builder& mesh, const std::unordered_set<tet_id>& tets,
                             double below) {
  std::vector<std::pair<double, tet_id>> bad;
  for (const auto t : tets) {
    if (!mesh.is_live_tet(t))
      continue;
    const double q = radius_ratio(mesh.corners(t));
    if (q < below)
      bad.emplace_back(q, t);
  }
  std::ranges::sort(bad);
  std::vector<tet_id> result;
  for (const auto& [q, t] : bad)
    result.push_back(t);
  return result;
}

}  // namespace

expected<void> validate(const thorough_settings& settings) {
  const auto share = [](double x) { return x >= 0 && x <= 1; };
  if (!share(settings.target) || !share(settings.insert_below))
    return fail(ec::invalid_parameter, "the target quality must be between 0 and 1");
  if (!(settings.tolerance.absolute >= 0) || !share(settings.tolerance.relative) ||
      !std::isfinite(settings.tolerance.absolute))
    return fail(ec::invalid_parameter, "the surface tolerance must be a length, 0 or more");
  return {};
}

expected<improve_report> improve(mesh_builder& mesh, const std::vector<tet_id>& region,
                                 const improve_settings& settings, const execution& run) {
  if (settings.thorough) {
    const auto tets = grow(mesh, region, settings.rings);
    return improve_thoroughly(mesh, {tets.begin(), tets.end()}, *settings.thorough, run);
  }
  local_moves moves(mesh, grow(mesh, region, settings.rings));
  improve_report report;
  report.min_before = worst_of(mesh, moves.allowed());
  for (int sweep = 0; sweep < settings.sweeps; ++sweep) {
    bool changed = false;
    for (const auto t : bad_tets(mesh, moves.allowed(), settings.flip_below)) {
      if (run.cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      if (!mesh.is_live_tet(t) || radius_ratio(mesh.corners(t)) >= settings.flip_below)
        continue;
      if (moves.flip(t)) {
        ++report.moves.flips;
        changed = true;
      } else if (moves.relocate_corner(t)) {
        ++report.moves.relocations;
        changed = true;
      }
    }
    for (const auto t : bad_tets(mesh, moves.allowed(), settings.insert_below)) {
      if (run.cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      if (!mesh.is_live_tet(t) || radius_ratio(mesh.corners(t)) >= settings.insert_below)
        continue;
      if (moves.insert_vertex(t)) {
        ++report.moves.insertions;
        changed = true;
      }
    }
    if (!changed)
      break;
  }
  report.min_after = worst_of(mesh, moves.allowed());
  return report;
}

}  // namespace tedit
