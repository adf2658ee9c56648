// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/checks.hpp"
#include "mesh/optimize/improvement.hpp"

namespace tedit {

struct finish_settings {
  improve_settings improve;
  double quality_floor = 0.15;  ///< q = 3 r_in/R_circ; see `edit_claim`.
  bool settle = true;           ///< New vertices go onto their walls (`settle_on_walls`).
};

/// An operation may promise less than the host's floor, but no less than this.
inline constexpr double lowest_quality_floor = 0.05;

/// Radius ratios (mesh/quality.hpp) around what an edit did.
struct touched_ratios {
  double min_before = 0;  ///< Worst of the base's tets in and around the region.
  double min_after = 0;   ///< Worst of the touched tets.
  double median_after = 0;

  friend bool operator==(const touched_ratios&, const touched_ratios&) = default;
};

/// A candidate that passed every postcondition.
struct finished_edit {
  version_ptr version;
  std::vector<tet_id> touched;  ///< Tets of the version that are new or changed.
  improve_report improvement;
  /// m^3: the claim's, and what the optimizer did to the boundary within its tolerance.
  double volume_change = 0;
  std::optional<touched_ratios> ratios;  ///< Empty where no tet is new or changed.
  double improve_ms = 0;
  double check_ms = 0;
};

/// What becomes of an operation's candidate, whoever wrote the operation: its new vertices go onto
/// the walls that the CAD model has, the improvement that it asks for is made, then the
/// postconditions of an edit are looked at. Either all hold or nothing comes out. Errors:
/// `postcondition_failed` with the numbers, `cancelled`.
[[nodiscard]] expected<finished_edit> finish_edit(
  const version_ptr& base, const version_ptr& candidate, const edit_claim& claim,
  const improve_request& wanted, const finish_settings& settings, const execution& run);

}  // namespace tedit
