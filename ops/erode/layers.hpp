// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/erode/removal.hpp"

namespace tedit::ops {

/// Takes off the layer of tets below the surfaces, then the one below what that laid bare, and so
/// on: in each step all tets that touch a vertex inside the selection, and what these cut off from
/// every other surface (paper, section 4.2); then hinges are mended, crumbs removed, and the new
/// surface is smoothed. Errors: `empty_selection` when a layer holds nothing, `invalid_argument`
/// when the part would fall apart, `cancelled`.
[[nodiscard]] expected<void> erode_layers(mesh_builder& mesh,
                                          const std::vector<surface_id>& surfaces, int layers,
                                          context& ctx, erosion_sum& sum);

}  // namespace tedit::ops
