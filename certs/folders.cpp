// SPDX-License-Identifier: AGPL-3.0-or-later
#include "certs/folders.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <utility>

#include "base/system_failure.hpp"

namespace tedit::certs {

namespace {

namespace fs = std::filesystem;

expected<void> sync_folder(const fs::path& folder) {
  const unique_fd handle(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!handle || ::fsync(handle.get()) != 0)
    return system_failure("cannot write " + folder.string(), errno);
  return {};
}

bool write_all(int fd, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const auto n = ::write(fd, text.data() + done, text.size() - done);
    if (n < 0 && errno != EINTR)
      return false;
    done += n > 0 ? static_cast<std::size_t>(n) : 0;
  }
  return ::fsync(fd) == 0;
}

tl::unexpected<error> taken(const fs::path& place) {
  return fail(ec::conflict, "there is something in " + place.string() + " already",
              "Nothing is overwritten: name another folder, or remove that one yourself");
}

}  // namespace

expected<void> write_new(const fs::path& file, const std::string& text) {
  const unique_fd out(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  if (!out)
    return system_failure("cannot make " + file.string(), errno);
  if (!write_all(out.get(), text)) {
    const int reason = errno;
    ::unlink(file.c_str());
    return system_failure("cannot write " + file.string(), reason);
  }
  return {};
}

expected<void> replace_file(const fs::path& file, const std::string& text) {
  const auto draft = file.parent_path() / ("." + file.filename().string() + ".new");
  ::unlink(draft.c_str());  // What a kill left.
  return write_new(draft, text).and_then([&]() -> expected<void> {
    if (::rename(draft.c_str(), file.c_str()) != 0) {
      const int reason = errno;
      ::unlink(draft.c_str());
      return system_failure("cannot write " + file.string(), reason);
    }
    return sync_folder(file.parent_path());
  });
}

expected<folder_draft> folder_draft::begin(const fs::path& given, bool exchanges) {
  std::error_code code;
  auto place = fs::absolute(given, code).lexically_normal();
  if (!place.has_filename())
    place = place.parent_path();
  // Its own name for each: what runs beside must not fill the same one.
  std::string draft =
    (place.parent_path() / ("." + place.filename().string() + ".new-XXXXXX")).string();
  if (::mkdtemp(draft.data()) == nullptr)
    return system_failure("cannot make " + place.string(), errno);
  return folder_draft(place, draft, exchanges);
}

expected<folder_draft> folder_draft::make(const fs::path& place) {
  std::error_code code;
  if (fs::exists(fs::symlink_status(place, code)) && !fs::is_empty(place, code))
    return taken(place);
  return begin(place, false);
}

expected<folder_draft> folder_draft::make_exchange(const fs::path& place) {
  return begin(place, true);
}

folder_draft::folder_draft(folder_draft&& other) noexcept
    : place_(std::move(other.place_)),
      draft_(std::exchange(other.draft_, {})),
      exchanges_(other.exchanges_) {}

folder_draft::~folder_draft() {
  std::error_code ignored;
  if (!draft_.empty())
    fs::remove_all(draft_, ignored);
}

expected<void> folder_draft::put_in_place() {
  if (auto synced = sync_folder(draft_); !synced)
    return synced;
  if (exchanges_) {
    // What was there has the draft's name then, and goes with it.
    if (::renameat2(AT_FDCWD, draft_.c_str(), AT_FDCWD, place_.c_str(), RENAME_EXCHANGE) != 0)
      return system_failure("cannot exchange " + place_.string(), errno);
    return sync_folder(place_.parent_path());
  }
  // Takes the place of an empty folder, and of nothing else.
  if (::rename(draft_.c_str(), place_.c_str()) != 0) {
    if (errno == ENOTEMPTY || errno == EEXIST || errno == ENOTDIR)
      return taken(place_);
    return system_failure("cannot make " + place_.string(), errno);
  }
  draft_.clear();
  return sync_folder(place_.parent_path());
}

expected<unique_fd> lock_folder(const fs::path& folder) {
  unique_fd handle(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!handle)
    return system_failure("cannot read " + folder.string(), errno);
  while (::flock(handle.get(), LOCK_EX) != 0)
    if (errno != EINTR)
      return system_failure("cannot lock " + folder.string(), errno);
  return handle;
}

}  // namespace tedit::certs
