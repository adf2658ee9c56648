// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "tests/scenarios/served.hpp"

namespace tedit::test {

/// Servers that are started while it lives have a disk that fails when asked to (failing_disk.cpp).
class disk_fault {
public:
  explicit disk_fault(const scratch_folder& folder) : file_(folder.path() / "fault") {
    setenv("LD_PRELOAD", TEDIT_FAILING_DISK, 1);
    setenv("TEDIT_DISK_FAULT", file_.c_str(), 1);
  }
  disk_fault(const disk_fault&) = delete;
  disk_fault& operator=(const disk_fault&) = delete;
  ~disk_fault() {
    unsetenv("LD_PRELOAD");
    unsetenv("TEDIT_DISK_FAULT");
  }

  /// Whole or not at all: the server may look at any moment.
  void begin(const std::string& what) const {
    const auto draft = file_.string() + "-new";
    std::ofstream(draft) << what;
    std::filesystem::rename(draft, file_);
  }
  void end() const { std::filesystem::remove(file_); }

  /// Sanitizers want to be loaded first.
  static constexpr bool possible =
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    false;
#else
    true;
#endif

private:
  std::filesystem::path file_;
};

}  // namespace tedit::test
