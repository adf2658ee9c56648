// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace tedit::store {

/// Makes the folder when it is not there, makes sure that it can be written, and takes from others
/// what they may do with it and with the documents in it: the folder is 0700 then, files are 0600.
/// A folder that holds more than documents keeps its permissions. Drafts (`draft_of`) and rests of
/// erased documents that a kill left are removed. Returns sentences for the log.
/// Errors: `io_error` with the system's reason.
[[nodiscard]] expected<std::vector<std::string>> prepare_documents_folder(
  const std::filesystem::path& folder);

/// Where a document that comes from elsewhere lies until it is checked: no document's name.
[[nodiscard]] std::filesystem::path draft_of(const std::filesystem::path& file);

/// Whether files can be made and written in a folder, by making one; a folder that is not there
/// yet must be one that can be made. Changes nothing. Errors: `io_error` with the system's reason.
[[nodiscard]] expected<void> check_writable(const std::filesystem::path& folder);

}  // namespace tedit::store
