// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/document_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>

#include "base/system_failure.hpp"
#include "base/unique_fd.hpp"

namespace tedit::store {

namespace {

namespace fs = std::filesystem;

unique_fd open_file(const fs::path& file, int flags, mode_t mode = 0) {
  return unique_fd(::open(file.c_str(), flags | O_CLOEXEC, mode));
}

constexpr std::string_view magic("SQLite format 3\0", 16);

std::uint32_t big_endian(const unsigned char* bytes) {
  return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 |
         std::uint32_t{bytes[2]} << 8 | std::uint32_t{bytes[3]};
}

/// Whether the log beside a file of so many bytes has its first page whole: a machine that stopped
/// while the log was brought into the file may have left rubbish there, which SQLite mends from the
/// log. A file that is no whole number of pages is somebody else's. Source: "WAL File Format" in
/// SQLite's documentation; its checksums are SQLite's to check.
bool log_has_first_page(const fs::path& file, off_t bytes) {
  constexpr std::size_t header = 32, frame_header = 24;
  std::array<unsigned char, header> start{};
  std::array<unsigned char, frame_header + magic.size()> frame{};
  const auto log = open_file(file.string() + "-wal", O_RDONLY);
  if (!log || ::pread(log.get(), start.data(), header, 0) != ssize_t(header))
    return false;
  const auto page_size = big_endian(start.data() + 8);
  if ((big_endian(start.data()) | 1U) != 0x377F0683 || page_size < 512 || page_size > 65536 ||
      bytes % off_t(page_size) != 0)
    return false;
  const auto read_at = [&](off_t at) {
    return ::pread(log.get(), frame.data(), frame.size(), at) == ssize_t(frame.size());
  };
  const auto step = off_t(frame_header) + off_t(page_size);
  for (off_t at = header; read_at(at); at += step) {
    const bool is_current = std::equal(&frame[8], &frame[16], &start[16]);  // The salts.
    if (is_current && big_endian(frame.data()) == 1)
      return std::memcmp(&frame[frame_header], magic.data(), magic.size()) == 0;
  }
  return false;
}

/// How long the header says that the file is; 0 where it does not. Source: "Database File Format"
/// of SQLite's documentation, 1.3.
std::uint64_t length_by_header(int handle) {
  std::array<unsigned char, 100> header{};
  if (::pread(handle, header.data(), header.size(), 0) != ssize_t(header.size()))
    return 0;
  const std::uint32_t page_size = header[16] * 256U + header[17];
  const bool is_said = std::equal(&header[24], &header[28], &header[92]);
  return is_said ? std::uint64_t{page_size == 1 ? 65536 : page_size} * big_endian(&header[28]) : 0;
}

}  // namespace

error with_file(error why, const fs::path& file) {
  if (why.code != ec::storage_error)
    return why;
  struct stat about {};
  const auto in = open_file(file, O_RDONLY);
  // With a log beside it, the file may be shorter; who looks at it makes an empty one.
  struct stat log {};
  const bool has_log = ::stat((file.string() + "-wal").c_str(), &log) == 0 && log.st_size > 0;
  if (in && ::fstat(in.get(), &about) == 0 && !has_log)
    if (const auto length = length_by_header(in.get());
        static_cast<std::uint64_t>(about.st_size) < length)
      why.message = file.string() + " is cut off: it has " + std::to_string(about.st_size) +
                    " bytes of " + std::to_string(length);
  if (why.where.empty() && why.message.find(file.string()) == std::string::npos)
    why.where = file.string();
  return why;
}

bool write_all(int handle, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const auto written = ::write(handle, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR)
      return false;
    bytes = bytes.subspan(written < 0 ? 0 : static_cast<std::size_t>(written));
  }
  return true;
}

expected<bool> has_database(const fs::path& file) {
  const auto in = open_file(file, O_RDONLY);
  if (!in && errno == ENOENT)
    return false;
  struct stat about {};
  std::string start(magic.size(), ' ');
  if (!in || ::fstat(in.get(), &about) != 0)
    return system_failure("cannot read " + file.string(), errno);
  if (!S_ISREG(about.st_mode))
    return fail(ec::io_error, file.string() + " is no file", "Name a TEdit document or a new file");
  if (about.st_size == 0)
    return fail(ec::storage_error, file.string() + " is empty: it is no document",
                "Restore it from a backup, or remove it to begin a new document of this name");
  const auto size = ::read(in.get(), start.data(), start.size());
  if (size < 0)
    return system_failure("cannot read " + file.string(), errno);
  if (start == magic || log_has_first_page(file, about.st_size))
    return true;
  return fail(ec::storage_error, file.string() + " is not a database",
              "Name a TEdit document or a new file; a mesh file is imported, not opened");
}

expected<void> check_place(const fs::path& file) {
  for (const char* end : {"-wal", "-journal"})
    if (const auto log = file.string() + end; ::access(log.c_str(), F_OK) == 0)
      return fail(ec::conflict, log + " belongs to a document that is not here",
                  "Put that document back beside it, or remove it to give its name to another");
  return {};
}

expected<void> create_file(const fs::path& file, std::span<const std::byte> bytes) {
  if (auto free = check_place(file); !free)
    return free;
  const auto draft = file.string() + "-new";
  {
    // What an earlier attempt left is nobody's: only the holder of the lock comes here.
    if (::unlink(draft.c_str()) != 0 && errno != ENOENT)
      return system_failure("cannot replace " + draft, errno);
    const auto out = open_file(draft, O_WRONLY | O_CREAT | O_EXCL, 0600);
    if (!out || !write_all(out.get(), bytes) || ::fsync(out.get()) != 0) {
      const int reason = errno;
      ::unlink(draft.c_str());
      return system_failure("cannot make " + file.string(), reason);
    }
  }
  const auto folder = open_file(file.parent_path(), O_RDONLY | O_DIRECTORY);
  if (::rename(draft.c_str(), file.c_str()) != 0 || !folder || ::fsync(folder.get()) != 0)
    return system_failure("cannot make " + file.string(), errno);
  return {};
}

expected<void> rename_file(const fs::path& from, const fs::path& to) {
  if (auto free = check_place(to); !free)
    return free;
  const auto what = "cannot rename " + from.string() + " to " + to.filename().string();
  const auto folder = open_file(from.parent_path(), O_RDONLY | O_DIRECTORY);
  if (!folder)
    return system_failure(what, errno);
  const auto move = [&](const fs::path& before, const fs::path& after) {
    return ::renameat2(folder.get(), before.filename().c_str(), folder.get(),
                       after.filename().c_str(), RENAME_NOREPLACE) == 0;
  };
  if (!move(from, to)) {
    const int reason = errno;
    if (reason == EEXIST)
      return fail(ec::conflict, "there is a file " + to.string() + " already", "Take another name");
    if (reason == EINVAL)
      return fail(ec::io_error, what + ": its file system might replace another file by it",
                  "Save a copy under the other name");
    return system_failure(what, reason);
  }
  if (::fsync(folder.get()) == 0)
    return {};
  const int reason = errno;
  move(to, from);  // So that it is found where the refusal says it still is.
  return system_failure(what, reason);
}

}  // namespace tedit::store
