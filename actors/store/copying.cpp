// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/copying.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <memory>

#include "actors/store/document_file.hpp"
#include "actors/store/documents_folder.hpp"
#include "base/guard.hpp"
#include "base/system_failure.hpp"
#include "base/unique_fd.hpp"

namespace tedit::store {

namespace {

namespace fs = std::filesystem;

struct backup_end {
  void operator()(sqlite3_backup* one) const noexcept { sqlite3_backup_finish(one); }
};

/// So many pages of 4 KiB go at once: a cancel is noticed after some milliseconds.
constexpr int pages_at_once = 1024;

/// Page by page; that nobody writes between two steps is the caller's to see to, or SQLite begins
/// anew. Errors: those of `sql_failure`.
expected<void> back_up(sqlite3* from, const fs::path& to) {
  sqlite3* made = nullptr;
  const int code =
    sqlite3_open_v2(to.c_str(), &made, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  const connection out(made);
  if (code != SQLITE_OK)
    return sql_failure(made);
  const std::unique_ptr<sqlite3_backup, backup_end> work(
    sqlite3_backup_init(made, "main", from, "main"));
  int step = work ? SQLITE_OK : SQLITE_ERROR;
  while (step == SQLITE_OK) {
    check_cancelled();
    step = sqlite3_backup_step(work.get(), pages_at_once);
  }
  return step == SQLITE_DONE ? expected<void>() : expected<void>(sql_failure(made));
}

expected<void> sync_path(const fs::path& path, int flags) {
  const unique_fd handle(::open(path.c_str(), flags | O_CLOEXEC));
  if (!handle || ::fsync(handle.get()) != 0)
    return system_failure("cannot write " + path.string(), errno);
  return {};
}

/// Gone with what SQLite made beside it, whatever happens.
struct copy_draft {
  fs::path path;

  void remove() const {
    for (const char* with : {"", "-wal", "-shm", "-journal"})
      ::unlink((path.string() + with).c_str());
  }
  ~copy_draft() { remove(); }
};

expected<void> put_in_place(const fs::path& draft, const fs::path& file) {
  if (::link(draft.c_str(), file.c_str()) != 0) {
    if (errno == EEXIST)
      return fail(ec::conflict, "there is a file " + file.string() + " already",
                  "Take another name");
    return system_failure("cannot make " + file.string(), errno);
  }
  return sync_path(file.parent_path(), O_RDONLY | O_DIRECTORY);
}

}  // namespace

expected<void> copy_database(sqlite3* db, const fs::path& file) {
  std::error_code code;
  const auto target = fs::absolute(file, code);
  const copy_draft draft{draft_of(target)};
  draft.remove();  // What a kill left.
  return check_place(target)
    .and_then([&] { return back_up(db, draft.path); })
    .and_then([&]() -> expected<void> {
      if (::chmod(draft.path.c_str(), 0600) != 0)
        return system_failure("cannot write " + draft.path.string(), errno);
      return sync_path(draft.path, O_RDONLY);
    })
    .and_then([&] { return put_in_place(draft.path, target); });
}

}  // namespace tedit::store
