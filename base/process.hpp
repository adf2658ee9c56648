// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace tedit {

/// The descriptor under which a program finds the file that `spawn_process` lets it inherit.
inline constexpr int inherited_fd = 3;

/// Starts a program that runs beside this one: stdin is empty, stdout and stderr are this
/// process's stderr, `inherited` (if not -1) is its `inherited_fd`, no other file is inherited, and
/// it is killed when the thread that started it ends. It has a process group of its own: signals to
/// its group do not reach this process, nor Ctrl-C it. Errors: `service_unavailable`.
[[nodiscard]] expected<pid_t> spawn_process(const std::vector<std::string>& command,
                                            int inherited = -1);

/// Closes all files but the standard streams and these; below zero is none.
void close_files_except(std::vector<int> kept);

/// How a process with this status of `waitpid` ended, for people: "was killed by signal 9 (Killed)"
/// or "ended with status 1"; of a confined one also "tried to open a network connection".
[[nodiscard]] std::string describe_end(int status);

/// How a process that has ended did so, as `describe_end` says it; nothing while it runs. The
/// process is reaped.
[[nodiscard]] std::optional<std::string> reap_process(pid_t pid);

/// Kills a process and waits for its end.
void kill_process(pid_t pid);

}  // namespace tedit
