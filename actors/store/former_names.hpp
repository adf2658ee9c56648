// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace tedit::store {

/// For so long a document is found by the names that it had, also after the server was started
/// anew: a client that did not hear of the new name comes back with the one before, and would begin
/// another document.
inline constexpr std::chrono::hours former_name_stays{24};

/// Notes that the document `before` will be found as `now`; durable. Called before the file gets
/// its name, so that no kill comes between: a note of a rename that was not done says nothing, as
/// the file is there under its own name. Errors: `io_error`. Cost: an fsync.
[[nodiscard]] expected<void> note_former_name(const std::filesystem::path& before,
                                              const std::filesystem::path& now);

/// Notes that the document is deleted: no name that it had leads to a later one of its name.
/// Errors: `io_error`. Cost: an fsync.
[[nodiscard]] expected<void> note_deleted_name(const std::filesystem::path& file);

/// Names without suffix that documents of a folder had within the last day, with those under which
/// they are now; oldest first. Only of names that no file has, leading to a file that is there.
/// What cannot be read is left out: names are a convenience. Cost: that of a small file.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> read_former_names(
  const std::filesystem::path& folder);

}  // namespace tedit::store
