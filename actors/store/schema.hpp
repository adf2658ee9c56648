// SPDX-License-Identifier: AGPL-3.0-or-later
// The tables of a document, and the step from the format of older programs to this one's.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "actors/store/sql.hpp"

namespace tedit::store {

/// What SQLite has in the file of a TEdit document, to tell it from other programs' databases.
inline constexpr std::int64_t application_id = 0x54454454;  // "TEDT"

/// The bytes of a new document's file. Errors: `storage_error`.
[[nodiscard]] expected<std::vector<std::byte>> blank_document();

/// Whether the database of `file` is a document of this format; false when it is one of an older
/// format that `upgrade` brings to this one. Nothing is written. Errors: `storage_error` when it is
/// no document, one of a newer format, or damaged.
[[nodiscard]] expected<bool> check_format(sqlite3* db, const std::filesystem::path& file);

/// Whether the database's own structure is sound: a damaged list of free pages, say, would let the
/// next change overwrite what is in use. Errors: `storage_error`. Cost: one pass over the file.
[[nodiscard]] expected<void> check_structure(sqlite3* db);

/// Brings a document of an older format to this one, in one transaction: older programs refuse it
/// from then on. Errors: those of `sql_failure`. Cost: one pass over all rows but the pages.
[[nodiscard]] expected<void> upgrade(sqlite3* db);

}  // namespace tedit::store
