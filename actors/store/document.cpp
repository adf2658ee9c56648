// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/document.hpp"

#include <sqlite3.h>
#include <sys/file.h>
#include <zstd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <span>
#include <string_view>
#include <system_error>

namespace tedit::store {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t application_id = 0x54454454;  // "TEDT"
constexpr std::int64_t format = 1;                   // user_version
constexpr int zstd_level = 1;
constexpr int busy_timeout_ms = 5000;  // for a person who looks into the file with sqlite3
constexpr auto settings =
  "PRAGMA foreign_keys = ON; PRAGMA synchronous = FULL; PRAGMA trusted_schema = OFF;";
constexpr const char* schema =
  "BEGIN IMMEDIATE;"
  "CREATE TABLE page(id TEXT PRIMARY KEY NOT NULL, size INTEGER NOT NULL, data BLOB NOT NULL);"
  "CREATE TABLE version(number INTEGER PRIMARY KEY NOT NULL,"
  " parent INTEGER REFERENCES version(number), id TEXT NOT NULL, manifest BLOB NOT NULL,"
  " operation TEXT NOT NULL, load_cases TEXT NOT NULL, report TEXT NOT NULL,"
  " redo INTEGER REFERENCES version(number));"
  "CREATE TABLE head(one INTEGER PRIMARY KEY NOT NULL CHECK(one = 1),"
  " version INTEGER NOT NULL REFERENCES version(number));"
  "CREATE TABLE log(sequence INTEGER PRIMARY KEY AUTOINCREMENT, what TEXT, details TEXT);"
  "PRAGMA application_id = 0x54454454; PRAGMA user_version = 1; COMMIT";

/// Came later than the format: programs that do not know it leave it alone.
constexpr const char* later_tables =
  "CREATE TABLE IF NOT EXISTS annotation(version INTEGER PRIMARY KEY NOT NULL"
  " REFERENCES version(number), name TEXT NOT NULL, note TEXT NOT NULL)";

struct release {
  void operator()(sqlite3* db) const noexcept { sqlite3_close_v2(db); }
  void operator()(sqlite3_stmt* prepared) const noexcept { sqlite3_finalize(prepared); }
  void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};
struct roll_back {
  void operator()(sqlite3* db) const noexcept {
    if (sqlite3_get_autocommit(db) == 0)
      sqlite3_exec(db, "ROLLBACK", nullptr, nullptr, nullptr);
  }
};
using connection = std::unique_ptr<sqlite3, release>;
using statement = std::unique_ptr<sqlite3_stmt, release>;
using lock_file = std::unique_ptr<std::FILE, release>;       // closing it unlocks
using rollback_guard = std::unique_ptr<sqlite3, roll_back>;  // of what is not committed

tl::unexpected<error> damaged(std::string what) {
  return fail(ec::storage_error, std::move(what), "Restore the document from a backup");
}

/// The last failure on `db`. Only `open` lets other codes than `storage_error` out.
tl::unexpected<error> sql_failure(sqlite3* db) {
  const int code = sqlite3_errcode(db);
  const auto text = std::string("the document's database failed: ") + sqlite3_errmsg(db);
  if (code == SQLITE_CANTOPEN || code == SQLITE_READONLY)
    return fail(ec::io_error, text, "Check the permissions of the file and its folder");
  if (code == SQLITE_BUSY)
    return fail(ec::conflict, text, "Close the other program that uses the file");
  if (code == SQLITE_FULL)
    return fail(ec::storage_error, text, "Free some disk space and try again");
  if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB)
    return damaged(text);
  return fail(ec::storage_error, text);
}

expected<void> execute(sqlite3* db, const char* sql) {
  if (sqlite3_exec(db, sql, nullptr, nullptr, nullptr) != SQLITE_OK)
    return sql_failure(db);
  return {};
}

