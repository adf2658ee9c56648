// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/optimize/thorough.hpp"

#include <algorithm>
#include <cmath>

#include "base/guard.hpp"
#include "mesh/optimize/harmonic.hpp"
#include "mesh/optimize/lift.hpp"

namespace tedit {

namespace {

/// Sweeps of one pass that lifts the worst; most settle after three.
constexpr int lifting_sweeps = 6;

/// Relocations of all vertices between two rounds of flips.
constexpr int relocation_sweeps = 3;

/// A round that lowers the sum of eta by less than this share is the last one.
constexpr double settled_share = 1e-3;

class thorough_pass {
public:
  thorough_pass(work_mesh& mesh, const thorough_settings& settings, const execution& run)
      : mesh_(mesh),
        settings_(settings),
        run_(run),
        kept_(mesh, {}),
        guard_(mesh, settings.tolerance),
        inside_(mesh, kept_, settings.target, counts_),
        everywhere_(mesh, guard_, settings.target, counts_) {}

  const move_counts& run() {
    report(0.05, "lifting the worst tets");
    lift();
    for (int round = 0; settings_.harmonic && round < settings_.rounds; ++round) {
      report(0.1 + 0.8 * (round + 0.5) / settings_.rounds, "smoothing");
      const bool settled = smooth();
      report(0.1 + 0.8 * (round + 1.0) / settings_.rounds, "lifting the worst tets");
      lift();
      if (settled)
        break;
    }
    return counts_;
  }

private:
  void report(double fraction, const char* stage) const { run_.report(fraction, stage); }

  [[nodiscard]] double lowest() const {
    double result = 1;
    for (std::uint32_t t = 0; t < mesh_.tet_slots(); ++t)
      if (mesh_.is_live(t))
        result = std::min(result, mesh_.quality(t));
    return result;
  }

  /// What can be mended inside is mended there; the boundary is for what is left.
  void lift() {
    lift(inside_);
    if (guard_.active())
      lift(everywhere_);
  }

  void lift(worst_first& moves) {
    lift_worst(mesh_, moves, {settings_.target, settings_.insert_below, lifting_sweeps});
  }

  /// Flips and relocations that lower the sum of eta; true when there is not much left to gain.
  bool smooth() {
    // Where the worst tet is better than the target, that is the floor: no minimum falls.
    const double floor = std::max(settings_.target, lowest());
    flip_to_harmonic(mesh_, guard_, floor, counts_);
    double first = 0;
    double last = 0;
    for (int n = 0; n < relocation_sweeps; ++n) {
      last = relocate_to_harmonic(mesh_, floor, counts_);
      if (n == 0)
        first = last;
    }
    return first - last < settled_share * first;
  }

  work_mesh& mesh_;
  const thorough_settings& settings_;
  const execution& run_;
  surface_guard kept_;
  surface_guard guard_;
  move_counts counts_;
  worst_first inside_;
  worst_first everywhere_;
};

quality_figures measure(const work_mesh& mesh) {
  std::vector<std::uint32_t> live;
  for (std::uint32_t t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live(t))
      live.push_back(t);
  return measure_quality(live.size(), [&](std::size_t i) { return mesh.corners(live[i]); });
}

}  // namespace

expected<improve_report> improve_thoroughly(mesh_builder& mesh, std::vector<tet_id> tets,
                                            const thorough_settings& settings,
                                            const execution& run) {
  auto done = guarded(run, [&]() -> expected<improve_report> {
    std::ranges::sort(tets);
    work_mesh work(mesh, tets);
    improve_report report;
    report.before = measure(work);
    report.moves = thorough_pass(work, settings, run).run();
    report.after = measure(work);
    report.surface_deviation = work.largest_deviation();
    report.min_before = report.before->min_ratio;
    report.min_after = report.after->min_ratio;
    check_cancelled();
    if (auto written = work.write(mesh); !written)
      return fail(written.error());
    return report;
  });
  if (!done && done.error().code == ec::cancelled)
    return fail(ec::cancelled, "the edit was cancelled");
  return done;
}

}  // namespace tedit
