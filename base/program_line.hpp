// SPDX-License-Identifier: AGPL-3.0-or-later
// A process that may start no program has one started for it by the process that it came from.
#pragma once

#include <poll.h>
#include <sys/types.h>

#include <cstdint>
#include <list>
#include <vector>

#include "base/child_process.hpp"
#include "base/unique_fd.hpp"

namespace tedit {

/// Both ends of a line that carries descriptors.
struct line_ends {
  unique_fd ours;
  unique_fd theirs;
};

/// Errors: `service_unavailable`.
[[nodiscard]] expected<line_ends> make_line();

/// Hands descriptors over, and a number beside them; false when the other end is gone.
[[nodiscard]] bool send_descriptors(int line, const std::vector<int>& descriptors,
                                    std::uint8_t number = 0);

/// What came in one message.
struct taken_descriptors {
  std::vector<unique_fd> all;  ///< Each closed by exec.
  std::uint8_t number = 0;
};

/// None when there is no message, or at the line's end, which sets `ended`.
[[nodiscard]] taken_descriptors take_descriptors(int line, bool& ended, bool wait = false);

/// Starts some programs, and no others, for whoever holds the other end of the line: it sends its
/// ends of pipes and the program's place in the list, and nothing else. For one thread.
class program_host {
public:
  program_host(unique_fd line, std::vector<std::filesystem::path> programs,
               const child_limits& limits)
      : line_(std::move(line)), programs_(std::move(programs)), limits_(limits) {}
  program_host(const program_host&) = delete;
  program_host& operator=(const program_host&) = delete;
  ~program_host();  ///< Ends what it started.

  /// Adds what to wait for before the next `look`.
  void wait_for(std::vector<pollfd>& list) const;

  /// Takes orders, ends what nobody wants any more and tells how the others ended.
  void look();

private:
  struct running {
    pid_t pid = -1;
    unique_fd end;     ///< Readable when it has ended.
    unique_fd status;  ///< Where its status goes.
    unique_fd wanted;  ///< Closed at the other side when it is not wanted any more.
  };

  void start(taken_descriptors order);

  static constexpr std::size_t most_at_once = 16;

  unique_fd line_;
  std::vector<std::filesystem::path> programs_;
  child_limits limits_;
  std::list<running> all_;
};

/// From now on `run_child` of this process asks at `line` for the programs that are hosted there,
/// in the host's order, and can start no other and none with arguments.
void start_programs_by(unique_fd line, std::vector<std::filesystem::path> programs);

/// The line's number, or -1: what a process keeps open that closes all else.
[[nodiscard]] int program_line_fd();

}  // namespace tedit
