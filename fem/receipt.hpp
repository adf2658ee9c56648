// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fem/load_case.hpp"
#include "mesh/surface_map.hpp"

namespace tedit::fem {

/// What is done with a constraint or load whose surface an edit takes away.
enum class load_policy {
  drop,   ///< It leaves; the receipt says so.
  move,   ///< It goes to the surfaces that took the place (`successors`), its total kept.
  refuse  ///< The edit is refused when anything would be lost.
};

[[nodiscard]] std::string_view policy_name(load_policy policy) noexcept;

/// Errors: `invalid_argument` naming the policies that there are.
[[nodiscard]] expected<load_policy> policy_from_name(std::string_view name);

/// How loads and constraints follow one edit.
struct carry_settings {
  load_policy policy = load_policy::drop;
  bool keep_traction = false;  ///< A traction or pressure that moves keeps its Pa, not its N.

  friend bool operator==(const carry_settings&, const carry_settings&) = default;
};

/// What an edit did to one constraint or load of one load case.
enum class receipt_fate {
  kept,          ///< All its surfaces are as before.
  area_changed,  ///< Its surfaces are there, their area differs.
  reduced,       ///< Some of its surfaces are gone, others are left.
  dropped,       ///< All its surfaces are gone: it no longer acts.
  moved          ///< Some or all of its surfaces are gone; others carry their share.
};

[[nodiscard]] std::string_view fate_name(receipt_fate fate) noexcept;

struct receipt_line {
  std::string load_case;
  std::string item;  ///< "constraint 0 (fixed)" or "load 1 (bearing force)".
  receipt_fate fate = receipt_fate::kept;
  std::vector<surface_id> surfaces_lost;
  double area_before = 0;  ///< m^2, all its surfaces together.
  double area_after = 0;
  std::string text;                  ///< One sentence for a person.
  std::vector<surface_id> moved_to;  ///< Surfaces that carry the share of lost ones.
  double total_before = 0;  ///< N: of a force its length, of a traction or pressure times the area.
  /// Both are 0 for constraints, moments and pressures that change by place.
  double total_after = 0;
  std::string warning = {};  ///< It moved to an area `much_larger` than its own was.
};

/// A constraint or load that moves to surfaces of more than so many times its area warns: a whole
/// wall is held where a bore was.
inline constexpr double much_larger = 1.5;

/// A load case carried over an edit, with a line for every constraint and load.
struct carried_load_case {
  load_case after;
  std::vector<receipt_line> lines;
};

/// Carries `before` from version `from` to `to`: surfaces that merged are replaced by what they
/// merged into, split ones gain the new parts. Removed ones leave the lists; items without
/// surfaces are dropped. Under `move` the share of a removed surface (by area) goes to its
/// successors instead, as loads of their own, weighted by the successors' new area; what has no
/// successor is dropped. A force keeps its total as long as any of its surfaces or successors is
/// left, tractions and pressures keep their Pa on the surfaces that are left; moments and remote
/// forces are spread over left and new surfaces together; where its bore is gone a bearing force
/// goes on as a force. Every item gets a line; nothing changes silently: what moves to an area
/// `much_larger` warns in its line, and keeps the warning from then on. `refuse` carries as `drop`:
/// see `refuse_losses`. Cost: O(facets); under `move` once more for each surface lost.
[[nodiscard]] carried_load_case carry_over(const load_case& before, const mesh_version& from,
                                           const mesh_version& to,
                                           const std::vector<surface_change>& map,
                                           const carry_settings& settings = {});

/// Errors: `postcondition_failed` naming load case, item and surfaces of all that these lines lose.
[[nodiscard]] expected<void> refuse_losses(const std::vector<receipt_line>& lines);

}  // namespace tedit::fem
