// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace tedit {

/// The folders of the control group that this process is in and of all above it, the outermost
/// first: of version 2, or of a controller of version 1 ("memory", "cpu"). `root` is where /proc
/// and /sys are: tests give their own. Cost: reads a small file.
[[nodiscard]] std::vector<std::filesystem::path> control_groups(
  const std::filesystem::path& root = "/");
[[nodiscard]] std::vector<std::filesystem::path> control_groups_v1(
  std::string_view controller, const std::filesystem::path& root = "/");

/// The first number of a small file; nothing when there is none ("max", "-1").
[[nodiscard]] std::optional<std::uint64_t> number_in(const std::filesystem::path& file);

}  // namespace tedit
