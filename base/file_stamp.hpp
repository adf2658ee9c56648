// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/stat.h>

#include <array>
#include <cstdint>
#include <filesystem>

namespace tedit {

/// Time, size and inode of a file: others say that it was changed or exchanged. Zeros: it is not
/// there.
using file_stamp = std::array<std::int64_t, 3>;

[[nodiscard]] inline file_stamp stamp_of(const std::filesystem::path& file) {
  struct stat about {};
  if (::stat(file.c_str(), &about) != 0)
    return {};
  return {about.st_mtim.tv_sec * std::int64_t{1'000'000'000} + about.st_mtim.tv_nsec, about.st_size,
          static_cast<std::int64_t>(about.st_ino)};
}

}  // namespace tedit
