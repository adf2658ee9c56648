// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/schema.hpp"

#include "actors/store/seal.hpp"

namespace tedit::store {

namespace {

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

/// The B-rep of a version that came from CAD, packed with zstd, and what is known of its faces;
/// both empty where the edit was made on the mesh alone.
constexpr const char* cad_models =
  "CREATE TABLE cad(version INTEGER PRIMARY KEY NOT NULL REFERENCES version(number),"
  " status TEXT NOT NULL, reason TEXT NOT NULL, deviation REAL NOT NULL, facts TEXT NOT NULL,"
  " shape BLOB NOT NULL, hash TEXT NOT NULL DEFAULT '00000000000000000000000000000000');"
  "PRAGMA user_version = 3";

/// Whether all rows of a document of format 2 are as its seal has them.
expected<void> check_sealed(sqlite3* db) {
  seal_keeper keeper;
  if (auto ready = keeper.prepare_all(db, sealed_tables_of_format_2); !ready)
    return ready;
  const auto schema = keeper.schema_hash();
  if (!schema)
    return fail(schema.error());
  seal sum;
  sum.schema = *schema;
  for (const auto of : {table::version, table::head, table::log, table::annotation})
    if (auto read = keeper.read_all(
          of, sum, [](query&) {}, [](const error& e) { return expected<void>(fail(e)); });
        !read)
      return read;
  return keeper.compare(sum);
}

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

expected<std::int64_t> check_format(sqlite3* db, const std::filesystem::path& file) {
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
  if (*version > present_format)
    return fail(
      ec::storage_error, file.string() + " has format " + std::to_string(*version),
      "Open it with a newer TEdit; this one reads up to " + std::to_string(present_format));
  if (*version < 1 || (*version > 1) != (*seals == 1))
    return damaged(" has a wrong format number: it is damaged");
  if (*vacuum != 0)  // The next change would move pages that are not where this says.
    return damaged(" has a damaged header");
  return *version;
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
    .and_then([&] { return number_of(db, "PRAGMA user_version"); })
    .and_then([&](std::int64_t format) {
      return format > 1 ? check_sealed(db)
                        : execute(db, annotations).and_then([&] { return execute(db, hashes); });
    })
    .and_then([&] { return execute(db, cad_models); })
    .and_then([&] { return keeper.prepare_all(db); })
    .and_then([&] { return keeper.seal_everything(); })
    .and_then([&] { return execute(db, "COMMIT"); });
}

}  // namespace tedit::store