expected<void> prepare(statement& into, sqlite3* db, const char* sql) {
  sqlite3_stmt* made = nullptr;
  if (sqlite3_prepare_v3(db, sql, -1, SQLITE_PREPARE_PERSISTENT, &made, nullptr) != SQLITE_OK)
    return sql_failure(db);
  into.reset(made);
  return {};
}

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
  expected<bool> next() {
    const int code = bound_ ? sqlite3_step(handle_) : SQLITE_ERROR;
    if (code != SQLITE_ROW && code != SQLITE_DONE)
      return sql_failure(sqlite3_db_handle(handle_));
    return code == SQLITE_ROW;
  }

  /// Runs a statement that yields no rows.
  expected<void> run() {
    return next().map([](bool) {});
  }

  [[nodiscard]] std::int64_t number(int column) { return sqlite3_column_int64(handle_, column); }
  [[nodiscard]] std::string text(int column) {
    const auto* start = reinterpret_cast<const char*>(sqlite3_column_text(handle_, column));
    return start ? std::string(start, size(column)) : std::string();
  }
  [[nodiscard]] std::vector<std::byte> blob(int column) {
    const auto* start = static_cast<const std::byte*>(sqlite3_column_blob(handle_, column));
    return {start, start + (start ? size(column) : 0)};
  }

  /// A 32-bit number, none for NULL. A number out of range makes the query unsound.
  std::optional<std::uint32_t> u32(int column) {
    if (sqlite3_column_type(handle_, column) == SQLITE_NULL)
      return std::nullopt;
    const auto value = static_cast<std::uint32_t>(number(column));
    sound_ = sound_ && value == number(column);
    return value;
  }

  /// A hash as `to_hex` writes it. Anything else makes the query unsound.
  hash128 hash(int column) {
    const auto value = hash_from_hex(text(column));
    sound_ = sound_ && value;
    return value.value_or(hash128{});
  }

  /// Whether all values so far had the shape that was asked for.
  [[nodiscard]] bool sound() const noexcept { return sound_; }

private:
  std::size_t size(int column) { return std::size_t(sqlite3_column_bytes(handle_, column)); }

  int bind(std::int64_t value) { return sqlite3_bind_int64(handle_, ++index_, value); }
  int bind(const std::optional<std::uint32_t>& value) {
    return value ? bind(std::int64_t{*value}) : sqlite3_bind_null(handle_, ++index_);
  }
  int bind(const std::string& value, sqlite3_destructor_type lifetime = SQLITE_STATIC) {
    return sqlite3_bind_text64(handle_, ++index_, value.data(), value.size(), lifetime,
                               SQLITE_UTF8);
  }
  int bind(const hash128& value) { return bind(to_hex(value), SQLITE_TRANSIENT); }
  int bind(std::span<const std::byte> value) {
    if (value.empty())  // a null pointer would bind NULL
      return sqlite3_bind_zeroblob(handle_, ++index_, 0);
    return sqlite3_bind_blob64(handle_, ++index_, value.data(), value.size(), SQLITE_STATIC);
  }

  sqlite3_stmt* handle_;
  int index_ = 0;
  bool bound_;
  bool sound_ = true;
};

/// Locks a file for this process alone.
expected<void> take(lock_file& lock, const std::string& file) {
  lock.reset(std::fopen(file.c_str(), "ae"));  // "e": child programs do not inherit it
  if (lock && ::flock(::fileno(lock.get()), LOCK_EX | LOCK_NB) == 0)
    return {};
  if (lock && errno == EWOULDBLOCK)
    return fail(ec::conflict, "the document is open already; " + file + " is locked",
                "Close it in the other TEdit first");
  return fail(ec::io_error, "cannot lock " + file + ": " + std::generic_category().message(errno),
              "Choose a folder that exists and that you may write to");
}

/// Refuses what cannot be a database before anything is created beside it.
expected<void> check_header(const fs::path& file) {
  constexpr std::string_view magic = "SQLite format 3";
  std::error_code ignored;  // the type says enough
  const auto type = fs::status(file, ignored).type();
  if (type == fs::file_type::not_found)
    return {};
  std::ifstream in(file, std::ios::binary);
  if (type != fs::file_type::regular || !in)
    return fail(ec::io_error, file.string() + " is no file that can be read",
                "Check the name and the permissions");
  std::string start(magic.size(), ' ');
  in.read(start.data(), static_cast<std::streamsize>(start.size()));
  if (in.gcount() == 0 || start == magic)
    return {};
  return fail(ec::storage_error, file.string() + " is not a database",
              "Name a TEdit document or a new file; a mesh file is imported, not opened");
}

/// The one number that a query yields.
expected<std::int64_t> number_of(sqlite3* db, const char* sql) {
  statement made;
  if (auto prepared = prepare(made, db, sql); !prepared)
    return fail(prepared.error());
  query row(made);
  return row.next().map([&](bool) { return row.number(0); });
}

}  // namespace

