// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/misdeed.hpp"

#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace tedit {

namespace {

/// By `misdeed`.
constexpr std::array words{"tried to open a network connection",
                           "tried to start a program",
                           "tried to start a process",
                           "tried to reach into another process",
                           "tried to gain other rights",
                           "tried to use a part of the system that is closed to it",
                           "filled its folder for temporary files"};

/// The C library blocks all signals while it starts a process: then there is no status.
constexpr auto without_status = "tried to start a program, or something else that it may not do";

}  // namespace

std::optional<std::string> misdeed_of(int status) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGSYS)
    return without_status;
  const int row = WEXITSTATUS(status) - status_of(misdeed::network);
  if (!WIFEXITED(status) || row < 0 || row >= static_cast<int>(words.size()))
    return std::nullopt;
  return words[static_cast<std::size_t>(row)];
}

bool is_misdeed(const std::string& how) {
  return how == without_status || std::ranges::find(words, how) != words.end();
}

}  // namespace tedit
