// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tedit {

/// What a process holds of what the system bounds.
struct process_usage {
  std::uint64_t descriptors = 0;
  std::uint64_t threads = 0;
  std::uint64_t resident_bytes = 0;
  std::uint64_t descriptor_limit = 0;  ///< RLIMIT_NOFILE.
  std::uint64_t memory_limit = 0;      ///< RLIMIT_DATA; 2^64 - 1: none.
};

/// This process's, now. Cost: reads three small folders and files of /proc, some 50 us.
[[nodiscard]] process_usage usage_of_this_process();

/// Why a process is better replaced than given more work, beside what it held at its start: it
/// keeps files open or threads running, holds most of the memory that it may have, or may have less
/// than before. Nothing while it is fit.
[[nodiscard]] std::optional<std::string> used_up(const process_usage& at_start,
                                                 const process_usage& now);

/// Bounds the memory that this process may write to (RLIMIT_DATA): what goes beyond fails as if the
/// machine had no more. Not under sanitizers, whose shadow memory counts.
void limit_memory(std::uint64_t bytes);

}  // namespace tedit
