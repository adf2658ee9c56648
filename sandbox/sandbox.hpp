// SPDX-License-Identifier: AGPL-3.0-or-later
// Confines a process that runs what others wrote: plugins, meshers, readers of files. It may go on
// with what it has open, and reach what it is given here; docs/decisions/0039 says by what means.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/error.hpp"

namespace tedit::sandbox {

/// What a confined process may reach by name.
struct reach {
  /// Files, and folders with all in them, for reading; those that are not there are left out.
  std::vector<std::filesystem::path> readable;
  /// The folder in which it may make files; empty: it can make none.
  std::filesystem::path own_folder;
  /// The most that one file may hold, wherever it is.
  std::uint64_t file_bytes = std::uint64_t{256} << 20;
};

/// What the C library, the dynamic linker and libraries read: the system's libraries and data,
/// facts of the machine and of the process itself, and the folders of LD_LIBRARY_PATH.
[[nodiscard]] std::vector<std::filesystem::path> system_files();

/// Whether a person said TEDIT_SANDBOX=off.
[[nodiscard]] bool is_switched_off();

/// Whether processes shall be confined: with TEDIT_SANDBOX=on, whatever comes of it, and else where
/// this machine can, unless it is switched off.
[[nodiscard]] bool is_wanted();

/// Whether this machine can. Errors: `service_unavailable` with what is missing and the ways out.
[[nodiscard]] expected<void> check();

/// Bounds what this thread, and those that it starts, reach by name; takes all rights of root and
/// the way to new ones. Call it before there are other threads. Errors: `service_unavailable`.
[[nodiscard]] expected<void> confine_files(const reach& to);

/// Which system calls are left: what threads, memory, files and lines that are open need.
enum class calls {
  of_plugins,  ///< With threads and files by name.
  of_filters,  ///< What reads stdin and writes stdout.
};

/// Bounds the system calls of all threads of this process. Harmless ones are refused; one that
/// nobody makes by mistake ends the process with the status of its `misdeed`. Errors:
/// `service_unavailable`.
[[nodiscard]] expected<void> confine_calls(calls left = calls::of_plugins);

}  // namespace tedit::sandbox
