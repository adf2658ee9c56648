// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <vector>

#include "base/child_process.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// The program `tedit-mesher`: in $TEDIT_LIBEXEC, else beside the running executable. What it does
/// may end it, so it runs in a process of its own, under limits.
[[nodiscard]] std::filesystem::path mesher_program();

/// What a confined process may have started for operations, and for the files that it reads and
/// writes: the mesher and the program for MED files. Either need not be there.
[[nodiscard]] std::vector<std::filesystem::path> programs_of_operations();

/// Of processor time, which the program watches: what is asked of it mostly takes a hundredth of
/// this, or has no end.
constexpr std::chrono::milliseconds most_meshing_time{8000};

/// By the clock four times what it may compute: others may have the processors meanwhile.
[[nodiscard]] inline child_limits mesher_limits(std::chrono::milliseconds computing) {
  child_limits limits;
  limits.time = 4 * computing;
  return limits;
}

/// `services::tetrahedralise`, by that program. Tets with a radius ratio below `least_quality` are
/// an error.
[[nodiscard]] expected<tet_filling> tetrahedralise_surface(const closed_surface& shell,
                                                           const execution& run,
                                                           double least_quality = 1e-3);

}  // namespace tedit::ops
