// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/adapt/size_field.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Lengths in m.
struct coarsen_settings {
  double size = 0;       ///< 0: twice the mean edge there.
  double depth = 0;      ///< 0: three times the size.
  double tolerance = 0;  ///< 0: a fiftieth of the size.
};

/// Contracts edges at what was picked that are shorter than the size. Errors: `empty_selection`;
/// `invalid_parameter` where nothing can go, `cancelled`. Cost: O(mesh).
[[nodiscard]] expected<edit_result> coarsen(const version_ptr& mesh, const mesh_pick& pick,
                                            const coarsen_settings& settings, context& ctx);

}  // namespace tedit::ops
