// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/document_lock.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <map>
#include <mutex>
#include <set>
#include <span>
#include <utility>

#include "base/hash.hpp"
#include "base/system_failure.hpp"
#include "base/unique_fd.hpp"

namespace tedit::store {

namespace fs = std::filesystem;

/// The lock file of one folder, open for as long as this process holds a document in it.
struct document_lock::folder {
  unique_fd handle;
  std::set<std::string> held;  ///< Names; locks of one descriptor do not exclude each other.
};

namespace {

/// Guards all folders of this process, and what they hold.
std::mutex& guard() {
  static std::mutex mutex;
  return mutex;
}

/// The byte that stands for a name. Two names share one with a chance of 2^-62; then only one of
/// the two can be open.
off_t byte_of(const std::string& name) {
  return static_cast<off_t>(hash_bytes(std::as_bytes(std::span(name))).low >> 2);
}

/// The lock of a name's byte, for `fcntl`.
struct flock byte_lock(const std::string& name, short kind) {
  struct flock byte {};
  byte.l_type = kind;
  byte.l_whence = SEEK_SET;
  byte.l_start = byte_of(name);
  byte.l_len = 1;
  return byte;
}

/// Locks or unlocks the byte of a name, for this descriptor and not for the process: a lock goes
/// with the last copy of the descriptor.
bool set_lock(int handle, const std::string& name, short kind) {
  auto byte = byte_lock(name, kind);
  return ::fcntl(handle, F_OFD_SETLK, &byte) == 0;
}

}  // namespace

expected<document_lock> document_lock::take(const fs::path& file) {
  static std::map<fs::path, std::weak_ptr<folder>> folders;
  const auto conflict = [&](const char* where) {
    return fail(ec::conflict, file.string() + " is open already" + where,
                "Close it in the other TEdit first");
  };
  const auto path = file.parent_path() / ".tedit-lock";
  const std::lock_guard lock(guard());
  auto shared = folders[path].lock();
  if (!shared) {
    unique_fd opened(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
    if (!opened)
      return system_failure("cannot lock " + path.string(), errno);
    folders[path] = shared = std::make_shared<folder>(std::move(opened));
  }
  const auto name = file.filename().string();
  if (shared->held.contains(name))
    return conflict(" in this program");
  if (!set_lock(shared->handle.get(), name, F_WRLCK)) {
    if (errno == EAGAIN || errno == EACCES)
      return conflict(" in another program");
    return system_failure("cannot lock " + path.string(), errno);
  }
  shared->held.insert(name);
  document_lock taken;
  taken.folder_ = std::move(shared);
  taken.name_ = name;
  return taken;
}

bool document_lock::held(const fs::path& file) {
  // A descriptor of its own: what this process holds is asked for in the same way.
  const auto path = file.parent_path() / ".tedit-lock";
  const unique_fd handle(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
  auto byte = byte_lock(file.filename().string(), F_WRLCK);
  return handle && ::fcntl(handle.get(), F_OFD_GETLK, &byte) == 0 && byte.l_type != F_UNLCK;
}

document_lock& document_lock::operator=(document_lock&& other) noexcept {
  if (this != &other) {
    release();
    folder_ = std::move(other.folder_);
    name_ = std::move(other.name_);
  }
  return *this;
}

document_lock::~document_lock() {
  release();
}

void document_lock::release() noexcept {
  if (!folder_)
    return;
  const std::lock_guard lock(guard());
  set_lock(folder_->handle.get(), name_, F_UNLCK);
  folder_->held.erase(name_);
  folder_.reset();
}

}  // namespace tedit::store
