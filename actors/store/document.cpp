// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/document.hpp"

#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>

#include "actors/store/copying.hpp"
#include "actors/store/deletion.hpp"
#include "actors/store/document_file.hpp"
#include "actors/store/document_lock.hpp"
#include "actors/store/former_names.hpp"
#include "actors/store/reading.hpp"
#include "actors/store/removal.hpp"
#include "actors/store/schema.hpp"
#include "actors/store/seal.hpp"
#include "base/system_failure.hpp"

namespace tedit::store {

namespace {

namespace fs = std::filesystem;

constexpr int zstd_level = 1;
constexpr int busy_timeout_ms = 5000;  // for a person who looks into the file with sqlite3
constexpr auto settings =
  "PRAGMA foreign_keys = ON; PRAGMA synchronous = FULL; PRAGMA trusted_schema = OFF;";

struct close_file {
  void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};
using lock_file = std::unique_ptr<std::FILE, close_file>;  // closing it unlocks

std::atomic<int> connections{0};

tl::unexpected<error> damaged(std::string what) {
  return fail(ec::storage_error, std::move(what), "Restore the document from a backup");
}

/// Programs of the older format lock FILE-lock for as long as they have the document open. It goes
/// with the format: they refuse the new one.
expected<void> upgrade_alone(sqlite3* db, const std::string& file) {
  const auto path = file + "-lock";
  const lock_file lock(std::fopen(path.c_str(), "ae"));  // "e": child programs do not inherit it
  if (lock && ::flock(::fileno(lock.get()), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    return fail(ec::conflict, file + " is open already in an older program",
                "Close it in the other TEdit first");
  if (!lock)
    return system_failure("cannot lock " + path, errno);
  auto done = upgrade(db);
  if (done)
    ::unlink(path.c_str());
  return done;
}

/// Packed with zstd.
expected<std::vector<std::byte>> pack(std::span<const std::byte> bytes) {
  std::vector<std::byte> packed(ZSTD_compressBound(bytes.size()));
  const auto size =
    ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), zstd_level);
  if (ZSTD_isError(size))
    return fail(ec::storage_error, std::string("cannot compress: ") + ZSTD_getErrorName(size));
  packed.resize(size);
  return packed;
}

}  // namespace

/// Members are destroyed last to first: statements, connection, lock.
struct document::impl {
  ~impl() { rest(); }

  expected<void> open(const fs::path& path);
  expected<void> take_in();
  expected<void> create();
  expected<void> connect();
  void close_to_others() const;
  expected<void> wake();
  void rest();
  expected<void> check_mine();
  expected<void> close_whole();
  expected<void> rename(const fs::path& to);
  expected<void> prepare_all();
  expected<void> put_page(const page_ptr& page);
  expected<void> put_rows(const change& c, seal& sum);
  expected<void> put_version(const version_row& v, seal& sum);
  expected<void> put_cad(const cad_row& row, seal& sum);
  expected<void> update(query&& with, std::uint32_t number);
  expected<bool> has(const hash128& id) { return query(has_page, id).next(); }

