// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

namespace tedit {

/// How many processors this process may keep busy: those that it may run on (its affinity), or the
/// share of time that its control groups have (`cpu.max`; version 1: `cpu.cfs_quota_us`), rounded
/// up. More threads than that wait for their turn in the middle of a loop, and all others for them.
/// At least 1. `root` is where /proc and /sys are: tests give their own. Cost: reads a few small
/// files.
[[nodiscard]] unsigned processors(const std::filesystem::path& root = "/");

}  // namespace tedit
