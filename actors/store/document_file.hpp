// SPDX-License-Identifier: AGPL-3.0-or-later
// A document's file before there is a database in it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "base/error.hpp"

namespace tedit::store {

/// Whether there is a file that begins like a database, or will once its log is brought into it;
/// false when there is none. Errors:
/// `storage_error` for an empty file and one that is no database; `io_error` when the system
/// refuses to read it.
[[nodiscard]] expected<bool> has_database(const std::filesystem::path& file);

/// Why a document could not be opened, with its file as the place, and how many bytes are missing
/// where it is cut off.
[[nodiscard]] error with_file(error why, const std::filesystem::path& file);

/// Whether a document that has no file yet can have it here. Errors: `conflict` when the log of
/// another document lies where its own will be.
[[nodiscard]] expected<void> check_place(const std::filesystem::path& file);

/// All of them; else `errno` says why not.
[[nodiscard]] bool write_all(int handle, std::span<const std::byte> bytes);

/// Makes `file`, readable by its owner alone, with these bytes. It is there with all of them or not
/// at all, also after a power failure. @pre there is no such file, and nobody else makes it.
/// Errors: `io_error`; those of `check_place`.
[[nodiscard]] expected<void> create_file(const std::filesystem::path& file,
                                         std::span<const std::byte> bytes);

/// Gives a file another name in its folder, never instead of one that is there. It has one of the
/// two names at any moment, also after a kill, and this one after a power failure once it returns.
/// @pre nothing of it lies beside it: its database is closed.
/// Errors: those of `check_place`; `conflict` when something has the name; `io_error`.
[[nodiscard]] expected<void> rename_file(const std::filesystem::path& from,
                                         const std::filesystem::path& to);

}  // namespace tedit::store
