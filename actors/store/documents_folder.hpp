// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace tedit::store {

/// Makes the folder when it is not there, makes sure that it can be written, and takes from others
/// what they may do with it and with the documents in it: the folder is 0700 then, files are 0600.
/// A folder that holds more than documents keeps its permissions. Returns sentences for the log.
/// Errors: `io_error` with the system's reason.
[[nodiscard]] expected<std::vector<std::string>> prepare_documents_folder(
  const std::filesystem::path& folder);

/// Whether files can be made and written in a folder, by making one; a folder that is not there
/// yet must be one that can be made. Changes nothing. Errors: `io_error` with the system's reason.
[[nodiscard]] expected<void> check_writable(const std::filesystem::path& folder);

}  // namespace tedit::store
