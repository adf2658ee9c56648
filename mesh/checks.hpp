// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/execution.hpp"
#include "mesh/version.hpp"

namespace tedit {

/// One broken rule: which, at which element, with which numbers.
struct finding {
  ec code = ec::invalid_mesh;
  std::string rule;     ///< "positive orientation", "closed boundary", ...
  std::string element;  ///< "tet 17", "edge 4-9", "facet 3"; empty for the whole mesh.
  std::string numbers;  ///< "volume -3.2e-12 m^3".
};

/// Findings stop being listed after this many; `check_report::total` goes on counting.
inline constexpr std::size_t max_findings = 100;

struct check_report {
  std::vector<finding> findings;
  std::size_t total = 0;

  [[nodiscard]] bool ok() const { return total == 0; }
};

/// What an edit promises and the host checks (docs/architecture.md: an edit is a transaction).
struct edit_claim {
  /// m^3: what the operation says it added (plug) or took off; the check compares with the tets.
  double volume_change = 0;
  /// Tets of the candidate that the operation changed; all others must be bit-identical to the
  /// base.
  std::vector<tet_id> touched;
  /// Worst q = 3 r_in/R_circ allowed in the touched region, unless the region was worse before.
  double quality_floor = 0.15;
  /// Separate boundaries more than there were: pieces that the edit is meant to leave.
  std::size_t bodies_added = 0;
  /// Relative error allowed for the volume, against the larger of |change| and 1e-3 of the total.
  double volume_tolerance = 1e-9;
};

/// All invariants of one version with exact predicates: every tet positively oriented, adjacency
/// symmetric, incident tets right, boundary closed, oriented and 2-manifold at edges and vertices,
/// each facet on exactly one tet face and on a surface that the table knows, counts and free lists
/// right. Cost: O(mesh).
[[nodiscard]] check_report check_version(const mesh_version& mesh);

/// The postconditions of an edit on `candidate`. Invariants are checked where pages differ from
/// `base` (and around them), so cost follows the edit; untouched tets must be bit-identical. Also:
/// the number of boundary components must not grow by more than claimed (a closed void would), the
/// volume change is as claimed, worst quality of the touched region >= min(quality_floor, worst
/// before).
[[nodiscard]] check_report check_edit(const mesh_version& base, const mesh_version& candidate,
                                      const edit_claim& claim);

/// Worst q among the base's tets at the corners of a candidate's touched tets; 1 when there are
/// none.
[[nodiscard]] double worst_quality_before(const mesh_version& base, const mesh_version& candidate,
                                          const std::vector<tet_id>& touched);

/// The number of components of the boundary; facets hang together at common vertices. A separate
/// body is one more, and so is a closed void. Cost: O(facets).
[[nodiscard]] std::size_t boundary_components(const mesh_version& mesh);

/// One error out of a report: `postcondition_failed`, the first findings in the message.
[[nodiscard]] error to_error(const check_report& report);

}  // namespace tedit
