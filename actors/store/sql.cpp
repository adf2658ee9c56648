// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/sql.hpp"

#include "base/system_failure.hpp"

namespace tedit::store {

tl::unexpected<error> sql_failure(sqlite3* db) {
  const int code = sqlite3_errcode(db);
  const auto text = std::string("the document's database failed: ") + sqlite3_errmsg(db);
  if (code == SQLITE_BUSY)
    return fail(ec::conflict, text, "Close the other program that uses the file");
  if (code == SQLITE_FULL)
    return fail(ec::storage_error, text, "The disk is full: free some space and try again");
  // An error of SQL itself: tables that it names are not those of the file.
  if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB || code == SQLITE_ERROR)
    return fail(ec::storage_error, text, "Restore the document from a backup");
  if (code == SQLITE_READONLY)
    return fail(ec::io_error, text,
                "Check the permissions and the owner of the file and its folder");
  // SQLite keeps the system's reason of these two only.
  if (code == SQLITE_CANTOPEN || code == SQLITE_IOERR)
    return system_failure(text, sqlite3_system_errno(db));
  return fail(ec::storage_error, text);
}

expected<void> execute(sqlite3* db, const char* sql) {
  if (sqlite3_exec(db, sql, nullptr, nullptr, nullptr) != SQLITE_OK)
    return sql_failure(db);
  return {};
}

expected<statement> prepare(sqlite3* db, const std::string& sql) {
  sqlite3_stmt* made = nullptr;
  if (sqlite3_prepare_v3(db, sql.c_str(), -1, SQLITE_PREPARE_PERSISTENT, &made, nullptr) !=
      SQLITE_OK)
    return sql_failure(db);
  return statement(made);
}

expected<std::int64_t> number_of(sqlite3* db, const char* sql) {
  const auto made = prepare(db, sql);
  if (!made)
    return fail(made.error());
  query row(*made);
  return row.next().map([&](bool) { return row.number(0); });
}

expected<std::vector<std::byte>> image_of(sqlite3* db) {
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, decltype(&sqlite3_free)> image(
    sqlite3_serialize(db, "main", &size, 0), &sqlite3_free);
  if (!image)
    return fail(ec::storage_error, "there is no memory for the document, or it cannot be read",
                "Close other documents and try again");
  const auto* start = reinterpret_cast<const std::byte*>(image.get());
  return std::vector<std::byte>(start, start + size);
}

// -- query -----------------------------------------------------------------------------------

expected<bool> query::next() {
  const int code = bound_ ? sqlite3_step(handle_) : SQLITE_ERROR;
  if (code != SQLITE_ROW && code != SQLITE_DONE)
    return sql_failure(sqlite3_db_handle(handle_));
  return code == SQLITE_ROW;
}

expected<void> query::run() {
  return next().map([](bool) {});
}

std::string query::text(int column) {
  const auto* start = reinterpret_cast<const char*>(sqlite3_column_text(handle_, column));
  return start ? std::string(start, size(column)) : std::string();
}

std::vector<std::byte> query::blob(int column) {
  const auto* start = static_cast<const std::byte*>(sqlite3_column_blob(handle_, column));
  return {start, start + (start ? size(column) : 0)};
}

std::optional<std::uint32_t> query::u32(int column) {
  if (sqlite3_column_type(handle_, column) == SQLITE_NULL)
    return std::nullopt;
  const auto value = static_cast<std::uint32_t>(number(column));
  sound_ = sound_ && value == number(column);
  return value;
}

hash128 query::hash(int column) {
  const auto value = hash_from_hex(text(column));
  sound_ = sound_ && value;
  return value.value_or(hash128{});
}

int query::bind(const std::string& value, sqlite3_destructor_type lifetime) {
  return sqlite3_bind_text64(handle_, ++index_, value.data(), value.size(), lifetime, SQLITE_UTF8);
}

int query::bind(std::span<const std::byte> value) {
  if (value.empty())  // a null pointer would bind NULL
    return sqlite3_bind_zeroblob(handle_, ++index_, 0);
  return sqlite3_bind_blob64(handle_, ++index_, value.data(), value.size(), SQLITE_STATIC);
}

}  // namespace tedit::store
