// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <span>
#include <vector>

#include "base/error.hpp"
#include "base/execution.hpp"

namespace tedit {

/// What a forked call may use up.
struct forked_limits {
  std::chrono::milliseconds time{0};  ///< 0 for no limit.
  /// Memory that it may write, beyond what it begins with; 0 for no limit.
  std::size_t memory_bytes = 0;
  /// Called in the copy before the work, when given; then the copy has no other file open than
  /// its standard streams and the line to its caller. An error ends it.
  std::function<expected<void>()> confine;
  /// The programs that the work may have started by `run_child` although it is confined.
  std::vector<std::filesystem::path> programs = {};
};

/// The way of a forked call to its caller. Thread-safe.
class caller_line {
public:
  /// `pipe` for all messages, `memory` (a memfd) for the bytes of large ones.
  caller_line(int pipe, int memory);
  caller_line(const caller_line&) = delete;
  caller_line& operator=(const caller_line&) = delete;

  /// Sends one message. The process ends here when the line is closed.
  void send(std::uint32_t kind, std::span<const std::byte> bytes) const;

  /// The descriptors that must stay open.
  [[nodiscard]] std::array<int, 2> descriptors() const { return {pipe_, memory_}; }

private:
  int pipe_;
  int memory_;
  ino_t pipe_inode_;
  ino_t memory_inode_;
  mutable std::uint64_t written_ = 0;  ///< Bytes in `memory_`.
  mutable std::mutex mutex_;
};

/// What the caller does with a message, while the call runs.
using message_handler = std::function<void(std::uint32_t kind, std::span<const std::byte> bytes)>;

/// Calls `work` in a forked copy of this process and waits until it returns: a crash, an exit, a
/// hang or used up memory ends the copy alone. The copy's stdout is this process's stderr, its
/// stdin is empty. It is killed, with what it started, at the time limit, on cancel, and when this
/// process dies. Other threads of this process must not hold locks that `work` needs. Errors:
/// `service_unavailable`; `cancelled`; `timeout` and `internal`, whose message says how the copy
/// ended without a subject: "was killed by signal 11 (Segmentation fault)". Cost: some ms for each
/// GiB that this process has written.
[[nodiscard]] expected<void> call_forked(const std::function<void(const caller_line&)>& work,
                                         const forked_limits& limits, const execution& run,
                                         const message_handler& heard);

}  // namespace tedit
