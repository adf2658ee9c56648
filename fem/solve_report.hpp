// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/types.hpp"
#include "mesh/vec3.hpp"

/// What a solve has to tell, as plain values: for whoever shows or sends it, without the solver.
namespace tedit {

namespace fem {

/// Why the stress at a node does not converge.
enum class singularity { clamp_rim, reentrant_edge };

}  // namespace fem

/// The force with which the supports on one surface hold the part.
struct named_reaction {
  surface_id surface = 0;
  std::string name;  ///< For people; may be empty.
  vec3 force_n;
};

/// A place where the stress grows with every refinement: `fem::singular_place` without its node.
struct stress_peak {
  fem::singularity kind = fem::singularity::clamp_rim;
  vec3 at;
  double von_mises_pa = 0;
};

/// "clamp_rim" or "reentrant_edge".
[[nodiscard]] constexpr std::string_view singularity_name(fem::singularity kind) noexcept {
  return kind == fem::singularity::clamp_rim ? "clamp_rim" : "reentrant_edge";
}

/// All that a person wants to know about a solve, without its fields (`tedit.v1.SolveReport`, which
/// says what each number means).
struct solve_report {
  static constexpr std::size_t most_singular_places = 20;

  std::string version_id;
  std::string load_case;
  std::string device;
  int element_order = 1;
  bool preview = true;
  bool interim = false;  ///< A frame of a solve that still runs; the converged result follows.
  std::uint64_t dofs = 0;
  int iterations = 0;
  double true_relative_residual = 1;
  double max_displacement_m = 0;
  vec3 max_displacement_at;
  double compliance_j = 0;
  double max_von_mises_pa = 0;
  vec3 max_von_mises_at;
  vec3 reaction_n;
  vec3 applied_n;
  double assembly_ms = 0;
  double setup_ms = 0;
  double solve_ms = 0;
  double recovery_ms = 0;
  double total_ms = 0;
  double strain_energy_j = 0;
  std::optional<double> mass_kg;  ///< Empty when a density is unknown.
  double relative_error_estimate = 0;
  std::optional<double> min_safety_factor;  ///< Empty when no yield strength is known.
  vec3 min_safety_factor_at;
  std::vector<named_reaction> surface_reactions;  ///< Ascending by surface.
  std::vector<stress_peak> singular_places;       ///< By descending stress, `most_singular_places`.
  std::size_t singular_places_count = 0;          ///< All that were found.
  /// What the largest von Mises stress sits at; empty: at no singular place that was found.
  std::optional<fem::singularity> max_von_mises_singularity;
  std::string notice;                 ///< How it was computed, where that is not as asked for.
  std::vector<std::string> warnings;  ///< About its loads and supports: `fem::constraint::warning`.
};

/// A value over several load cases, its place and whose it is.
struct worst_value {
  double value = 0;
  vec3 at;
  std::string load_case;
};

/// What is worst over several load cases (`tedit.v1.Envelope`).
struct solve_envelope {
  std::string version_id;
  std::vector<std::string> load_cases;  ///< Names, in the order of the reports.
  int element_order = 1;
  bool preview = true;  ///< One of the reports is.
  bool interim = false;
  worst_value max_von_mises;                     ///< Pa.
  worst_value max_displacement;                  ///< m.
  std::optional<worst_value> min_safety_factor;  ///< Empty when no yield strength is known.
};

/// What a solve has to tell, of one load case or of several (`tedit.v1.Solved`).
struct solve_outcome {
  std::vector<solve_report> cases;         ///< At least one.
  std::optional<solve_envelope> envelope;  ///< When there are several.
  std::uint64_t solve = 0;                 ///< The number that a server gave it; 0: none did.

  [[nodiscard]] const std::string& version_id() const { return cases.front().version_id; }
};

}  // namespace tedit
