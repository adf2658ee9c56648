// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/adoption.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "actors/store/document_file.hpp"
#include "actors/store/documents_folder.hpp"
#include "actors/store/loading.hpp"
#include "base/named_error.hpp"
#include "base/system_failure.hpp"
#include "base/unique_fd.hpp"

namespace tedit::actors {

namespace {

namespace fs = std::filesystem;

/// Gone with what SQLite made beside it, whatever happens.
struct draft_file {
  fs::path path;

  void remove() const {
    for (const char* with : {"", "-wal", "-shm", "-journal", "-new"})
      ::unlink((path.string() + with).c_str());
  }
  ~draft_file() { remove(); }
};

expected<void> write_durably(const fs::path& file, const std::vector<page_ptr>& bytes) {
  const unique_fd out(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  bool good = static_cast<bool>(out);
  for (auto p = bytes.begin(); good && p != bytes.end(); ++p)
    good = store::write_all(out.get(), (*p)->bytes());
  if (!good || ::fsync(out.get()) != 0)
    return system_failure("cannot write " + file.string(), errno);
  return {};
}

/// As an opening does, and brought to the present format by it.
expected<void> check(const fs::path& file) {
  const auto opened = store::document::open(file);
  if (!opened)
    return fail(opened.error());
  const auto all = load(**opened);
  if (!all)
    return fail(all.error());
  if (!all->head)
    return fail(ec::bad_input, "the document holds nothing", "Choose another one");
  return {};
}

/// Never instead of a file that is there.
expected<void> give_name(const fs::path& draft, const fs::path& file) {
  if (::link(draft.c_str(), file.c_str()) != 0) {
    if (errno == EEXIST)
      return fail(ec::conflict, "there is a document " + file.stem().string() + " already",
                  "Give this one another name");
    return system_failure("cannot make " + file.string(), errno);
  }
  const unique_fd folder(::open(file.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder || ::fsync(folder.get()) != 0)
    return system_failure("cannot make " + file.string(), errno);
  return {};
}

}  // namespace

expected<void> adopt(const fs::path& file, const std::vector<page_ptr>& bytes) {
  const draft_file draft{store::draft_of(file)};
  draft.remove();  // What a kill left.
  return store::check_place(file)
    .and_then([&] { return write_durably(draft.path, bytes); })
    .and_then([&] { return check(draft.path); })
    .and_then([&] { return give_name(draft.path, file); })
    .map_error([&](const error& why) { return named_error(why, draft.path.string(), "the file"); });
}

}  // namespace tedit::actors