/// Members are destroyed last to first: statements, connection, lock.
struct document::impl {
  expected<void> open(const fs::path& path);
  expected<void> connect();
  expected<void> check_format();
  expected<void> prepare_all();
  expected<void> put_page(const page_ptr& page);
  expected<void> put_rows(const change& c);
  expected<void> update(query&& with, std::uint32_t number);
  expected<bool> has(const hash128& id) { return query(find_page, id).next(); }

  fs::path file;
  lock_file lock;
  connection db;
  statement find_page, page_by_id, insert_page, insert_version, set_load_cases, set_redo, set_head;
  statement insert_annotation, insert_log, all_versions, head, all_log;
};

expected<void> document::impl::open(const fs::path& path) {
  std::error_code code;
  file = fs::weakly_canonical(fs::absolute(path, code), code);  // a link leads to the same lock
  if (code || file.empty())
    return fail(ec::io_error, "cannot open '" + path.string() + "': " + code.message());
  return check_header(file)
    .and_then([&] { return take(lock, file.string() + "-lock"); })
    .and_then([&] { return connect(); })
    .and_then([&] { return check_format(); })
    .and_then([&] { return execute(db.get(), "PRAGMA journal_mode = WAL"); })
    .and_then([&] { return execute(db.get(), later_tables); })
    .and_then([&] { return prepare_all(); });
}

expected<void> document::impl::connect() {
  constexpr int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
  sqlite3* made = nullptr;
  const int code = sqlite3_open_v2(file.c_str(), &made, flags, nullptr);
  db.reset(made);  // also after a failure: it holds the message
  if (code != SQLITE_OK)
    return sql_failure(made);
  if (sqlite3_db_readonly(made, "main") == 1)
    return fail(ec::io_error, file.string() + " may not be written", "Check its permissions");
  sqlite3_busy_timeout(made, busy_timeout_ms);
  return execute(made, settings);
}

/// Nothing is written before the file is known to be a document or empty.
expected<void> document::impl::check_format() {
  const auto application = number_of(db.get(), "PRAGMA application_id");
  const auto version = number_of(db.get(), "PRAGMA user_version");
  const auto tables = number_of(db.get(), "SELECT count(*) FROM sqlite_schema");
  for (const auto* value : {&application, &version, &tables})
    if (!*value)
      return fail(value->error());
  if (*application == 0 && *version == 0 && *tables == 0)
    return execute(db.get(), schema);
  if (*application != application_id)
    return fail(ec::storage_error, file.string() + " is a database, but no TEdit document",
                "Name another file");
  if (*version > format)
    return fail(ec::storage_error, file.string() + " has format " + std::to_string(*version),
                "Open it with a newer TEdit; this one reads up to " + std::to_string(format));
  return *version == format ? expected<void>() : damaged(file.string() + " has no format number");
}

expected<void> document::impl::prepare_all() {
  const std::pair<statement*, const char*> rows[] = {
    {&find_page, "SELECT 1 FROM page WHERE id = ?"},
    {&page_by_id, "SELECT size, data FROM page WHERE id = ?"},
    {&insert_page, "INSERT INTO page(id, size, data) VALUES(?, ?, ?)"},
    {&insert_version, "INSERT INTO version VALUES(?, ?, ?, ?, ?, ?, ?, ?)"},
    {&set_load_cases, "UPDATE version SET load_cases = ?2 WHERE number = ?1"},
    {&set_redo, "UPDATE version SET redo = ?2 WHERE number = ?1"},
    {&set_head, "INSERT OR REPLACE INTO head(one, version) VALUES(1, ?)"},
    {&insert_log, "INSERT INTO log(what, details) VALUES(?, ?)"},
    {&insert_annotation, "INSERT OR REPLACE INTO annotation VALUES(?, ?, ?)"},
    {&all_versions,  // columns as in `schema`
     "SELECT version.*, coalesce(a.name, ''), coalesce(a.note, '') FROM version"
     " LEFT JOIN annotation AS a ON a.version = version.number ORDER BY version.number"},
    {&head, "SELECT version FROM head"},
    {&all_log, "SELECT sequence, what, details FROM log ORDER BY sequence"},
  };
  for (const auto& [target, sql] : rows)
    if (auto made = prepare(*target, db.get(), sql); !made)
      return made;
  return {};
}

