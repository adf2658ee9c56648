// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "sandbox/sandbox.hpp"

namespace tedit::ops {

/// What a process reaches that loads these plugins: what libraries read, and all that lies beside
/// the files.
[[nodiscard]] sandbox::reach reach_of_plugins(const std::vector<std::filesystem::path>& files);

/// Confines a process of one thread to that; nothing where it is not wanted. Errors:
/// `service_unavailable`.
[[nodiscard]] expected<void> confine_to(const sandbox::reach& reach);

}  // namespace tedit::ops
