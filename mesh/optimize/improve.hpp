// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/execution.hpp"
#include "mesh/optimize/quality_figures.hpp"
#include "mesh/optimize/worst_first.hpp"

namespace tedit {

/// The long way: everything that helps, for seconds instead of milliseconds.
struct thorough_settings {
  double target = 0.35;         ///< Tets with q below this are lifted, worst first.
  double insert_below = 0.3;    ///< Those still below this get a vertex on an edge.
  bool harmonic = true;         ///< Lower the sum of eta between the passes that lift the worst.
  surface_tolerance tolerance;  ///< 0: no facet changes, no boundary vertex moves.
  int rounds = 3;               ///< At most so many of lifting and smoothing.
};

struct improve_settings {
  double flip_below = 0.35;    ///< Tets with q below this are flipped and relocated.
  double insert_below = 0.20;  ///< Tets still below this get a vertex on an interior edge.
  int rings = 2;               ///< Rings of tets around the region that may change, too.
  int sweeps = 8;              ///< At most so many rounds.
  std::optional<thorough_settings> thorough;  ///< Instead of the local pass.
};

/// How much of it an operation asks for after its edit.
enum class improvement { none, local, thorough };

struct improve_request {
  improvement how = improvement::local;
  thorough_settings thorough;  ///< Only for `thorough`.

  improve_request() = default;
  improve_request(improvement wanted) : how(wanted) {}
  improve_request(improvement wanted, const thorough_settings& settings)
      : how(wanted), thorough(settings) {}
};

/// Errors: `invalid_parameter` for settings that are no numbers or out of range.
[[nodiscard]] expected<void> validate(const thorough_settings& settings);

struct improve_report {
  double min_before = 0;  ///< Worst q in the region (with rings) before and after.
  double min_after = 0;
  move_counts moves;
  double surface_deviation = 0;  ///< m: the boundary is at most so far from where it was.
  /// Of the region (with rings); only of the thorough pass.
  std::optional<quality_figures> before;
  std::optional<quality_figures> after;
};

/// Improves the tets of a region and its rings; never lowers their minimum quality. Without
/// `thorough` the worst-first local pass: flips (2-3, 3-2, 4-4, ...) and relocation of interior
/// vertices that raise the minimum, then vertex insertion on interior edges; no boundary vertex
/// moves, no facet changes. With it, passes that lift the worst (edge collapse, too) and passes
/// that lower the harmonic energy take turns, on all cores, and the boundary may change within the
/// tolerance. Region interfaces stay as they are in both. Deterministic, on any number of threads.
/// Measured reasons stand in docs/improve.md.
/// Errors: `cancelled`, `out_of_memory`. Cost: O(region), of the thorough pass O(mesh) once.
[[nodiscard]] expected<improve_report> improve(mesh_builder& mesh,
                                               const std::vector<tet_id>& region,
                                               const improve_settings& settings,
                                               const execution& run);

}  // namespace tedit
