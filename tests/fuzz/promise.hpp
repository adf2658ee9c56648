// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>

#include "base/error.hpp"
#include "base/unique_fd.hpp"

namespace tedit::fuzz {

/// A broken promise counts as a crash, so that libFuzzer keeps the input.
inline void require(bool holds, const char* promise, const std::string& detail = {}) {
  if (holds)
    return;
  std::fprintf(stderr, "broken promise: %s %s\n", promise, detail.c_str());
  std::abort();
}

/// What a person reads when bytes are refused.
inline void require_reason(const error& failure) {
  require(!failure.message.empty(), "a refusal says why");
  require(failure.code != ec::internal, "a refusal is no defect:", render(failure));
}

/// Bytes as a file that only its owner reads, without a disk.
class memory_file {
public:
  explicit memory_file(std::span<const std::uint8_t> bytes)
      : file_(::memfd_create("fuzz", MFD_CLOEXEC)) {
    require(static_cast<bool>(file_) && ::fchmod(file_.get(), 0600) == 0, "a file can be made");
    for (std::size_t done = 0; done < bytes.size();) {
      const auto wrote = ::write(file_.get(), bytes.data() + done, bytes.size() - done);
      require(wrote > 0, "a file can be written");
      done += static_cast<std::size_t>(wrote);
    }
  }
  [[nodiscard]] std::filesystem::path path() const {
    return "/proc/self/fd/" + std::to_string(file_.get());
  }

private:
  unique_fd file_;
};

/// Takes numbers from the front of bytes, and zeros once they are used up.
class input {
public:
  explicit input(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  [[nodiscard]] std::span<const std::uint8_t> rest() const { return rest_; }

  /// A number of `bytes` bytes, the highest first.
  std::uint64_t number(unsigned bytes) {
    std::uint64_t result = 0;
    for (const auto one : take(bytes))
      result = result << 8 | one;
    return result;
  }
  /// As many bytes as are there, `size` at most.
  std::span<const std::uint8_t> take(std::size_t size) {
    const auto part = rest_.first(size < rest_.size() ? size : rest_.size());
    rest_ = rest_.subspan(part.size());
    return part;
  }

private:
  std::span<const std::uint8_t> rest_;
};

}  // namespace tedit::fuzz
