// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fem/load_cases.hpp"
#include "mesh/field.hpp"

namespace tedit::fem {

/// Which arrays: those that fem/quantities.hpp says are sent to somebody, or those of files, too,
/// which are the larger part.
enum class field_range { shown, all };

/// Whether `field_range::shown` has this array, of one load case or of several.
[[nodiscard]] bool is_shown(const field& one);

/// The arrays of a solution by the slots of its version, as fem/quantities.hpp lists them. Mid
/// nodes of order 2 have no vertex and are left out: their reactions, too, so take totals from the
/// solution. Cost: O(mesh), on all cores.
[[nodiscard]] std::vector<field> make_fields(const mesh_version& mesh, const problem& p,
                                             const solution& result,
                                             field_range range = field_range::all);

/// The name of a load case's array among those of several: "von_mises_pa (braking)".
[[nodiscard]] std::string case_field(std::string_view name, std::string_view load_case);

/// The arrays of several load cases: those of each under `case_field`, and at vertices
/// envelope_von_mises (Pa, the largest over the cases), envelope_case (the index of the case that
/// it is of) and, when a yield strength is known, envelope_safety_factor (the smallest) and
/// envelope_safety_factor_case. Of a single one: as above. Cost: O(mesh) per case.
[[nodiscard]] std::vector<field> make_fields(const mesh_version& mesh, const case_set& set,
                                             const solved_cases& result,
                                             field_range range = field_range::all);

/// Of the arrays of load cases that were solved together (`several`) those of one, under their own
/// names: "von_mises_pa (braking)" as "von_mises_pa"; of a single case all, as they are. Cheap: the
/// values are shared.
[[nodiscard]] std::vector<field> fields_of_case(const std::vector<field>& all,
                                                const std::string& load_case, bool several);

}  // namespace tedit::fem
