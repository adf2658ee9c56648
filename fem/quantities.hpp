// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/for_people.hpp"

/// The tables of what a solve says at each place of the part. They drive what the server sends,
/// what clients read and what the window shows. A new field is what computes it (fem/fields.cpp), a
/// row in each table, its docs and its translation.
namespace tedit::fem {

/// As `tedit.v1.ResultArray.Place` numbers them.
enum class array_place { vertices, tets };

/// To whom the values at the part's boundary go; as `tedit.v1.ResultArray.Sent` numbers them.
enum class array_sent {
  always,      ///< With every field of a load case.
  on_request,  ///< To clients that watch it (`tedit.v1.WatchFields`).
  in_files     ///< To nobody; files have it.
};

/// Of several load cases the worst one: its arrays have names of their own.
struct envelope_names {
  std::string_view values;      ///< Among the fields of a solve.
  std::string_view cases;       ///< The same: which case each value is of.
  std::string_view sent_cases;  ///< That, as it is sent.
};

/// An array of a load case, one row a vertex or tet.
struct result_array {
  std::string_view name;
  std::string_view unit;  ///< SI; "ratio" is shown in per cent, "m/m" as a strain.
  int components = 1;
  array_sent sent = array_sent::in_files;
  array_place place = array_place::vertices;
  /// Only there when a material says its yield strength, and 0 where it does not.
  bool needs_yield = false;
  envelope_names envelope = {};  ///< Empty: there is none over several load cases.
};

inline constexpr result_array result_arrays[] = {
  {"displacement_m", "m", 3, array_sent::always},
  {"von_mises_pa",
   "Pa",
   1,
   array_sent::always,
   array_place::vertices,
   false,
   {"envelope_von_mises", "envelope_case", "von_mises_case"}},
  {"stress_pa", "Pa", 6, array_sent::on_request},
  {"safety_factor",
   "",
   1,
   array_sent::on_request,
   array_place::vertices,
   true,
   {"envelope_safety_factor", "envelope_safety_factor_case", "safety_factor_case"}},
  {"relative_error", "ratio", 1, array_sent::on_request},
  {"largest_strain", "m/m", 1, array_sent::on_request},
  {"reaction_n", "N", 3},
  {"principal_stress_pa", "Pa"},
  {"strain", "m/m", 6},
  {"element_von_mises_pa", "Pa", 1, array_sent::in_files, array_place::tets},
  {"element_stress_pa", "Pa", 6, array_sent::in_files, array_place::tets},
  {"element_error_sqrt_j", "J^0.5", 1, array_sent::in_files, array_place::tets},
};

/// How a number to show is made of an array's row.
enum class shown_part {
  component,  ///< Number `index`.
  size,       ///< Of a vector.
  principal,  ///< Principal value `index` of a tensor xx, yy, zz, xy, yz, zx; the largest is 0.
  max_shear   ///< Half the difference of the largest and the smallest of these.
};

/// By which colours a quantity is read.
enum class field_kind {
  magnitude,  ///< Even ones, from its smallest value on.
  has_sign,   ///< Diverging, 0 in the middle.
  safety      ///< Steps from red, below 1, to blue; reversed, as little is bad.
};

/// What belongs together stands together where people choose.
enum class field_group { stress, displacement, stress_tensor, strain, judgement };

/// A quantity that people choose to see.
struct shown_quantity {
  std::string_view id;     ///< For scripts and settings.
  std::string_view title;  ///< For people.
  std::string_view array;  ///< Of `result_arrays`; its unit is this one's.
  field_kind kind = field_kind::magnitude;
  shown_part part = shown_part::component;
  int index = 0;
  field_group group = field_group::stress;
  std::string_view help;  ///< One or two sentences: what it says, and what it does not.
};

/// In the order in which people are offered them.
inline constexpr shown_quantity shown_quantities[] = {
  {"von_mises", for_people("legend", "von Mises stress"), "von_mises_pa", field_kind::magnitude,
   shown_part::component, 0, field_group::stress,
   for_people("legend",
              "One number for how near a ductile material is to yielding. It has no "
              "sign: tension and compression look alike.")},
  {"principal_1", for_people("legend", "Principal stress 1"), "stress_pa", field_kind::has_sign,
   shown_part::principal, 0, field_group::stress,
   for_people("legend", "The largest tension at each point: it opens cracks.")},
  {"principal_2", for_people("legend", "Principal stress 2"), "stress_pa", field_kind::has_sign,
   shown_part::principal, 1, field_group::stress,
   for_people("legend", "The middle one of the principal stresses.")},
  {"principal_3", for_people("legend", "Principal stress 3"), "stress_pa", field_kind::has_sign,
   shown_part::principal, 2, field_group::stress,
   for_people("legend", "The largest compression at each point, negative.")},
  {"max_shear", for_people("legend", "Largest shear"), "stress_pa", field_kind::magnitude,
   shown_part::max_shear, 0, field_group::stress,
   for_people("legend", "Half the difference of principal stress 1 and 3 (Tresca).")},
  {"displacement", for_people("legend", "Displacement"), "displacement_m", field_kind::magnitude,
   shown_part::size, 0, field_group::displacement,
   for_people("legend", "How far each point moves.")},
  {"displacement_x", for_people("legend", "Displacement x"), "displacement_m", field_kind::has_sign,
   shown_part::component, 0, field_group::displacement,
   for_people("legend", "How far each point moves along x.")},
  {"displacement_y", for_people("legend", "Displacement y"), "displacement_m", field_kind::has_sign,
   shown_part::component, 1, field_group::displacement,
   for_people("legend", "How far each point moves along y.")},
  {"displacement_z", for_people("legend", "Displacement z"), "displacement_m", field_kind::has_sign,
   shown_part::component, 2, field_group::displacement,
   for_people("legend", "How far each point moves along z.")},
  {"stress_xx", for_people("legend", "Stress xx"), "stress_pa", field_kind::has_sign,
   shown_part::component, 0, field_group::stress_tensor,
   for_people("legend", "Along x; tension is positive.")},
  {"stress_yy", for_people("legend", "Stress yy"), "stress_pa", field_kind::has_sign,
   shown_part::component, 1, field_group::stress_tensor,
   for_people("legend", "Along y; tension is positive.")},
  {"stress_zz", for_people("legend", "Stress zz"), "stress_pa", field_kind::has_sign,
   shown_part::component, 2, field_group::stress_tensor,
   for_people("legend", "Along z; tension is positive.")},
  {"stress_xy", for_people("legend", "Shear stress xy"), "stress_pa", field_kind::has_sign,
   shown_part::component, 3, field_group::stress_tensor,
   for_people("legend", "In the plane of x and y.")},
  {"stress_yz", for_people("legend", "Shear stress yz"), "stress_pa", field_kind::has_sign,
   shown_part::component, 4, field_group::stress_tensor,
   for_people("legend", "In the plane of y and z.")},
  {"stress_zx", for_people("legend", "Shear stress zx"), "stress_pa", field_kind::has_sign,
   shown_part::component, 5, field_group::stress_tensor,
   for_people("legend", "In the plane of z and x.")},
  {"largest_strain", for_people("legend", "Largest principal strain"), "largest_strain",
   field_kind::has_sign, shown_part::component, 0, field_group::strain,
   for_people("legend",
              "The largest stretch at each point, in whatever direction it is: what a "
              "strain gauge could read there. 1000 µm/m are 0.1 %.")},
  {"safety_factor", for_people("legend", "Safety factor"), "safety_factor", field_kind::safety,
   shown_part::component, 0, field_group::judgement,
   for_people("legend",
              "Yield strength over von Mises stress. Red, below 1: it yields. Grey: "
              "the material has no yield strength.")},
  {"relative_error", for_people("legend", "Estimated error"), "relative_error",
   field_kind::magnitude, shown_part::component, 0, field_group::judgement,
   for_people("legend",
              "How far the stress may be off for want of a finer mesh, in per cent "
              "of the part's mean stress. An indicator, not a bound.")},
};

/// The array of this name, or null.
[[nodiscard]] constexpr const result_array* find_array(std::string_view name) {
  const auto* found = std::ranges::find(result_arrays, name, &result_array::name);
  return found == std::end(result_arrays) ? nullptr : found;
}

/// Whether only those who watch an array need it: comparisons and envelopes are made of the others.
[[nodiscard]] constexpr bool is_for_watchers(const result_array& array) {
  return array.sent == array_sent::on_request && array.envelope.values.empty();
}

/// The names of those that are sent on request, for a sentence: "stress_pa, safety_factor".
[[nodiscard]] inline std::string arrays_on_request() {
  std::string result;
  for (const auto& array : result_arrays)
    if (array.sent == array_sent::on_request)
      result += (result.empty() ? "" : ", ") + std::string(array.name);
  return result;
}

}  // namespace tedit::fem
