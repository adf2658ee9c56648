// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "base/error.hpp"

namespace tedit {

/// Lets large blocks that are freed go back to the system at once, whatever their sizes. By itself
/// the allocator learns to keep them: a solve of a million tets then held a tenth more. Call it
/// first in `main`.
void return_large_blocks();

/// Gives pages of small blocks that were freed back to the system. After work that made very many
/// of them, before work that lasts. Cost: some ms.
void return_freed_memory();

/// How much more memory this process may take, and what sets the limit.
struct memory_room {
  std::uint64_t bytes = 0;
  std::string limit;  ///< "the machine", "the control group" or "the process's address space".
};

/// The least of MemAvailable, what the control groups (v2 or v1) leave, and RLIMIT_AS less what is
/// mapped. A limit that cannot be read does not count. `root` is where /proc and /sys are: tests
/// give their own. Cost: reads a few small files.
[[nodiscard]] memory_room available_memory(const std::filesystem::path& root = "/");

/// What this process could take at most if nobody else took any: the machine's memory, or the
/// least that one of its control groups may have. Cost: reads a few small files.
[[nodiscard]] std::uint64_t whole_memory(const std::filesystem::path& root = "/");

/// How many processes the system has ended because memory ran out, since it started; 0 where it
/// does not say. Cost: reads a file of /proc, some 20 us.
[[nodiscard]] std::uint64_t memory_kills(const std::filesystem::path& root = "/");

/// Refuses work that needs `bytes` when there are less. `what` begins the message ("the solve").
/// Errors: `out_of_memory` with both sizes, the limit and what to do.
[[nodiscard]] expected<void> check_memory(std::uint64_t bytes, const memory_room& room,
                                          const std::string& what);

}  // namespace tedit
