// SPDX-License-Identifier: AGPL-3.0-or-later
// Loaded before the C library (LD_PRELOAD): the process ends by kill -9 right before it changes a
// document's file, or what lies beside it, for the time that $TEDIT_DIE_AT says; counted from 1.
#include <dlfcn.h>
#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

namespace {

bool is_of_document(std::string_view path) {
  return path.find(".tedit") != std::string_view::npos &&
         path.find(".tedit-lock") == std::string_view::npos;
}

/// One change more.
void count() {
  static const char* wanted = std::getenv("TEDIT_DIE_AT");
  static int changes = 0;
  if (wanted && ++changes == std::atoi(wanted))
    raise(SIGKILL);
}

void count_of(int fd) {
  std::array<char, 4096> target{};
  const auto link = "/proc/self/fd/" + std::to_string(fd);
  const auto size = readlink(link.c_str(), target.data(), target.size());
  if (size > 0 && is_of_document({target.data(), static_cast<std::size_t>(size)}))
    count();
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) ssize_t pwrite(int fd, const void* data, size_t size,
                                                      off_t at) {
  count_of(fd);
  return next<ssize_t(int, const void*, size_t, off_t)>("pwrite")(fd, data, size, at);
}

__attribute__((visibility("default"))) ssize_t pwrite64(int fd, const void* data, size_t size,
                                                        off64_t at) {
  count_of(fd);
  return next<ssize_t(int, const void*, size_t, off64_t)>("pwrite64")(fd, data, size, at);
}

__attribute__((visibility("default"))) int ftruncate64(int fd, off64_t size) noexcept {
  count_of(fd);
  return next<int(int, off64_t)>("ftruncate64")(fd, size);
}

__attribute__((visibility("default"))) int fdatasync(int fd) {
  count_of(fd);
  return next<int(int)>("fdatasync")(fd);
}

__attribute__((visibility("default"))) int fsync(int fd) {
  count_of(fd);
  return next<int(int)>("fsync")(fd);
}

__attribute__((visibility("default"))) int unlink(const char* path) noexcept {
  if (is_of_document(path))
    count();
  return next<int(const char*)>("unlink")(path);
}

}  // extern "C"
