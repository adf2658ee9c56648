// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/users.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>

#include <openssl/sha.h>

#include "base/hex.hpp"
#include "base/logging/logging.hpp"
#include "base/random_token.hpp"
#include "base/system_failure.hpp"
#include "base/unique_fd.hpp"

namespace tedit::gateway {

namespace fs = std::filesystem;

namespace {

constexpr int patience_ms = 5000;
constexpr std::size_t longest_user_name = 63;
constexpr std::int64_t file_kind = 0x54455553;  // "TEUS"
constexpr std::int64_t file_version = 1;

constexpr auto schema =
  "BEGIN IMMEDIATE;"
  "PRAGMA application_id = 1413829971;"
  "PRAGMA user_version = 1;"
  "CREATE TABLE IF NOT EXISTS users (name TEXT PRIMARY KEY, role TEXT NOT NULL) STRICT;"
  // A number is never used again: connections are known by it.
  "CREATE TABLE IF NOT EXISTS tokens (number INTEGER PRIMARY KEY AUTOINCREMENT,"
  " user TEXT NOT NULL REFERENCES users (name) ON DELETE CASCADE,"
  " hash TEXT NOT NULL UNIQUE, made INTEGER NOT NULL, until INTEGER) STRICT;"
  "COMMIT;";

constexpr std::int64_t never = 0;

std::optional<std::int64_t> until_of(std::int64_t stored) {
  return stored == never ? std::nullopt : std::optional(stored);
}

/// One pass suffices: nobody tries 2^256 tokens, however quick one try is.
std::string hash_of(const std::string& token) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(reinterpret_cast<const unsigned char*>(token.data()), token.size(), digest.data());
  return to_hex(digest);
}

tl::unexpected<error> failure_of(sqlite3* db, const fs::path& file) {
  const int code = sqlite3_errcode(db);
  const auto text =
    "the users in " + file.string() + " cannot be read or changed: " + sqlite3_errmsg(db);
  if (code == SQLITE_BUSY)
    return fail(ec::conflict, text, "Another program changes them: try again");
  if (code == SQLITE_NOTADB)
    return fail(ec::bad_input, text, "Name the file that \"tedit users\" made");
  if (code == SQLITE_CANTOPEN || code == SQLITE_IOERR)
    return system_failure(text, sqlite3_system_errno(db));
  return fail(ec::storage_error, text, "Check the file, or put a copy of it in its place");
}

/// Errors: `io_error`; `invalid_argument` when others may read the file.
expected<void> check_private(const fs::path& file) {
  struct stat about {};
  if (::stat(file.c_str(), &about) != 0)
    return system_failure("cannot read " + file.string(), errno);
  if ((about.st_mode & 077) != 0)
    return fail(ec::invalid_argument, "others may read or change the users in " + file.string(),
                "chmod 600 " + file.string());
  return {};
}

/// Opens a file that is there. Errors: those of `user_file::open`.
expected<store::connection> open_database(const fs::path& file, int wait_ms) {
  if (auto ok = check_private(file); !ok)
    return fail(ok.error());
  sqlite3* raw = nullptr;
  const int code = sqlite3_open_v2(file.c_str(), &raw, SQLITE_OPEN_READWRITE, nullptr);
  store::connection db(raw);
  if (code != SQLITE_OK)
    return failure_of(db.get(), file);
  sqlite3_busy_timeout(db.get(), wait_ms);
  if (sqlite3_exec(db.get(), "PRAGMA foreign_keys = ON", nullptr, nullptr, nullptr) != SQLITE_OK)
    return failure_of(db.get(), file);
  return db;
}

/// Errors: `bad_input` for another kind of file.
expected<void> check_kind(sqlite3* db, const fs::path& file) {
  const auto kind = store::number_of(db, "PRAGMA application_id");
  const auto version = store::number_of(db, "PRAGMA user_version");
  if (!kind || !version)
    return failure_of(db, file);
  if (*kind != file_kind)
    return fail(ec::bad_input, file.string() + " is no file of users",
                "Name the file that \"tedit users\" made");
  if (*version != file_version)
    return fail(ec::unsupported_format,
                file.string() + " is of another version of TEdit (" + std::to_string(*version) +
                  ", here " + std::to_string(file_version) + ")",
                "Use the release that made it");
  return {};
}

bool is_name(const std::string& text) {
  const auto fits = [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '-' || c == '_' || c == '@';
  };
  return !text.empty() && text.size() <= longest_user_name && std::ranges::all_of(text, fits);
}

tl::unexpected<error> no_user(const std::string& name) {
  return fail(ec::not_found, "there is no user " + name, "\"tedit users list\" has all of them");
}

}  // namespace

