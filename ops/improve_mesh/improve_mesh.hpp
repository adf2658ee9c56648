// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// The version with its tets without volume meshed anew, and the region that the host's optimizer
/// shall work on: all tets, or those within three rings of the surfaces picked.
/// Errors: `cancelled`. Cost: O(mesh), and a child process for each place with such tets.
[[nodiscard]] expected<edit_result> improve_mesh(const version_ptr& mesh, const selection& picked,
                                                 const thorough_settings& settings, context& ctx);

}  // namespace tedit::ops
