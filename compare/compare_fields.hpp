// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "compare/comparison.hpp"
#include "compare/match.hpp"
#include "mesh/field.hpp"

namespace tedit {

/// The name of the difference of an array: "von_mises_pa_difference".
[[nodiscard]] std::string difference_array(std::string_view name);

/// The fields of one load case at a version's vertices, under the names of `fem::result_arrays`.
struct compared_fields {
  const mesh_version& mesh;
  const std::vector<field>& fields;
};

struct field_difference {
  field_comparison figures;  ///< Without the load case's name.
  /// By the vertex slots of after: `mark_array`, then the difference (after minus before) of each
  /// array at vertices that both have with as many components. Finite throughout: 0 at vertices
  /// that are marked `outside`, and at free slots.
  std::vector<field> fields;
};

/// The difference of two results at the vertices of after. At a vertex that both have (`match`) it
/// is that of the solver's own values; within other tets of before the value before is interpolated
/// linearly from the corners of the tet (stresses are linear between corners; a displacement is
/// not, by as much as the edges of the tet bend). A vertex that is outside by no more than
/// `still_inside` of a tet's height counts as on its face. Errors: `invalid_argument` without a
/// field "von_mises_pa" at the vertices of both; `cancelled`. Cost: O(vertices of after) and
/// O(changed log changed).
[[nodiscard]] expected<field_difference> compare_fields(const compared_fields& before,
                                                        const compared_fields& after,
                                                        const version_match& match,
                                                        const execution& run);

}  // namespace tedit
