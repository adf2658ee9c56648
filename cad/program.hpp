// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/execution.hpp"

namespace tedit::cad {

/// What one of the two programs may use up.
struct program_limits {
  std::chrono::seconds time{120};                       ///< Of CPU, and by the clock.
  std::uint64_t memory_bytes = std::uint64_t{4} << 30;  ///< Address space.
  std::uint64_t file_bytes = std::uint64_t{1} << 30;    ///< Of each file that it writes.
  std::chrono::seconds clock{0};  ///< By the clock, for one that gives way to others; 0: as `time`.
};

/// How a program ended.
struct program_end {
  bool done = false;
  bool died = false;      ///< By a signal or an exit of its own, without a word of why.
  bool by_clock = false;  ///< Its time by the clock was over, not that of CPU.
  std::string doing;      ///< The last that it said it was doing: "transferring the model".
  error why;              ///< Unless `done`.
};

/// Runs `name` (cad/exchange.hpp) of the folder of programs in `folder`, with its arguments; its
/// progress goes to `run`. It is killed at the limits, on cancel, and when this process dies.
/// `what` is its name in messages: "the reader". Cost: the program's.
[[nodiscard]] program_end run_program(const std::string& name, const std::string& what,
                                      const std::filesystem::path& folder,
                                      const std::vector<std::string>& arguments,
                                      const program_limits& limits, const execution& run);

/// Whether the program is there. Errors: `service_unavailable` with what to do.
[[nodiscard]] expected<void> find_program(const std::string& name);

}  // namespace tedit::cad
