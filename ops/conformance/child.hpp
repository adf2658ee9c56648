// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/execution.hpp"

namespace tedit::ops {

struct sandbox_limits {
  std::chrono::milliseconds step{10000};  ///< From one `mark` of the child to the next.
  std::size_t memory_bytes = 0;           ///< Address space; 0 for no limit.
  cancel_token cancel;                    ///< Ends the child at once.
  /// Called in the child before the work, in its folder; an error is a death.
  std::function<expected<void>()> confine;
  std::vector<std::filesystem::path> programs = {};  ///< Those that the child may have started.
};

/// The child's way to its parent.
class child_reporter {
public:
  explicit child_reporter(int fd) : fd_(fd) {}

  /// Says what begins now: the time limit starts anew, and a crash is told with these words.
  void mark(const std::string& what) const { write_line('>', what); }
  /// One line of the result.
  void say(const std::string& line) const { write_line('=', line); }

private:
  void write_line(char kind, const std::string& text) const;

  int fd_;
};

/// What became of a child.
struct child_outcome {
  std::vector<std::string> lines;  ///< What it said, also when it died later.
  std::string doing;               ///< The last mark.
  std::string death;  ///< "crashed with signal 11 (Segmentation fault)"; empty when it ended.
  std::vector<std::string> last_stderr;  ///< The last lines that it wrote there, at most 20.
  std::string out;                       ///< What it wrote to stdout, at most 4096 characters.
};

/// Calls `work` in a forked child of this process, in `folder`, and waits for it. The child and
/// what it started are killed when it passes a limit. Only while the process has one thread.
[[nodiscard]] child_outcome run_forked(const std::function<void(const child_reporter&)>& work,
                                       const std::filesystem::path& folder,
                                       const sandbox_limits& limits);

/// What was written to this child's stdout up to now.
[[nodiscard]] std::size_t bytes_on_stdout();

}  // namespace tedit::ops
