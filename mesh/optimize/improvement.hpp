// SPDX-License-Identifier: AGPL-3.0-or-later
// What may be asked of the optimizer, and what it tells: data alone. The work is in improve.hpp.
#pragma once

#include <cstddef>
#include <optional>

#include "mesh/optimize/quality_figures.hpp"

namespace tedit {

/// How far the boundary may go from where it was: absolute + relative * (mean length of the edges
/// of the facets that change). Both 0: the boundary stays as it is.
struct surface_tolerance {
  double absolute = 0;  ///< m.
  double relative = 0;  ///< Of the local edge length.

  [[nodiscard]] bool allows_any() const { return absolute > 0 || relative > 0; }
};

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

/// How often each move was made.
struct move_counts {
  std::size_t flips = 0;        ///< 2-3, and removals of interior edges.
  std::size_t relocations = 0;  ///< Interior vertices.
  std::size_t collapses = 0;    ///< Interior vertices gone.
  std::size_t insertions = 0;   ///< New vertices on edges.
  std::size_t harmonic_flips = 0;
  std::size_t harmonic_relocations = 0;
  std::size_t boundary_flips = 0;
  std::size_t boundary_relocations = 0;
  std::size_t boundary_collapses = 0;

  [[nodiscard]] std::size_t all() const {
    return flips + relocations + collapses + insertions + harmonic_flips + harmonic_relocations +
           boundary_flips + boundary_relocations + boundary_collapses;
  }
};

struct improve_report {
  double min_before = 0;  ///< Worst q in the region (with rings) before and after.
  double min_after = 0;
  move_counts moves;
  double surface_deviation = 0;  ///< m: the boundary is at most so far from where it was.
  /// Of the region (with rings); only of the thorough pass.
  std::optional<quality_figures> before;
  std::optional<quality_figures> after;
};

}  // namespace tedit
