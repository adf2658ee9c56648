// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>
#include <variant>
#include <vector>

#include "fem/load_case.hpp"
#include "mesh/surface_map.hpp"
#include "protocol/report.hpp"

/// Load cases as a person changes them: item by item, each checked in words before it is sent.
namespace tedit::desktop {

/// What a load case is made of; `item_kind` is the place in the variant.
using load_item = std::variant<fem::material, fem::constraint, fem::load>;
enum class item_kind { material, support, load };

[[nodiscard]] item_kind kind_of(const load_item& item);
/// "Al 6061, E 68900 MPa", "Fixed", "Force 500 N along −z".
[[nodiscard]] QString words(const load_item& item);
/// What it acts on; a material on none.
[[nodiscard]] std::vector<surface_id> surfaces_of(const load_item& item);
/// Items of a kind that a load case has.
[[nodiscard]] std::size_t count_of(const fem::load_case& loads, item_kind kind);
/// @pre at < count_of(loads, kind)
[[nodiscard]] load_item item_at(const fem::load_case& loads, item_kind kind, std::size_t at);
/// Replaces the item of its kind at this place, or adds it when there is none.
void put(fem::load_case& loads, const load_item& item, std::optional<std::size_t> at = {});
/// Nothing happens when there is none.
void remove(fem::load_case& loads, item_kind kind, std::size_t at);

/// Replaces the one of its name where it stands, or adds it.
void put(std::vector<fem::load_case>& all, const fem::load_case& loads);
/// `wanted`, or "wanted 2", "wanted 3", ... : a name that none of them has.
[[nodiscard]] std::string free_name(const std::string& wanted,
                                    const std::vector<fem::load_case>& all);

/// What is wrong with a value, at the field of this name ("young_modulus", "surfaces", ...).
struct item_fault {
  QString field;
  QString words;
};

/// Empty: the item can be sent. Checks what the solver would refuse (see fem/load_case.hpp).
[[nodiscard]] std::vector<item_fault> faults(const load_item& item);

/// What a load case lacks to be solved: "a material, a support"; empty when it is complete.
[[nodiscard]] QString missing(const fem::load_case& loads);

/// Ids of regions, with commas or spaces between; nothing when something else stands there.
[[nodiscard]] std::optional<std::vector<region_id>> read_regions(const QString& text);

/// Where a material goes: one for all remaining regions replaces the other such one, because a part
/// can have only one of them; others are added. Nothing: added.
[[nodiscard]] std::optional<std::size_t> place_for(const fem::load_case& loads,
                                                   const fem::material& added);

/// The load case after an edit with this surface map, as `fem::carry_over` does it on the server:
/// surfaces that are gone leave the lists, merged ones are replaced, split ones gain their parts,
/// items without surfaces are dropped.
[[nodiscard]] fem::load_case carried(const fem::load_case& before,
                                     const std::vector<surface_change>& map);

/// What an edit did to an item: from a line of its receipt.
struct item_mark {
  item_kind kind = item_kind::load;
  std::optional<std::size_t> at;  ///< In the load case after the edit; none when it was dropped.
  fem::receipt_fate fate = fem::receipt_fate::kept;
  QString text;  ///< One sentence.
};

/// The items of a load case that are not as before; kept ones have no mark.
[[nodiscard]] std::vector<item_mark> marks(const edit_report& report, const std::string& load_case);

}  // namespace tedit::desktop
