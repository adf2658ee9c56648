// SPDX-License-Identifier: AGPL-3.0-or-later
// A document's copy beside it, from an open database.
#pragma once

#include <filesystem>

#include "actors/store/sql.hpp"

namespace tedit::store {

/// Writes the database, as it is at this moment, to a file that is not there, readable by its owner
/// alone. It is there whole or not at all, also after a power failure; what a kill leaves is a
/// draft (`draft_of`). Within a `cancel_scope` it throws as `check_cancelled` does, and leaves
/// nothing. Errors: those of `check_place`; `conflict` when something has the name;
/// `io_error`, `storage_error`. Cost: its size; needs no memory for it.
[[nodiscard]] expected<void> copy_database(sqlite3* db, const std::filesystem::path& file);

}  // namespace tedit::store
