// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fem/load_case.hpp"
#include "mesh/surface_map.hpp"

namespace tedit::fem {

/// What an edit did to one constraint or load of one load case.
enum class receipt_fate {
  kept,          ///< All its surfaces are as before.
  area_changed,  ///< Its surfaces are there, their area differs.
  reduced,       ///< Some of its surfaces are gone, others are left.
  dropped        ///< All its surfaces are gone: it no longer acts.
};

[[nodiscard]] std::string_view fate_name(receipt_fate fate) noexcept;

struct receipt_line {
  std::string load_case;
  std::string item;  ///< "constraint 0 (fixed)" or "load 1 (force)".
  receipt_fate fate = receipt_fate::kept;
  std::vector<surface_id> surfaces_lost;
  double area_before = 0;  ///< m^2, all its surfaces together.
  double area_after = 0;
  std::string text;  ///< One sentence for a person.
};

/// A load case carried over an edit, with a line for every constraint and load.
struct carried_load_case {
  load_case after;
  std::vector<receipt_line> lines;
};

/// Carries `before` from version `from` to `to`: removed surfaces leave the lists, merged ones are
/// replaced by what they merged into, split ones gain the new parts; items without surfaces are
/// dropped. Total forces keep their total. Every item gets a line; nothing changes silently.
[[nodiscard]] carried_load_case carry_over(const load_case& before, const mesh_version& from,
                                           const mesh_version& to,
                                           const std::vector<surface_change>& map);

}  // namespace tedit::fem
