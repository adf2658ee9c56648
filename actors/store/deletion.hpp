// SPDX-License-Identifier: AGPL-3.0-or-later
// Documents that go for good, with what lies beside their files.
#pragma once

#include <filesystem>

#include "base/error.hpp"

namespace tedit::store {

/// Takes a document's file away, and its log. It is gone when this returns, also after a power
/// failure; a kill at any moment leaves it whole, or hidden under a name that `finish_erasing`
/// knows. Names that it had lead to no later document of its name. Needs no room on the disk.
/// @pre its lock is held and its database closed. Errors: `io_error`; then it is as it was.
[[nodiscard]] expected<void> erase_files(const std::filesystem::path& file);

/// The same for a document that nobody has open, sound or not. Errors: `not_found`; `conflict` when
/// somebody has it open, here or in another program, and when it is a link; `storage_error` when
/// the file is no TEdit document; `io_error`. Then it is as it was.
[[nodiscard]] expected<void> delete_document(const std::filesystem::path& file);

/// What a rename or a deletion is told of a document that lies elsewhere.
[[nodiscard]] error linked_document(const std::filesystem::path& target);

/// Whether a file of this name is what a kill left of a document that was being erased.
[[nodiscard]] bool is_erased(const std::filesystem::path& file);

/// Takes the rest of such a document away. @pre nobody uses the folder.
void finish_erasing(const std::filesystem::path& hidden);

}  // namespace tedit::store
