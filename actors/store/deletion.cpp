// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/deletion.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include "actors/store/document_file.hpp"
#include "actors/store/document_lock.hpp"
#include "actors/store/former_names.hpp"
#include "actors/store/schema.hpp"
#include "base/system_failure.hpp"
#include "base/unique_fd.hpp"

namespace tedit::store {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view erased_suffix = ".tedit-erased";

/// No document's name, and one that `prepare_documents_folder` knows.
fs::path hidden_place(const fs::path& file) {
  return file.parent_path() / ("." + file.stem().string() + std::string(erased_suffix));
}

/// What SQLite and the making of a file leave beside it.
void remove_companions(const fs::path& file) {
  for (const char* with : {"-wal", "-shm", "-journal", "-new"})
    ::unlink((file.string() + with).c_str());
}

/// A whole first page of another program's database. Source: "Database File Format", 1.3, in
/// SQLite's documentation.
bool is_of_another_program(const fs::path& file) {
  constexpr std::size_t id_at = 68;
  constexpr std::string_view magic("SQLite format 3\0", 16);
  std::array<unsigned char, id_at + 4> start{};
  const unique_fd in(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!in || ::pread(in.get(), start.data(), start.size(), 0) != ssize_t(start.size()) ||
      std::string_view(reinterpret_cast<const char*>(start.data()), magic.size()) != magic)
    return false;  // `has_database` has found a whole one in the log.
  std::int64_t id = 0;
  for (std::size_t i = 0; i < 4; ++i)
    id = id << 8 | start[id_at + i];
  return id != application_id;
}

}  // namespace

error linked_document(const fs::path& target) {
  return {ec::conflict,
          "the document is a link to " + target.string(),
          "Put the document itself in its place, then try again",
          {}};
}

/// The hidden name first, in one step: a log without its document would keep others from its name.
expected<void> erase_files(const fs::path& file) {
  const auto what = "cannot delete " + file.string();
  const auto hidden = hidden_place(file);
  const unique_fd folder(::open(file.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder)
    return system_failure(what, errno);
  // A full disk may refuse the note and must not keep anybody from making room.
  (void)note_deleted_name(file);
  if (::rename(file.c_str(), hidden.c_str()) != 0)
    return system_failure(what, errno);
  if (::fsync(folder.get()) != 0) {
    const int reason = errno;
    ::rename(hidden.c_str(), file.c_str());
    return system_failure(what, reason);
  }
  remove_companions(file);
  ::unlink(hidden.c_str());
  return {};
}

expected<void> delete_document(const fs::path& file) {
  std::error_code code;
  const auto target = fs::weakly_canonical(fs::absolute(file, code), code);
  if (code || target.empty())
    return fail(ec::io_error, "cannot find '" + file.string() + "': " + code.message());
  if (fs::is_symlink(file, code))
    return fail(linked_document(target));
  const auto lock = document_lock::take(target);
  if (!lock)
    return fail(lock.error());
  const auto there = has_database(target);
  if (!there)
    return fail(there.error().code, there.error().message,
                "Remove the file by hand if it is not needed");
  if (!*there)
    return fail(ec::not_found, "there is no file " + target.string(), "Check the path");
  if (is_of_another_program(target))
    return fail(ec::storage_error, target.string() + " is a database, but no TEdit document",
                "Remove the file by hand if it is not needed");
  return erase_files(target);
}

bool is_erased(const fs::path& file) {
  const auto name = file.filename().string();
  return name.starts_with('.') && name.ends_with(erased_suffix);
}

void finish_erasing(const fs::path& hidden) {
  const auto name = hidden.filename().string();
  const auto file =
    hidden.parent_path() / (name.substr(1, name.size() - 1 - erased_suffix.size()) + ".tedit");
  std::error_code code;
  if (!fs::exists(fs::symlink_status(file, code)))  // Else what lies there is that one's.
    remove_companions(file);
  ::unlink(hidden.c_str());
}

}  // namespace tedit::store