expected<void> document::impl::put_page(const page_ptr& page) {
  if (!page || page->bytes().size() > max_page_bytes)
    return fail(ec::storage_error, "a page to store is null or over 64 KiB");
  if (const auto stored = has(page->id()); !stored || *stored)
    return stored.map([](bool) {});
  const auto bytes = page->bytes();
  std::vector<std::byte> packed(ZSTD_compressBound(bytes.size()));
  const auto size =
    ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), zstd_level);
  if (ZSTD_isError(size))
    return fail(ec::storage_error, std::string("cannot compress: ") + ZSTD_getErrorName(size));
  packed.resize(size);
  return query(insert_page, page->id(), bytes.size(), packed).run();
}

/// Runs an update that must meet the version with this number.
expected<void> document::impl::update(query&& with, std::uint32_t number) {
  auto done = with.run();
  if (done && sqlite3_changes(db.get()) != 1)
    return fail(ec::storage_error, "version " + std::to_string(number) + " is not stored");
  return done;
}

expected<void> document::impl::put_rows(const change& c) {
  expected<void> done;
  for (auto i = c.new_pages.begin(); done && i != c.new_pages.end(); ++i)
    done = put_page(*i);
  if (const auto& v = c.new_version; done && v)
    done = query(insert_version, v->number, v->parent, v->id, v->manifest, v->operation,
                 v->load_cases, v->report, v->redo)
             .run();
  if (done && c.head)
    done = query(set_head, *c.head).run();
  for (auto i = c.load_cases.begin(); done && i != c.load_cases.end(); ++i)
    done = update(query(set_load_cases, i->first, i->second), i->first);
  for (auto i = c.redo.begin(); done && i != c.redo.end(); ++i)
    done = update(query(set_redo, i->first, i->second), i->first);
  for (auto i = c.annotations.begin(); done && i != c.annotations.end(); ++i)
    done = query(insert_annotation, i->number, i->name, i->note).run();
  if (done && !c.what.empty())
    done = query(insert_log, c.what, c.details).run();
  return done;
}

document::document() : impl_(std::make_unique<impl>()) {}
document::~document() = default;

expected<std::unique_ptr<document>> document::open(const fs::path& file) {
  std::unique_ptr<document> made(new document);
  if (auto opened = made->impl_->open(file); !opened)
    return fail(opened.error());
  return made;
}

expected<void> document::commit(const change& c) {
  const rollback_guard guard(impl_->db.get());
  return execute(guard.get(), "BEGIN IMMEDIATE")
    .and_then([&] { return impl_->put_rows(c); })
    .and_then([&] { return execute(guard.get(), "COMMIT"); })
    .map_error([](const error& e) {
      return error{ec::storage_error, e.message, e.remedy, e.where};
    });
}

expected<contents> document::read() const {
  contents all;
  expected<bool> more;
  query versions(impl_->all_versions);
  while ((more = versions.next()) && *more) {
    all.versions.push_back({versions.u32(0).value_or(0), versions.u32(1), versions.hash(2),
                            versions.blob(3), versions.text(4), versions.text(5), versions.text(6),
                            versions.u32(7), versions.text(8), versions.text(9)});
  }
  query head(impl_->head);
  if (more && (more = head.next()) && *more)
    all.head = head.u32(0);
  query log(impl_->all_log);
  while (more && (more = log.next()) && *more)
    all.log.push_back({static_cast<std::uint64_t>(log.number(0)), log.text(1), log.text(2)});
  if (!more)
    return fail(more.error());
  if (!versions.sound() || !head.sound())
    return damaged("the document has a version with impossible numbers");
  return all;
}

expected<page_ptr> document::read_page(const hash128& id) const {
  query row(impl_->page_by_id, id);
  const auto found = row.next();
  if (!found)
    return fail(found.error());
  if (!*found)
    return fail(ec::not_found, "page " + to_hex(id) + " is not in the document");
  const auto size = row.number(0);
  if (size < 0 || size > std::int64_t{max_page_bytes})
    return damaged("page " + to_hex(id) + " claims " + std::to_string(size) + " bytes");
  auto result = std::make_shared<page>(static_cast<std::size_t>(size));
  const auto packed = row.blob(1);
  const auto written = ZSTD_decompress(result->mutable_bytes().data(), result->bytes().size(),
                                       packed.data(), packed.size());
  if (ZSTD_isError(written) || written != result->bytes().size() || result->id() != id)
    return damaged("page " + to_hex(id) + " is damaged");
  return result;
}

bool document::has_page(const hash128& id) const {
  return impl_->has(id).value_or(false);
}

}  // namespace tedit::store
