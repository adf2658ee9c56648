// SPDX-License-Identifier: AGPL-3.0-or-later
// Values of the kinds that are numbers in a text: places, ways, axes, planes, polylines, lists.
#pragma once

#include "base/number_range.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// What a number of it may be, in its unit: of an integer, a real, or each number of a list.
[[nodiscard]] number_range range_of(const parameter_description& p);

/// Whether a value of this kind is numbers in a text.
[[nodiscard]] bool is_number_text(parameter_type type);

/// Whether such a value has lengths, which may be given in millimetres.
[[nodiscard]] bool has_lengths(const parameter_description& p);

/// "parameter at: ..." with what to do instead, by the parameter's kind and range.
[[nodiscard]] tl::unexpected<error> wrong_value(const parameter_description& p,
                                                const std::string& why);

/// The value in the one way to write it: "1, 2.5, 0; 0, 0, 1". Between numbers may be commas or
/// blanks, between points semicolons or nothing more. A place of the part (`find_pick`) may stand
/// for a point, a direction, an axis, a plane, the points of an edge, or one of several points;
/// `mesh` is the part, null where there is none. Empty where it is left to the operation and the
/// default is so, too. `scale`: of what is a length. Errors: `invalid_parameter` with which number
/// or point is wrong; those of `find_pick`. Cost: O(text), which is read no further than the most
/// that a value holds, and that of `find_pick`.
[[nodiscard]] expected<parameter_value> typed_numbers(const parameter_description& p,
                                                      const parameter_value& given,
                                                      const mesh_version* mesh, double scale = 1);

}  // namespace tedit::ops