  fs::path file;
  bool linked = false;  ///< It is somewhere else than where it was asked for.
  bool exists = false;  ///< The file does: since the first commit.
  document_lock lock;
  connection db;  ///< None while the document rests.
  seal last;      ///< As this object read or wrote it last.
  seal_keeper seals;
  statement has_page, page_by_id, manifest_by_number, insert_page, insert_version, set_load_cases,
    set_redo, set_head;
  statement insert_annotation, insert_log, insert_cad, cad_by_number;
};

expected<void> document::impl::open(const fs::path& path) {
  std::error_code code;
  file = fs::weakly_canonical(fs::absolute(path, code), code);  // a link leads to the same lock
  linked = fs::is_symlink(path);
  if (code || file.empty())
    return fail(ec::io_error, "cannot open '" + path.string() + "': " + code.message());
  return has_database(file)
    .and_then([&](bool) { return document_lock::take(file); })
    .map([&](document_lock&& taken) { lock = std::move(taken); })
    .and_then([&] { return has_database(file); })  // With the lock held, no TEdit makes it.
    .and_then([&](bool there) { return there ? take_in() : check_place(file); });
}

/// Connects to the file that is there, for the first time.
expected<void> document::impl::take_in() {
  return connect().and_then([&] { return seals.stored(); }).map([&](const seal& stored) {
    last = stored;
    exists = true;
  });
}

/// Connects when the document rests. The lock was held meanwhile; what a program without it did is
/// told by the seal.
expected<void> document::impl::wake() {
  if (db || !exists)
    return {};
  auto done = connect();
  if (!done)
    rest();
  return done;
}

void document::impl::rest() {
  if (!db)
    return;
  for (auto* one :
       {&has_page, &page_by_id, &manifest_by_number, &insert_page, &insert_version, &set_load_cases,
        &set_redo, &set_head, &insert_annotation, &insert_log, &insert_cad, &cad_by_number})
    one->reset();
  seals = {};
  db.reset();
  --connections;
}

/// The seal in the file is the one that this object read or wrote last, unless another program was
/// here.
expected<void> document::impl::check_mine() {
  const auto stored = seals.stored();
  if (!stored)
    return fail(stored.error());
  if (*stored == last)
    return {};
  return damaged(file.string() + " was changed by another program while it was open");
}

/// Rests, with all in the one file.
expected<void> document::impl::close_whole() {
  return wake()
    .and_then([&] { return check_mine(); })
    .and_then([&] { return number_of(db.get(), "PRAGMA wal_checkpoint(TRUNCATE)"); })
    .and_then([&](std::int64_t) -> expected<void> {
      rest();
      if (::access((file.string() + "-wal").c_str(), F_OK) != 0)
        return {};
      return fail(ec::conflict, file.string() + " is open in another program, too",
                  "Close it there, then try again");
    });
}

expected<void> document::impl::rename(const fs::path& to) {
  if (linked)
    return fail(linked_document(file));
  auto taken = document_lock::take(to);
  if (!taken)
    return fail(taken.error());
  if (!exists && ::access(to.c_str(), F_OK) == 0)
    return fail(ec::conflict, "there is a file " + to.string() + " already", "Take another name");
  return (exists ? close_whole() : check_place(to))
    .and_then([&] { return note_former_name(file, to); })
    .and_then([&] { return exists ? rename_file(file, to) : expected<void>(); })
    .map([&] {
      file = to;
      lock = std::move(*taken);
    });
}

/// Makes the file of a new document.
expected<void> document::impl::create() {
  const auto there = has_database(file);
  if (!there)
    return fail(there.error());
  if (*there)
    return fail(ec::conflict, file.string() + " was made by another program meanwhile",
                "Give the new document another name");
  return blank_document()
    .and_then([&](const std::vector<std::byte>& bytes) { return create_file(file, bytes); })
    .and_then([&] { return take_in(); })
    .map_error([&](const error& why) {
      rest();
      ::unlink(
        file.c_str());  // Blank, and ours; else the next attempt would take it for another's.
      return why;
    });
}

/// Nothing is written before the file is known to be a document.
expected<void> document::impl::connect() {
  sqlite3* made = nullptr;
  const int code =
    sqlite3_open_v2(file.c_str(), &made, SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX, nullptr);
  db.reset(made);  // also after a failure: it holds the message
  ++connections;
  if (code != SQLITE_OK)
    return sql_failure(made);
  if (sqlite3_db_readonly(made, "main") == 1)
    return fail(ec::io_error, file.string() + " may not be written", "Check its permissions");
  sqlite3_busy_timeout(made, busy_timeout_ms);
  if (auto done = execute(made, settings); !done)
    return done;
  const auto found = check_format(made, file);
  if (!found)
    return fail(found.error());
  close_to_others();
  return execute(made, "PRAGMA journal_mode = WAL")
    .and_then([&] {
      return *found == present_format ? expected<void>() : upgrade_alone(made, file.string());
    })
    .and_then([&] { return prepare_all(); });
}

/// A document is its owner's alone; what SQLite makes beside it takes its permissions.
void document::impl::close_to_others() const {
  struct stat about {};
  if (::stat(file.c_str(), &about) == 0 && about.st_uid == ::geteuid() &&
      (about.st_mode & (S_IRWXG | S_IRWXO)) != 0)
    ::chmod(file.c_str(), 0600);
}

expected<void> document::impl::prepare_all() {
  const std::pair<statement*, const char*> rows[] = {
    {&has_page, "SELECT 1 FROM page WHERE id = ?"},
    {&page_by_id, page_query},
    {&manifest_by_number, "SELECT manifest FROM version WHERE number = ?"},
    {&insert_page, "INSERT INTO page(id, size, data) VALUES(?, ?, ?)"},
    {&insert_version,
     "INSERT INTO version(number, parent, id, manifest, operation, load_cases, report, redo)"
     " VALUES(?, ?, ?, ?, ?, ?, ?, ?)"},
    {&set_load_cases, "UPDATE version SET load_cases = ?2 WHERE number = ?1"},
    {&set_redo, "UPDATE version SET redo = ?2 WHERE number = ?1"},
    {&set_head, "INSERT OR REPLACE INTO head(one, version) VALUES(1, ?)"},
    {&insert_log, "INSERT INTO log(what, details) VALUES(?, ?)"},
    {&insert_annotation, "INSERT OR REPLACE INTO annotation(version, name, note) VALUES(?, ?, ?)"},
    {&insert_cad,
     "INSERT OR REPLACE INTO cad(version, status, reason, deviation, facts, shape)"
     " VALUES(?, ?, ?, ?, ?, ?)"},
    {&cad_by_number, cad_query},
  };
  for (const auto& [target, sql] : rows) {
    auto made = prepare(db.get(), sql);
    if (!made)
      return fail(made.error());
    *target = std::move(*made);
  }
  return seals.prepare_all(db.get());
}

expected<void> document::impl::put_page(const page_ptr& page) {
  if (!page || page->bytes().size() > max_page_bytes)
    return fail(ec::storage_error, "a page to store is null or over 64 KiB");
  if (const auto stored = has(page->id()); !stored || *stored)
    return stored.map([](bool) {});
  const auto bytes = page->bytes();
  const auto packed = pack(bytes);
  if (!packed)
    return fail(packed.error());
  return query(insert_page, page->id(), bytes.size(), *packed).run();
}

expected<void> document::impl::put_cad(const cad_row& row, seal& sum) {
  const auto packed = pack(std::as_bytes(std::span(row.shape)));
  if (!packed)
    return fail(packed.error());
  return seals.change(table::cad, row.number, sum, [&] {
    return query(insert_cad, row.number, row.status, row.reason, row.deviation, row.facts, *packed)
      .run();
  });
}

/// Runs an update that must meet the version with this number.
expected<void> document::impl::update(query&& with, std::uint32_t number) {
  auto done = with.run();
  if (done && sqlite3_changes(db.get()) != 1)
    return fail(ec::storage_error, "version " + std::to_string(number) + " is not stored");
  return done;
}

expected<void> document::impl::put_version(const version_row& v, seal& sum) {
  return query(insert_version, v.number, v.parent, v.id, v.manifest, v.operation, v.load_cases,
               v.report, v.redo)
    .run()
    .and_then([&] { return seals.added(table::version, v.number, sum); });
}

/// Every row that is written takes its hash along.
expected<void> document::impl::put_rows(const change& c, seal& sum) {
  expected<void> done;
  const auto change_version = [&](std::uint32_t number, const statement& with, const auto& value) {
    return seals.change(table::version, number, sum,
                        [&] { return update(query(with, number, value), number); });
  };
  for (auto i = c.new_pages.begin(); done && i != c.new_pages.end(); ++i)
    done = put_page(*i);
  if (done && c.new_version)
    done = put_version(*c.new_version, sum);
  if (done && c.head)
    done = seals.change(table::head, 1, sum, [&] { return query(set_head, *c.head).run(); });
  for (auto i = c.load_cases.begin(); done && i != c.load_cases.end(); ++i)
    done = change_version(i->first, set_load_cases, i->second);
  for (auto i = c.redo.begin(); done && i != c.redo.end(); ++i)
    done = change_version(i->first, set_redo, i->second);
  for (auto i = c.annotations.begin(); done && i != c.annotations.end(); ++i)
    done = seals.change(table::annotation, i->number, sum, [&] {
      return query(insert_annotation, i->number, i->name, i->note).run();
    });
  for (auto i = c.cad.begin(); done && i != c.cad.end(); ++i)
    done = put_cad(*i, sum);
  if (done && !c.what.empty())
    done = query(insert_log, c.what, c.details).run().and_then([&] {
      return seals.added(table::log, sqlite3_last_insert_rowid(db.get()), sum);
    });
  return done;
}

document::document() : impl_(std::make_unique<impl>()) {}
document::~document() = default;

expected<std::unique_ptr<document>> document::open(const fs::path& file) {
  std::unique_ptr<document> made(new document);
  if (auto opened = made->impl_->open(file); !opened)
    return fail(with_file(opened.error(), made->impl_->file));
  return made;
}

expected<void> document::commit(const change& c) {
  if (auto awake = impl_->exists ? impl_->wake() : impl_->create(); !awake)
    return awake;
  const rollback_guard guard(impl_->db.get());
  seal sum;
  return execute(guard.get(), "BEGIN IMMEDIATE")
    .and_then([&] { return impl_->check_mine(); })
    .and_then([&] {
      sum = impl_->last;
      return impl_->put_rows(c, sum);
    })
    .and_then([&] { return impl_->seals.store(sum); })
    .and_then([&] { return execute(guard.get(), "COMMIT"); })
    .map([&] { impl_->last = sum; })
    .map_error([](const error& e) {
      return error{ec::storage_error, e.message, e.remedy, e.where};
    });
}

expected<contents> document::read() const {
  if (!impl_->exists)
    return contents{};
  return impl_->wake().and_then([&] { return read_contents(impl_->db.get(), impl_->seals); });
}

expected<std::vector<std::byte>> document::read_manifest(std::uint32_t number) const {
  const error missing{
    ec::not_found, "version " + std::to_string(number) + " is not stored", {}, {}};
  if (!impl_->exists)
    return fail(missing);
  if (auto awake = impl_->wake(); !awake)
    return fail(awake.error());
  query row(impl_->manifest_by_number, number);
  const auto found = row.next();
  if (!found)
    return fail(found.error());
  if (!*found)
    return fail(missing);
  return row.blob(0);
}

expected<page_ptr> document::read_page(const hash128& id) const {
  if (auto awake = impl_->wake(); !awake)
    return fail(awake.error());
  if (!impl_->exists)
    return fail(ec::not_found, "page " + to_hex(id) + " is not in the document");
  return find_page(impl_->page_by_id, id);
}

expected<std::optional<cad_row>> document::read_cad(std::uint32_t number) const {
  if (auto awake = impl_->wake(); !awake)
    return fail(awake.error());
  if (!impl_->exists)
    return std::nullopt;
  return find_cad(impl_->cad_by_number, number);
}

expected<std::int64_t> document::remove(const removal& what) {
  if (auto awake = impl_->wake(); !awake)
    return fail(awake.error());
  if (!impl_->exists)
    return fail(ec::not_found, "the document holds nothing yet", "Open a part in it first");
  auto* db = impl_->db.get();
  auto pages = impl_->check_mine().and_then([&] { return remove_rows(db, impl_->seals, what); });
  if (!pages)
    return pages;
  return impl_->seals.stored()
    .and_then([&](const seal& now) {
      impl_->last = now;
      return squeeze(db);
    })
    .map([&] { return *pages; });
}

/// A file of its own: what is in the log beside the database's file is in it, too.
expected<std::vector<std::byte>> document::copy() const {
  if (!impl_->exists)
    return fail(ec::not_found, "the document holds nothing yet", "Open a part in it first");
  if (auto awake = impl_->wake(); !awake)
    return fail(awake.error());
  auto* db = impl_->db.get();
  const auto pages = number_of(db, "PRAGMA page_count");
  const auto each = number_of(db, "PRAGMA page_size");
  if (!pages || !each)
    return fail(pages ? each.error() : pages.error());
  if (*pages * *each > most_bytes_of_a_copy)
    return fail(ec::storage_error,
                "the document has " + std::to_string(*pages * *each) +
                  " bytes, and a copy may have " + std::to_string(most_bytes_of_a_copy),
                "Close it in every program and copy its file");
  return image_of(db);
}

expected<void> document::copy_to(const fs::path& to) const {
  if (!impl_->exists)
    return fail(ec::not_found, "the document holds nothing yet", "Open a part in it first");
  return impl_->wake().and_then([&] { return impl_->check_mine(); }).and_then([&] {
    return copy_database(impl_->db.get(), to);
  });
}

expected<void> document::erase() {
  if (impl_->linked)
    return fail(linked_document(impl_->file));
  impl_->rest();
  return impl_->exists ? erase_files(impl_->file).map([&] { impl_->exists = false; })
                       : expected<void>();
}

bool document::has_page(const hash128& id) const {
  return impl_->exists && impl_->wake().and_then([&] { return impl_->has(id); }).value_or(false);
}

expected<void> document::rename(const std::string& file_name) {
  return impl_->rename(impl_->file.parent_path() / file_name);
}

expected<void> document::wake() {
  return impl_->wake();
}

void document::rest() {
  impl_->rest();
}

int document::open_connections() noexcept {
  return connections;
}

}  // namespace tedit::store
