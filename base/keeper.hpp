// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "base/unique_fd.hpp"

namespace tedit {

/// What a keeper does for its child beside waiting for it.
struct keeper_options {
  /// The programs that the child may have started (base/program_line.hpp).
  std::vector<std::filesystem::path> programs = {};
  /// Whether the child has a folder for temporary files: 0700, gone with it.
  bool temporary_folder = false;
  std::uint64_t temporary_bytes = std::uint64_t{1} << 30;  ///< The most in it.
  /// Called in the keeper while the child is there, with a line to it (`send_descriptors`): what
  /// the child must not do itself. Another status than 0 ends both.
  std::function<int(int line)> prepare;
};

/// What the child has of its keeper.
struct keeper_gifts {
  unique_fd programs;  ///< For `start_programs_by`.
  unique_fd line;      ///< From `prepare`.
  std::filesystem::path temporary_folder;
};

/// Goes on in a child of this process, in a group of its own. This process stays as its keeper: it
/// has no other file open than stderr, ends as the child ends, by the same status or signal, and
/// the child is killed when it goes. Code in the child that kills its parent or its group so ends
/// itself and not what started this process. Call it before there are threads. Where there can be
/// no child it goes on without a keeper and its gifts.
[[nodiscard]] keeper_gifts continue_in_child(const keeper_options& options = {});

/// Removes the temporary folder of a keeper's child, when the keeper was killed and could not.
void remove_temporary_folder(pid_t keeper);

}  // namespace tedit
