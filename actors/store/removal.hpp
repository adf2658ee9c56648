// SPDX-License-Identifier: AGPL-3.0-or-later
// What `document::remove` does with the open database.
#pragma once

#include "actors/store/document.hpp"
#include "actors/store/seal.hpp"

namespace tedit::store {

/// Takes out what is to go, in one transaction that is only ended when the rest was read whole;
/// returns how many pages went. Errors: as `document::remove`; then nothing was taken out.
[[nodiscard]] expected<std::int64_t> remove_rows(sqlite3* db, const seal_keeper& seals,
                                                 const removal& what);

/// Writes the database anew without its free pages, and all of it into the one file. Errors: those
/// of `sql_failure`; then it is as it was. Cost: the document is written twice.
[[nodiscard]] expected<void> squeeze(sqlite3* db);

}  // namespace tedit::store
