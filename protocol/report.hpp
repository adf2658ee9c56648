// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fem/load_cases.hpp"
#include "fem/receipt.hpp"
#include "mesh/finish_edit.hpp"
#include "mesh/surface_map.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::v1 {
class EditReport;
class Envelope;
class Solved;
class SolveReport;
}  // namespace tedit::v1

namespace tedit {

/// All that a person wants to know about an edit that was made (message `tedit.v1.EditReport`).
struct edit_report {
  std::string from_version;  ///< 32 hexadecimal digits.
  std::string to_version;
  std::string operation;
  std::vector<surface_id> surfaces;
  std::vector<surface_id> surfaces_used;  ///< As the operation completed them.
  std::vector<surface_change> surface_map;
  fem::carry_settings loads;  ///< What was to become of loads whose surface goes.
  std::vector<fem::receipt_line> receipt;
  std::vector<std::string> notices;
  std::vector<ops::figure> figures;            ///< Numbers of this operation alone.
  std::optional<improve_report> optimisation;  ///< Of a thorough one; both figures are there.
  std::uint64_t tets_added = 0;
  std::uint64_t tets_removed = 0;
  double volume_change = 0;              ///< m^3.
  std::optional<touched_ratios> ratios;  ///< Empty where the edit made and changed no tet.
  double operation_ms = 0;
  double improve_ms = 0;
  double check_ms = 0;
  double total_ms = 0;
};

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
[[nodiscard]] std::string_view singularity_name(fem::singularity kind) noexcept;

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

/// The report of a solution, without `total_ms`.
[[nodiscard]] solve_report make_report(const mesh_version& mesh, const std::string& load_case,
                                       const fem::problem& problem, const fem::solution& result);

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

  [[nodiscard]] const std::string& version_id() const { return cases.front().version_id; }
};

/// The reports of load cases that were solved together, and their envelope when there are several.
/// `total_ms` is shared among them.
[[nodiscard]] solve_outcome make_outcome(const mesh_version& mesh, const fem::case_set& set,
                                         const fem::solved_cases& result, bool interim,
                                         double total_ms);

namespace protocol {

void to_message(const edit_report& report, v1::EditReport* out);
[[nodiscard]] edit_report from_message(const v1::EditReport& message);
void to_message(const solve_report& report, v1::SolveReport* out);
[[nodiscard]] solve_report from_message(const v1::SolveReport& message);
void to_message(const solve_envelope& envelope, v1::Envelope* out);
[[nodiscard]] solve_envelope from_message(const v1::Envelope& message);
/// The document is not set.
void to_message(const solve_outcome& outcome, v1::Solved* out);
/// A message without any report gives one that is empty.
[[nodiscard]] solve_outcome from_message(const v1::Solved& message);

// -- as canonical JSON, the form in which reports are stored and travel between actors ----

[[nodiscard]] std::string to_json(const edit_report& report);
[[nodiscard]] std::string to_json(const solve_outcome& outcome);

/// Errors: `protocol_error`.
[[nodiscard]] expected<edit_report> edit_report_from_json(std::string_view json);
[[nodiscard]] expected<solve_outcome> solve_outcome_from_json(std::string_view json);

}  // namespace protocol

}  // namespace tedit
