// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/optimize/lift.hpp"

#include <algorithm>

#include "base/guard.hpp"

namespace tedit {

namespace {

/// Operations may promise no more than this.
constexpr double acceptable = 0.1;

std::vector<std::uint32_t> worst_below(const work_mesh& mesh, double limit) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live(t) && mesh.quality(t) < limit)
      result.push_back(t);
  std::ranges::sort(result, {}, [&](auto t) { return std::pair(mesh.quality(t), t); });
  return result;
}

/// Tries every tet below the limit, worst first, unless nothing around it has changed since the
/// last time; returns whether something did.
template <class Attempt>
bool sweep(work_mesh& mesh, double limit, std::vector<std::uint64_t>& tried, Attempt&& attempt) {
  bool changed = false;
  for (const auto t : worst_below(mesh, limit)) {
    check_cancelled();
    if (!mesh.is_live(t) || mesh.quality(t) >= limit)
      continue;
    tried.resize(mesh.tet_slots(), 0);
    if (tried[t] > mesh.changed_at(t))
      continue;
    if (attempt(t))
      changed = true;
    else
      tried[t] = mesh.now() + 1;
  }
  return changed;
}

double lowest(const work_mesh& mesh) {
  double result = 1;
  for (std::uint32_t t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live(t))
      result = std::min(result, mesh.quality(t));
  return result;
}

/// Sum of 1 / q - 1 over the tets that are not decent.
double badness(const work_mesh& mesh) {
  double sum = 0;
  for (std::uint32_t t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live(t) && mesh.quality(t) < decent_quality)
      sum += decent_quality / std::max(mesh.quality(t), 1e-12) - 1;
  return sum;
}

/// What was made of a region, and how.
struct attempt {
  work_mesh mesh;
  move_counts moves;

  /// Lifts what is below the target; see `worst_first` for `worst_only`.
  void lift(double target, double insert_below, int sweeps, bool worst_only) {
    const surface_guard kept(mesh, {});
    worst_first steps(mesh, kept, target, moves, worst_only);
    lift_worst(mesh, steps, {target, insert_below, sweeps});
  }

  /// Is its worst tet acceptable where the other's is not, or the whole better? What a thin
  /// boundary triangle spoils is better left as it was.
  [[nodiscard]] bool beats(const attempt& other) const {
    const double worst = lowest(mesh);
    return worst > lowest(other.mesh) &&
           (worst >= acceptable || badness(mesh) < badness(other.mesh));
  }
};

/// The best of three: with all clauses, then the worst ones whatever else gets worse by it, then
/// that from the start.
attempt best_attempt(attempt start, const improve_settings& settings) {
  auto best = start;
  best.lift(settings.flip_below, settings.insert_below, settings.sweeps, false);
  if (lowest(best.mesh) >= decent_quality)
    return best;
  auto further = best;
  further.lift(decent_quality, decent_quality, settings.sweeps, true);
  if (further.beats(best))
    best = std::move(further);
  if (lowest(best.mesh) >= acceptable)
    return best;
  start.lift(settings.flip_below, settings.insert_below, settings.sweeps, true);
  return start.beats(best) ? start : best;
}

}  // namespace

void lift_worst(work_mesh& mesh, worst_first& moves, const lift_settings& settings) {
  std::vector<std::uint64_t> mended(mesh.tet_slots(), 0);
  std::vector<std::uint64_t> split(mesh.tet_slots(), 0);
  for (int n = 0; n < settings.sweeps; ++n) {
    bool changed =
      sweep(mesh, settings.target, mended, [&](std::uint32_t t) { return moves.mend(t); });
    changed |=
      sweep(mesh, settings.insert_below, split, [&](std::uint32_t t) { return moves.insert(t); });
    if (!changed)
      return;
  }
}

expected<improve_report> improve_locally(mesh_builder& mesh, std::vector<tet_id> tets,
                                         const improve_settings& settings, const execution& run) {
  auto done = guarded(run, [&]() -> expected<improve_report> {
    std::ranges::sort(tets);
    attempt start{work_mesh(mesh, tets, true), {}};
    improve_report report;
    report.min_before = lowest(start.mesh);
    check_cancelled();
    const auto best = best_attempt(std::move(start), settings);
    report.moves = best.moves;
    report.min_after = lowest(best.mesh);
    if (auto written = best.mesh.write(mesh); !written)
      return fail(written.error());
    return report;
  });
  if (!done && done.error().code == ec::cancelled)
    return fail(ec::cancelled, "the edit was cancelled");
  return done;
}

}  // namespace tedit
