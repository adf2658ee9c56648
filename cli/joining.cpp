// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/joining.hpp"

#include <poll.h>
#include <sys/types.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <optional>
#include <string_view>
#include <utility>

#include "base/process.hpp"

namespace tedit::cli {

namespace {

using clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds first_pause{500};
constexpr milliseconds longest_pause{30000};
/// For one that was killed: the server waits ten seconds for the only worker of a role.
constexpr milliseconds killed_pause{4000};

/// A worker that lived so long had joined, or was killed long after it did: the next one need not
/// wait. What ends by itself may have waited for the server in vain.
constexpr std::chrono::seconds good_life{60}, joined_life{1};

/// What is waited for comes at least so late, and a signal is heard at once.
void pause(milliseconds so_long) {
  ::poll(nullptr, 0, static_cast<int>(so_long.count()));
}

/// How the process ended. A cancelled one is asked to leave, and has as long as its work takes.
std::string wait_for(pid_t pid, const cancel_token& stop) {
  bool asked = false;
  for (;;) {
    if (auto how = reap_process(pid))
      return *how;
    if (stop.cancelled() && !std::exchange(asked, true))
      ::kill(pid, SIGTERM);
    pause(milliseconds(200));
  }
}

/// "ended with status 1": the number; nothing for a process that a signal ended.
std::optional<int> status_in(const std::string& how) {
  constexpr std::string_view before = "ended with status ";
  int status = 0;
  if (!how.starts_with(before) ||
      std::from_chars(how.data() + before.size(), how.data() + how.size(), status).ec !=
        std::errc())
    return std::nullopt;
  return status;
}

/// Trying again would come to the same: bad options, files or certificates.
bool is_final(int status) {
  return status == exit_status(ec::usage) || status == exit_status(ec::bad_input) ||
         status == exit_status(ec::invalid_argument);
}

}  // namespace

expected<host_and_port> parse_place(const std::string& text) {
  const auto colon = text.rfind(':');
  host_and_port place;
  unsigned port = 0;
  const auto* const end = text.data() + text.size();
  if (colon != std::string::npos) {
    const auto read = std::from_chars(text.data() + colon + 1, end, port);
    place.host = text.substr(0, colon);
    if (read.ec != std::errc() || read.ptr != end)
      port = 0;
  }
  if (place.host.starts_with('[') && place.host.ends_with(']'))
    place.host = place.host.substr(1, place.host.size() - 2);
  else if (place.host.find(':') != std::string::npos)
    place.host.clear();
  if (place.host.empty() || port == 0 || port > 65535)
    return fail(ec::usage, "\"" + text + "\" is no place to join",
                "Give the server's host and port as HOST:PORT, such as rack-1:7465 or [::1]:7465");
  place.port = static_cast<std::uint16_t>(port);
  return place;
}

int keep_joined(const std::vector<std::string>& command, session& s) {
  auto wait = first_pause;
  while (!s.cancel.cancelled()) {
    const auto began = clock::now();
    const auto pid = spawn_process(command);
    if (!pid)
      return print_error(s, pid.error());
    const auto how = wait_for(*pid, s.cancel);
    const auto status = status_in(how);
    if (s.cancel.cancelled())
      break;
    if (status && is_final(*status))
      return *status;
    if (clock::now() - began > (status ? good_life : joined_life))
      wait = first_pause;
    notice(s, "the worker " + how + "; joining again in " +
                std::to_string(std::max<long>(1, std::lround(wait.count() / 1000.0))) + " s");
    const auto until = clock::now() + wait;
    while (!s.cancel.cancelled() && clock::now() < until)
      pause(std::min(milliseconds(200), wait));
    wait = std::min(2 * wait, status ? longest_pause : killed_pause);
  }
  return 0;
}

}  // namespace tedit::cli
