// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/execution.hpp"

namespace tedit {

struct child_limits {
  std::chrono::milliseconds time{8000};
  std::size_t memory_bytes = std::size_t{2} << 30;  ///< Address space; 0 for no limit.
  std::size_t output_bytes = 0;                     ///< On stdout; 0 for no limit.
};

/// Starts a program with these stdin and stdout; its stderr goes nowhere. It is killed when this
/// thread ends. Its id, or -1 with errno.
[[nodiscard]] pid_t start_program(const std::vector<std::string>& command, int in, int out,
                                  const child_limits& limits);

/// Runs a program, feeds it `input` on stdin and returns what it wrote on stdout once it has ended
/// with status 0. Its stderr goes nowhere. It is killed at the time limit, on cancel, and when this
/// process dies. A process that may start no program has it started by another
/// (`start_programs_by`). Errors: `service_unavailable` when it cannot be started, `timeout`, also
/// where its own timer of processor time ended it (SIGPROF), `cancelled`, `mesher_failed` naming
/// the exit status or signal, or that it wrote more than it may.
[[nodiscard]] expected<std::vector<char>> run_child(const std::vector<std::string>& command,
                                                    std::span<const char> input,
                                                    const child_limits& limits,
                                                    const execution& run);

/// The folder of the running executable.
[[nodiscard]] std::filesystem::path executable_folder();

/// Where a program of ours lies that this one starts: in $TEDIT_LIBEXEC, else beside this one.
[[nodiscard]] std::filesystem::path helper_program(std::string_view name);

}  // namespace tedit
