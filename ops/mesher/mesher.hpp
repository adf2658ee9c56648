// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// The program `tedit-mesher`: in $TEDIT_LIBEXEC, else beside the running executable. What it does
/// may end it, so it runs in a process of its own, under limits.
[[nodiscard]] std::filesystem::path mesher_program();

/// `services::tetrahedralise`, by that program. Tets with a radius ratio below `least_quality` are
/// an error.
[[nodiscard]] expected<tet_filling> tetrahedralise_surface(const closed_surface& shell,
                                                           const execution& run,
                                                           double least_quality = 1e-3);

}  // namespace tedit::ops
