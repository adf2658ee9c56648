// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/schema.hpp"

#include "actors/store/seal.hpp"

namespace tedit::store {

namespace {

constexpr std::int64_t format = 2;  // user_version

/// What the first format had; annotations came later, without a number of their own.
constexpr const char* first_tables =
  "CREATE TABLE page(id TEXT PRIMARY KEY NOT NULL, size INTEGER NOT NULL, data BLOB NOT NULL);"
  "CREATE TABLE version(number INTEGER PRIMARY KEY NOT NULL,"
  " parent INTEGER REFERENCES version(number), id TEXT NOT NULL, manifest BLOB NOT NULL,"
  " operation TEXT NOT NULL, load_cases TEXT NOT NULL, report TEXT NOT NULL,"
  " redo INTEGER REFERENCES version(number));"
  "CREATE TABLE head(one INTEGER PRIMARY KEY NOT NULL CHECK(one = 1),"
  " version INTEGER NOT NULL REFERENCES version(number));"
  "CREATE TABLE log(sequence INTEGER PRIMARY KEY AUTOINCREMENT, what TEXT, details TEXT);"
  "PRAGMA application_id = 0x54454454";
constexpr const char* annotations =
  "CREATE TABLE IF NOT EXISTS annotation(version INTEGER PRIMARY KEY NOT NULL"
  " REFERENCES version(number), name TEXT NOT NULL, note TEXT NOT NULL)";

/// A hash takes its place in a row without moving the rest: it is as long as this.
constexpr const char* hashes =
  "ALTER TABLE version ADD COLUMN hash TEXT NOT NULL DEFAULT '00000000000000000000000000000000';"
  "ALTER TABLE head ADD COLUMN hash TEXT NOT NULL DEFAULT '00000000000000000000000000000000';"
  "ALTER TABLE log ADD COLUMN hash TEXT NOT NULL DEFAULT '00000000000000000000000000000000';"
  "ALTER TABLE annotation ADD COLUMN hash TEXT NOT NULL"
  " DEFAULT '00000000000000000000000000000000';"
  "CREATE TABLE seal(one INTEGER PRIMARY KEY NOT NULL CHECK(one = 1), rows INTEGER NOT NULL,"
  " sum TEXT NOT NULL, schema TEXT NOT NULL);"
  "PRAGMA user_version = 2";

}  // namespace

expected<std::vector<std::byte>> blank_document() {
  sqlite3* made = nullptr;
  const int code = sqlite3_open_v2(":memory:", &made, SQLITE_OPEN_READWRITE, nullptr);
  const connection db(made);
  if (code != SQLITE_OK)
    return sql_failure(made);
  if (auto done = execute(made, first_tables).and_then([&] { return upgrade(made); }); !done)
    return fail(done.error());
  return image_of(made);
}

expected<bool> check_format(sqlite3* db, const std::filesystem::path& file) {
  const auto damaged = [&](const char* what) {
    return fail(ec::storage_error, file.string() + what, "Restore the document from a backup");
  };
  const auto application = number_of(db, "PRAGMA application_id");
  const auto version = number_of(db, "PRAGMA user_version");
  const auto vacuum = number_of(db, "PRAGMA auto_vacuum");
  const auto seals = number_of(db, "SELECT count(*) FROM sqlite_schema WHERE name = 'seal'");
  for (const auto* value : {&application, &version, &vacuum, &seals})
    if (!*value)
      return fail(value->error());
  if (*application != application_id)
    return fail(ec::storage_error, file.string() + " is a database, but no TEdit document",
                "Name another file");
  if (*version > format)
    return fail(ec::storage_error, file.string() + " has format " + std::to_string(*version),
                "Open it with a newer TEdit; this one reads up to " + std::to_string(format));
  if (*version < 1 || (*version == format) != (*seals == 1))
    return damaged(" has a wrong format number: it is damaged");
  if (*vacuum != 0)  // The next change would move pages that are not where this says.
    return damaged(" has a damaged header");
  return *version == format;
}

expected<void> check_structure(sqlite3* db) {
  const auto made = prepare(db, "PRAGMA quick_check(1)");
  if (!made)
    return fail(made.error());
  query row(*made);
  if (const auto found = row.next(); !found)
    return fail(found.error());
  const auto verdict = row.text(0);
  if (verdict == "ok")
    return {};
  return fail(ec::storage_error, "the document is damaged: " + verdict,
              "Restore the document from a backup");
}

expected<void> upgrade(sqlite3* db) {
  const rollback_guard guard(db);
  seal_keeper keeper;
  return execute(db, "BEGIN IMMEDIATE")
    .and_then([&] { return execute(db, annotations); })
    .and_then([&] { return execute(db, hashes); })
    .and_then([&] { return keeper.prepare_all(db); })
    .and_then([&] { return keeper.seal_everything(); })
    .and_then([&] { return execute(db, "COMMIT"); });
}

}  // namespace tedit::store
