// SPDX-License-Identifier: AGPL-3.0-or-later
// A thin layer over SQLite's C interface: owners, statements, and its failures as errors.
#pragma once

#include <sqlite3.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/hash.hpp"

namespace tedit::store {

struct close_database {
  void operator()(sqlite3* db) const noexcept { sqlite3_close_v2(db); }
};
struct finalize_statement {
  void operator()(sqlite3_stmt* prepared) const noexcept { sqlite3_finalize(prepared); }
};
struct roll_back {
  void operator()(sqlite3* db) const noexcept {
    if (sqlite3_get_autocommit(db) == 0)
      sqlite3_exec(db, "ROLLBACK", nullptr, nullptr, nullptr);
  }
};
using connection = std::unique_ptr<sqlite3, close_database>;
using statement = std::unique_ptr<sqlite3_stmt, finalize_statement>;
using rollback_guard = std::unique_ptr<sqlite3, roll_back>;  ///< Of what is not committed.

/// The last failure on `db` as an error that names its true reason.
[[nodiscard]] tl::unexpected<error> sql_failure(sqlite3* db);

/// Errors: those of `sql_failure`.
[[nodiscard]] expected<void> execute(sqlite3* db, const char* sql);

/// Errors: those of `sql_failure`.
[[nodiscard]] expected<statement> prepare(sqlite3* db, const std::string& sql);

/// The one number that a query yields. Errors: those of `sql_failure`.
[[nodiscard]] expected<std::int64_t> number_of(sqlite3* db, const char* sql);

/// The database as one file would hold it, with what is in its log. Errors: `storage_error` when
/// there is no memory for it or it cannot be read. Cost: twice its size in memory.
[[nodiscard]] expected<std::vector<std::byte>> image_of(sqlite3* db);

/// One use of a statement: binds the values in order and resets the statement in the end. Texts and
/// blobs are not copied, so they must outlive the use.
class query {
public:
  template <class... Values>
  explicit query(const statement& of, const Values&... values)
      : handle_(of.get()), bound_((... && (bind(values) == SQLITE_OK))) {}
  ~query() {
    sqlite3_reset(handle_);
    sqlite3_clear_bindings(handle_);
  }
  query(const query&) = delete;
  query& operator=(const query&) = delete;

  /// Goes to the next row; false when there is none.
  expected<bool> next();

  /// Runs a statement that yields no rows.
  expected<void> run();

  [[nodiscard]] std::int64_t number(int column) { return sqlite3_column_int64(handle_, column); }
  [[nodiscard]] double real(int column) { return sqlite3_column_double(handle_, column); }
  [[nodiscard]] std::string text(int column);
  [[nodiscard]] std::vector<std::byte> blob(int column);

  /// A 32-bit number, none for NULL. A number out of range makes the query unsound.
  std::optional<std::uint32_t> u32(int column);

  /// A hash as `to_hex` writes it. Anything else makes the query unsound.
  hash128 hash(int column);

  /// Whether all values so far had the shape that was asked for.
  [[nodiscard]] bool sound() const noexcept { return sound_; }

  /// The row that the query is at.
  [[nodiscard]] sqlite3_stmt* row() const noexcept { return handle_; }

private:
  std::size_t size(int column) { return std::size_t(sqlite3_column_bytes(handle_, column)); }

  int bind(std::same_as<double> auto value) {
    return sqlite3_bind_double(handle_, ++index_, value);
  }
  int bind(std::int64_t value) { return sqlite3_bind_int64(handle_, ++index_, value); }
  int bind(const std::optional<std::uint32_t>& value) {
    return value ? bind(std::int64_t{*value}) : sqlite3_bind_null(handle_, ++index_);
  }
  int bind(const std::string& value, sqlite3_destructor_type lifetime = SQLITE_STATIC);
  int bind(const hash128& value) { return bind(to_hex(value), SQLITE_TRANSIENT); }
  int bind(std::span<const std::byte> value);

  sqlite3_stmt* handle_;
  int index_ = 0;
  bool bound_;
  bool sound_ = true;
};

}  // namespace tedit::store
