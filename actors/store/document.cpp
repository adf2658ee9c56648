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

#include "actors/store/document_file.hpp"
#include "actors/store/document_lock.hpp"
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
  expected<void> update(query&& with, std::uint32_t number);
  expected<void> read_rows(contents& all, seal& sum);
  expected<void> check_numbers(const contents& all, bool sound);
  expected<bool> has(const hash128& id) { return query(find_page, id).next(); }

  fs::path file;
  bool linked = false;  ///< It is somewhere else than where it was asked for.
  bool exists = false;  ///< The file does: since the first commit.
  document_lock lock;
  connection db;  ///< None while the document rests.
  seal last;      ///< As this object read or wrote it last.
  seal_keeper seals;
  statement find_page, page_by_id, insert_page, insert_version, set_load_cases, set_redo, set_head;
  statement insert_annotation, insert_log;
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
  for (auto* one : {&find_page, &page_by_id, &insert_page, &insert_version, &set_load_cases,
                    &set_redo, &set_head, &insert_annotation, &insert_log})
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
    return fail(ec::conflict, "the document is a link to " + file.string(),
                "Put the document itself in its place, then try again");
  auto taken = document_lock::take(to);
  if (!taken)
    return fail(taken.error());
  if (!exists && ::access(to.c_str(), F_OK) == 0)
    return fail(ec::conflict, "there is a file " + to.string() + " already", "Take another name");
  return (exists ? close_whole().and_then([&] { return rename_file(file, to); }) : check_place(to))
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
  const auto current = check_format(made, file);
  if (!current)
    return fail(current.error());
  close_to_others();
  return execute(made, "PRAGMA journal_mode = WAL")
    .and_then([&] { return *current ? expected<void>() : upgrade_alone(made, file.string()); })
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
    {&find_page, "SELECT 1 FROM page WHERE id = ?"},
    {&page_by_id, "SELECT size, data FROM page WHERE id = ?"},
    {&insert_page, "INSERT INTO page(id, size, data) VALUES(?, ?, ?)"},
    {&insert_version,
     "INSERT INTO version(number, parent, id, manifest, operation, load_cases, report, redo)"
     " VALUES(?, ?, ?, ?, ?, ?, ?, ?)"},
    {&set_load_cases, "UPDATE version SET load_cases = ?2 WHERE number = ?1"},
    {&set_redo, "UPDATE version SET redo = ?2 WHERE number = ?1"},
    {&set_head, "INSERT OR REPLACE INTO head(one, version) VALUES(1, ?)"},
    {&insert_log, "INSERT INTO log(what, details) VALUES(?, ?)"},
    {&insert_annotation, "INSERT OR REPLACE INTO annotation(version, name, note) VALUES(?, ?, ?)"},
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
  if (done && !c.what.empty())
    done = query(insert_log, c.what, c.details).run().and_then([&] {
      return seals.added(table::log, sqlite3_last_insert_rowid(db.get()), sum);
    });
  return done;
}

/// All rows but the pages, each checked and all together. Errors: `storage_error`.
expected<void> document::impl::read_rows(contents& all, seal& sum) {
  bool sound = true;
  const auto read_version = [&](query& row) {
    all.versions.push_back({row.u32(0).value_or(0), row.u32(1), row.hash(2), row.blob(3),
                            row.text(4), row.text(5), row.text(6), row.u32(7), "", ""});
    sound = sound && row.sound();
  };
  const auto read_head = [&](query& row) { all.head = row.u32(1); };
  const auto read_log = [&](query& row) {
    all.log.push_back({static_cast<std::uint64_t>(row.number(0)), row.text(1), row.text(2)});
  };
  const auto read_annotation = [&](query& row) {
    const auto number = row.u32(0).value_or(0);
    const auto of = std::ranges::lower_bound(all.versions, number, {}, &version_row::number);
    sound = sound && of != all.versions.end() && of->number == number;
    if (sound) {
      of->name = row.text(1);
      of->note = row.text(2);
    }
  };
  return seals.read_all(table::version, sum, read_version)
    .and_then([&] { return seals.read_all(table::head, sum, read_head); })
    .and_then([&] { return seals.read_all(table::log, sum, read_log); })
    .and_then([&] { return seals.read_all(table::annotation, sum, read_annotation); })
    .and_then([&] { return seals.compare(sum); })
    .and_then([&] { return check_numbers(all, sound); });
}

/// What hashes do not tell: whether numbers fit, and the log's next one, which SQLite keeps.
expected<void> document::impl::check_numbers(const contents& all, bool sound) {
  const auto last_used = number_of(db.get(), "SELECT coalesce(max(seq), 0) FROM sqlite_sequence");
  if (!last_used)
    return fail(last_used.error());
  if (*last_used != (all.log.empty() ? 0 : static_cast<std::int64_t>(all.log.back().sequence)))
    return damaged("the document is damaged: the numbers of the log were changed");
  if (!sound)
    return damaged("the document has a version with impossible numbers");
  return {};
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
  if (auto sound = impl_->wake().and_then([&] { return check_structure(impl_->db.get()); }); !sound)
    return fail(sound.error());
  contents all;
  seal sum;
  const auto schema = impl_->seals.schema_hash();
  if (!schema)
    return fail(schema.error());
  sum.schema = *schema;
  if (auto done = impl_->read_rows(all, sum); !done)
    return fail(done.error());
  return all;
}

expected<page_ptr> document::read_page(const hash128& id) const {
  if (auto awake = impl_->wake(); !awake)
    return fail(awake.error());
  if (!impl_->exists)
    return fail(ec::not_found, "page " + to_hex(id) + " is not in the document");
  query row(impl_->page_by_id, id);
  const auto found = row.next();
  if (!found)
    return fail(found.error());
  if (!*found)
    return fail(ec::not_found, "page " + to_hex(id) + " is not in the document",
                "Restore the document from a backup");
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
