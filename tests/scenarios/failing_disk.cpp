// SPDX-License-Identifier: AGPL-3.0-or-later
// Loaded before the C library (LD_PRELOAD): writes of documents fail as the file that
// $TEDIT_DISK_FAULT names says, while it is there: "write" (EIO), "sync" (EIO) or "full" (ENOSPC).
// A document's file that gets another name: "rename" (EIO), "folder" (its folder cannot be synced),
// "end-before" and "end-after" (kill -9 at that moment).
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

namespace {

/// What fails now; empty when nothing does.
std::string fault() {
  const char* path = std::getenv("TEDIT_DISK_FAULT");
  const int fd = path ? open(path, O_RDONLY | O_CLOEXEC) : -1;
  std::array<char, 16> text{};
  const auto size = fd < 0 ? 0 : read(fd, text.data(), text.size());
  if (fd >= 0)
    close(fd);
  return {text.data(), size > 0 ? static_cast<std::size_t>(size) : 0};
}

bool is_document(int fd) {
  std::array<char, 4096> target{};
  const auto link = "/proc/self/fd/" + std::to_string(fd);
  const auto size = readlink(link.c_str(), target.data(), target.size());
  return size > 0 &&
         std::string_view(target.data(), static_cast<std::size_t>(size)).find(".tedit") !=
           std::string_view::npos;
}

/// The reason why a write to this file fails; 0: it does not.
int write_fault(int fd) {
  const auto what = fault();
  if ((what != "write" && what != "full") || !is_document(fd))
    return 0;
  return what == "full" ? ENOSPC : EIO;
}

bool sync_fails(int fd) {
  struct stat about {};
  const auto what = fault();
  return (what == "sync" && is_document(fd)) ||
         (what == "folder" && fstat(fd, &about) == 0 && S_ISDIR(about.st_mode));
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

template <class Call>
ssize_t write_or_fail(int fd, Call call) {
  if (const int why = write_fault(fd); why != 0) {
    errno = why;
    return -1;
  }
  return call();
}

int sync_or_fail(int fd, const char* name) {
  if (sync_fails(fd)) {
    errno = EIO;
    return -1;
  }
  return next<int(int)>(name)(fd);
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) ssize_t pwrite(int fd, const void* data, size_t size,
                                                      off_t at) {
  return write_or_fail(fd, [&] {
    return next<ssize_t(int, const void*, size_t, off_t)>("pwrite")(fd, data, size, at);
  });
}

__attribute__((visibility("default"))) ssize_t pwrite64(int fd, const void* data, size_t size,
                                                        off64_t at) {
  return write_or_fail(fd, [&] {
    return next<ssize_t(int, const void*, size_t, off64_t)>("pwrite64")(fd, data, size, at);
  });
}

__attribute__((visibility("default"))) int fdatasync(int fd) {
  return sync_or_fail(fd, "fdatasync");
}

__attribute__((visibility("default"))) int fsync(int fd) {
  return sync_or_fail(fd, "fsync");
}

__attribute__((visibility("default"))) int renameat2(int from_folder, const char* from,
                                                     int to_folder, const char* to,
                                                     unsigned flags) noexcept {
  const auto what = fault();
  if (what == "end-before")
    raise(SIGKILL);
  if (what == "rename") {
    errno = EIO;
    return -1;
  }
  const int done = next<int(int, const char*, int, const char*, unsigned)>("renameat2")(
    from_folder, from, to_folder, to, flags);
  if (what == "end-after")
    raise(SIGKILL);
  return done;
}

}  // extern "C"
