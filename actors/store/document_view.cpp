// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/document_view.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>

#include "actors/store/copying.hpp"
#include "actors/store/document_file.hpp"
#include "actors/store/schema.hpp"
#include "base/system_failure.hpp"

namespace tedit::store {

namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 5000;
constexpr auto only_reads = "PRAGMA query_only = ON; PRAGMA trusted_schema = OFF;";

/// Where nothing can be made beside the file, nobody changes it, and SQLite must be told so.
std::string address_of(const fs::path& file) {
  const bool still = ::access(file.parent_path().c_str(), W_OK) != 0 &&
                     ::access((file.string() + "-wal").c_str(), F_OK) != 0;
  std::string address = "file:";
  for (const char c : file.string())
    if (c == '%' || c == '?' || c == '#') {
      char code[4];
      std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned>(c));
      address += code;
    } else {
      address += c;
    }
  return address + (still ? "?immutable=1" : "");
}

/// A connection that may write closes the log behind it as every other does; one that may not
/// would leave it beside the file.
expected<connection> connect_to_read(const fs::path& file) {
  sqlite3* made = nullptr;
  const int code =
    sqlite3_open_v2(address_of(file).c_str(), &made,
                    SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_URI, nullptr);
  connection db(made);
  if (code != SQLITE_OK)
    return sql_failure(made);
  sqlite3_busy_timeout(made, patience_ms);
  if (auto done = execute(made, only_reads); !done)
    return fail(done.error());
  return db;
}

/// A copy in memory that takes part in no log of the file.
expected<connection> copy_in_memory(sqlite3* db) {
  constexpr std::size_t log_marks = 18;  // Two bytes of the header: 2 with a log, 1 without.
  auto bytes = image_of(db);
  if (!bytes)
    return fail(bytes.error());
  if (bytes->size() <= log_marks + 1)
    return fail(ec::storage_error, "the document is damaged: it is too short",
                "Restore the document from a backup");
  (*bytes)[log_marks] = (*bytes)[log_marks + 1] = std::byte{1};
  sqlite3* made = nullptr;
  const int code = sqlite3_open_v2(":memory:", &made, SQLITE_OPEN_READWRITE, nullptr);
  connection copy(made);
  auto* taken = static_cast<unsigned char*>(sqlite3_malloc64(bytes->size()));
  if (code != SQLITE_OK || !taken)
    return fail(ec::out_of_memory, "there is no memory for the document",
                "Close other programs and try again");
  std::ranges::transform(*bytes, taken,
                         [](std::byte b) { return std::to_integer<unsigned char>(b); });
  const auto size = static_cast<sqlite3_int64>(bytes->size());
  if (sqlite3_deserialize(made, "main", taken, size, size,
                          SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE) !=
      SQLITE_OK)
    return sql_failure(made);
  return copy;
}

}  // namespace

struct document_view::impl {
  fs::path file;
  connection db;     ///< Of the file; within one transaction.
  connection newer;  ///< Of the first format: the same in this one, in memory.
  std::int64_t format = 0;
  seal_keeper seals;
  statement by_id, all_ids, cad;

  [[nodiscard]] sqlite3* rows() const { return newer ? newer.get() : db.get(); }
  /// What is in the second format stands there as in the third one, without CAD models.
  [[nodiscard]] bool has_cad() const { return newer || format == present_format; }

  expected<void> open();
  expected<void> bring_up();
  expected<void> prepare_all();
};

expected<void> document_view::impl::open() {
  const auto there = has_database(file);
  if (!there)
    return fail(there.error());
  if (!*there)
    return fail(ec::not_found, "there is no file " + file.string(), "Check the path");
  auto made = connect_to_read(file);
  if (!made)
    return fail(made.error());
  db = std::move(*made);
  // The first read decides which moment the transaction sees.
  return execute(db.get(), "BEGIN")
    .and_then([&] { return number_of(db.get(), "PRAGMA user_version"); })
    .and_then([&](std::int64_t) { return check_format(db.get(), file); })
    .and_then([&](std::int64_t number) {
      format = number;
      return format < 2 ? bring_up() : expected<void>();
    })
    .and_then([&] { return prepare_all(); });
}

expected<void> document_view::impl::bring_up() {
  return copy_in_memory(db.get()).and_then([&](connection&& made) {
    newer = std::move(made);
    return upgrade(newer.get());
  });
}

expected<void> document_view::impl::prepare_all() {
  auto page = prepare(rows(), page_query);
  auto ids = prepare(rows(), "SELECT id FROM page ORDER BY id");
  if (!page || !ids)
    return fail(page ? ids.error() : page.error());
  by_id = std::move(*page);
  all_ids = std::move(*ids);
  if (!has_cad())
    return seals.prepare_all(rows(), sealed_tables_of_format_2);
  auto by_number = prepare(rows(), cad_query);
  if (!by_number)
    return fail(by_number.error());
  cad = std::move(*by_number);
  return seals.prepare_all(rows());
}

document_view::document_view() : impl_(std::make_unique<impl>()) {}
document_view::~document_view() = default;

expected<std::unique_ptr<document_view>> document_view::open(const fs::path& file) {
  std::unique_ptr<document_view> made(new document_view);
  std::error_code code;
  made->impl_->file = fs::weakly_canonical(fs::absolute(file, code), code);
  if (code || made->impl_->file.empty())
    return fail(ec::io_error, "cannot open '" + file.string() + "': " + code.message());
  if (auto opened = made->impl_->open(); !opened)
    return fail(with_file(opened.error(), made->impl_->file));
  return made;
}

std::int64_t document_view::format() const {
  return impl_->format;
}

expected<std::vector<hash128>> document_view::page_ids() const {
  std::vector<hash128> result;
  query row(impl_->all_ids);
  expected<bool> more;
  while ((more = row.next()) && *more)
    result.push_back(row.hash(0));
  if (!more)
    return fail(more.error());
  return result;
}

expected<sound_rows> document_view::read() const {
  return read_sound_rows(impl_->rows(), impl_->seals);
}

expected<page_ptr> document_view::read_page(const hash128& id) const {
  return find_page(impl_->by_id, id);
}

expected<std::optional<cad_row>> document_view::read_cad(std::uint32_t number) const {
  if (!impl_->has_cad())
    return std::nullopt;
  return find_cad(impl_->cad, number);
}

expected<void> document_view::copy_to(const fs::path& file) const {
  return copy_database(impl_->db.get(), file);
}

expected<file_state> state_of(const fs::path& file) {
  file_state result;
  for (const char* with : {"", "-wal"}) {
    struct stat about {};
    const auto path = file.string() + with;
    if (::stat(path.c_str(), &about) == 0) {
      result.bytes += about.st_size;
      const auto changed =
        std::int64_t{about.st_mtim.tv_sec} * 1000 + about.st_mtim.tv_nsec / 1'000'000;
      // A log without content is made by who reads, too.
      if (about.st_size > 0)
        result.changed_ms = std::max(result.changed_ms, changed);
    } else if (*with == '\0' && errno == ENOENT) {
      return fail(ec::not_found, "there is no file " + path, "Check the path");
    } else if (errno != ENOENT) {
      return system_failure("cannot look at " + path, errno);
    }
  }
  return result;
}

}  // namespace tedit::store
