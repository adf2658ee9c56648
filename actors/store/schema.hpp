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

/// The format of new documents.
inline constexpr std::int64_t present_format = 3;

/// The format of the document in `file`: `present_format`, or an older one that `upgrade` brings to
/// it. Nothing is written. Errors: `storage_error` when it is no document, one of a newer format,
/// or damaged.
[[nodiscard]] expected<std::int64_t> check_format(sqlite3* db, const std::filesystem::path& file);

/// Whether the database's own structure is sound: a damaged list of free pages, say, would let the
/// next change overwrite what is in use. Errors: `storage_error`. Cost: one pass over the file.
[[nodiscard]] expected<void> check_structure(sqlite3* db);

/// Brings a document of an older format to this one, in one transaction: older programs refuse it
/// from then on. Errors: those of `sql_failure`; `storage_error` when a row of one that has a seal
/// is damaged. Cost: one or two passes over all rows but the pages.
[[nodiscard]] expected<void> upgrade(sqlite3* db);

}  // namespace tedit::store