std::string_view name_of(access_role role) {
  return std::ranges::find(access_roles, role, &access_role_row::value)->name;
}

std::optional<access_role> access_role_named(std::string_view name) {
  const auto found = std::ranges::find(access_roles, name, &access_role_row::name);
  return found == access_roles.end() ? std::nullopt : std::optional(found->value);
}

std::int64_t seconds_now() {
  using namespace std::chrono;
  return duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
}

// -- user_file -----------------------------------------------------------------------------------

expected<user_file> user_file::open(const fs::path& file) {
  std::error_code code;
  if (!fs::exists(file.parent_path(), code)) {  // Made for its owner alone.
    fs::create_directories(file.parent_path(), code);
    fs::permissions(file.parent_path(), fs::perms::owner_all, code);
  }
  const unique_fd made(::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
  if (!made)
    return system_failure("cannot make " + file.string(), errno);
  auto db = open_database(file, patience_ms);
  if (!db)
    return fail(db.error());
  if (fs::file_size(file, code) == 0 &&
      sqlite3_exec(db->get(), schema, nullptr, nullptr, nullptr) != SQLITE_OK)
    return failure_of(db->get(), file);
  if (auto ok = check_kind(db->get(), file); !ok)
    return fail(ok.error());
  return user_file(file, *std::move(db));
}

tl::unexpected<error> user_file::failure() const {
  return failure_of(db_.get(), file_);
}

expected<void> user_file::begin() {
  if (sqlite3_exec(db_.get(), "BEGIN IMMEDIATE", nullptr, nullptr, nullptr) != SQLITE_OK)
    return failure();
  return {};
}

expected<void> user_file::commit() {
  if (sqlite3_exec(db_.get(), "COMMIT", nullptr, nullptr, nullptr) != SQLITE_OK)
    return failure();
  return {};
}

/// Runs a statement; how many rows it changed.
template <class... Values>
expected<int> user_file::change(const char* sql, const Values&... values) {
  const auto made = store::prepare(db_.get(), sql);
  if (!made)
    return failure();
  store::query use(*made, values...);
  if (!use.run())
    return failure();
  return sqlite3_changes(db_.get());
}

expected<new_token> user_file::insert_token(const std::string& name,
                                            std::optional<std::int64_t> until) {
  auto text = make_token();
  if (!text)
    return fail(text.error());
  const auto hash = hash_of(*text);
  const auto done = change("INSERT INTO tokens (user, hash, made, until) VALUES (?, ?, ?, ?)", name,
                           hash, seconds_now(), until.value_or(never));
  if (!done)
    return fail(done.error());
  return new_token{*std::move(text), sqlite3_last_insert_rowid(db_.get())};
}

expected<new_token> user_file::add(const std::string& name, access_role role,
                                   std::optional<std::int64_t> until) {
  if (!is_name(name))
    return fail(ec::invalid_argument, "\"" + name + "\" cannot be a user's name",
                "Take up to " + std::to_string(longest_user_name) +
                  " letters, digits, \".\", \"-\", \"_\" and \"@\"");
  if (auto ok = begin(); !ok)
    return fail(ok.error());
  const store::rollback_guard undo(db_.get());
  const auto added = change("INSERT OR IGNORE INTO users (name, role) VALUES (?, ?)", name,
                            std::string(name_of(role)));
  if (!added)
    return fail(added.error());
  if (*added == 0)
    return fail(ec::conflict, "there is a user " + name + " already",
                "Give that one a token (tedit users token) or another role (tedit users role)");
  auto token = insert_token(name, until);
  if (!token)
    return token;
  if (auto ok = commit(); !ok)
    return fail(ok.error());
  return token;
}

expected<new_token> user_file::add_token(const std::string& name,
                                         std::optional<std::int64_t> until) {
  if (auto ok = begin(); !ok)
    return fail(ok.error());
  const store::rollback_guard undo(db_.get());
  const auto there = change("UPDATE users SET role = role WHERE name = ?", name);
  if (!there)
    return fail(there.error());
  if (*there == 0)
    return no_user(name);
  auto token = insert_token(name, until);
  if (!token)
    return token;
  if (auto ok = commit(); !ok)
    return fail(ok.error());
  return token;
}

expected<void> user_file::set_role(const std::string& name, access_role role) {
  const auto done =
    change("UPDATE users SET role = ? WHERE name = ?", std::string(name_of(role)), name);
  if (!done)
    return fail(done.error());
  if (*done == 0)
    return no_user(name);
  return {};
}

expected<void> user_file::withdraw(std::int64_t number) {
  const auto done = change("DELETE FROM tokens WHERE number = ?", number);
  if (!done)
    return fail(done.error());
  if (*done == 0)
    return fail(ec::not_found, "there is no token " + std::to_string(number),
                "\"tedit users list\" has the numbers of all of them");
  return {};
}

expected<void> user_file::remove(const std::string& name) {
  const auto done = change("DELETE FROM users WHERE name = ?", name);
  if (!done)
    return fail(done.error());
  if (*done == 0)
    return no_user(name);
  return {};
}

expected<std::vector<listed_user>> user_file::list() {
  const auto made = store::prepare(db_.get(),
                                   "SELECT users.name, role, number, made, until FROM users LEFT "
                                   "JOIN tokens ON user = users.name ORDER BY users.name, number");
  if (!made)
    return failure();
  store::query row(*made);
  std::vector<listed_user> all;
  for (;;) {
    const auto more = row.next();
    if (!more)
      return failure();
    if (!*more)
      return all;
    const auto role = access_role_named(row.text(1));
    if (!role)
      return fail(ec::storage_error, "the role \"" + row.text(1) + "\" is none",
                  "Give another: tedit users role");
    if (all.empty() || all.back().name != row.text(0))
      all.push_back({row.text(0), *role, {}});
    if (row.number(2) != 0)
      all.back().tokens.push_back({row.number(2), row.number(3), until_of(row.number(4))});
  }
}

// -- user_book -----------------------------------------------------------------------------------

expected<std::shared_ptr<user_book>> user_book::open(fs::path file) {
  std::shared_ptr<user_book> made(new user_book(std::move(file)));
  if (auto ok = made->look(); !ok)
    return fail(ok.error());
  return made;
}

/// A file that was exchanged is opened anew; of one that was changed SQLite says so.
expected<void> user_book::look() {
  const auto now = stamp_of(file_);
  if (now == file_stamp{}) {
    db_.reset();
    grants_.clear();
    return {};
  }
  const bool exchanged = !db_ || now[2] != seen_[2];
  if (exchanged) {
    auto db = open_database(file_, 0);
    if (!db)
      return fail(db.error());
    if (auto ok = check_kind(db->get(), file_); !ok)
      return ok;
    db_ = *std::move(db);
    seen_ = now;
    version_ = -1;
  }
  const auto version = store::number_of(db_.get(), "PRAGMA data_version");
  if (!version)
    return failure_of(db_.get(), file_);
  if (*version == version_)
    return {};
  if (auto ok = read(); !ok)
    return ok;
  version_ = *version;
  return {};
}

/// A change since the version was asked for is read again at the next look.
expected<void> user_book::read() {
  const auto made = store::prepare(
    db_.get(), "SELECT hash, user, role, number, until FROM tokens JOIN users ON name = user");
  if (!made)
    return failure_of(db_.get(), file_);
  store::query row(*made);
  std::map<hash_text, grant> found;
  for (;;) {
    const auto more = row.next();
    if (!more)
      return failure_of(db_.get(), file_);
    if (!*more)
      break;
    if (const auto role = access_role_named(row.text(2)))
      found[row.text(0)] = {row.text(1), *role, row.number(3), until_of(row.number(4))};
  }
  grants_ = std::move(found);
  return {};
}

void user_book::look_and_say() {
  const auto ok = look();
  if (!ok && !std::exchange(said_, true))
    logging::error("users: those that were read before hold: {}", render(ok.error()));
  if (ok)
    said_ = false;
}

std::optional<grant> user_book::find(const std::string& token) {
  const auto hash = hash_of(token);
  const std::lock_guard lock(mutex_);
  look_and_say();
  const auto found = grants_.find(hash);
  return found == grants_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<grant> user_book::find(std::int64_t number) {
  const std::lock_guard lock(mutex_);
  look_and_say();
  const auto found =
    std::ranges::find_if(grants_, [&](const auto& row) { return row.second.token == number; });
  return found == grants_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace tedit::gateway
