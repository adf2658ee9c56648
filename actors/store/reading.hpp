// SPDX-License-Identifier: AGPL-3.0-or-later
// What is read from an open database of a document, whoever opened it.
#pragma once

#include <vector>

#include "actors/store/document.hpp"
#include "actors/store/seal.hpp"

namespace tedit::store {

/// For a statement that `find_page` takes.
inline constexpr const char* page_query = "SELECT size, data FROM page WHERE id = ?";

/// For a statement that `find_cad` takes.
inline constexpr const char* cad_query =
  "SELECT version, status, reason, deviation, facts, shape FROM cad WHERE version = ?";

/// As `document::read`. @param db of the present format.
[[nodiscard]] expected<contents> read_contents(sqlite3* db, const seal_keeper& seals);

/// What can be read of a document that may be damaged: rows whose hash is right.
struct sound_rows {
  contents rows;
  std::vector<error> damage;  ///< In the order in which it was found; empty: all is as it was.
};

/// As `read_contents`, but goes on after each damage. Errors: those of SQLite, when the database
/// itself cannot be read any further.
[[nodiscard]] expected<sound_rows> read_sound_rows(sqlite3* db, const seal_keeper& seals);

/// As `document::read_page`. @param by_id made of `page_query`.
[[nodiscard]] expected<page_ptr> find_page(const statement& by_id, const hash128& id);

/// As `document::read_cad`. @param by_number made of `cad_query`.
[[nodiscard]] expected<std::optional<cad_row>> find_cad(const statement& by_number,
                                                        std::uint32_t number);

}  // namespace tedit::store
