// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/virtual_display.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>

namespace tedit {

expected<virtual_display> virtual_display::open() {
  if (const char* name = std::getenv("DISPLAY"); name && *name)
    return virtual_display(-1);
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0)
    return fail(ec::service_unavailable, "no pipe for Xvfb");
  const pid_t child = fork();
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int nowhere = ::open("/dev/null", O_RDWR);
    dup2(nowhere, STDIN_FILENO);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    const std::string number = std::to_string(ends[1]);
    // The server picks a free display and writes its number to the pipe once it listens.
    execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1920x1200x24",
           "-nolisten", "tcp", nullptr);
    _exit(127);
  }
  close(ends[1]);
  std::string number;
  char c = 0;
  pollfd end{ends[0], POLLIN, 0};
  while (child > 0 && poll(&end, 1, 20000) > 0 && read(ends[0], &c, 1) == 1 && c != '\n')
    number += c;
  close(ends[0]);
  if (number.empty()) {
    if (child > 0) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
    }
    return fail(ec::service_unavailable, "there is no display and Xvfb does not start",
                "Install the Debian package xvfb, or set DISPLAY");
  }
  setenv("DISPLAY", (":" + number).c_str(), 1);
  return virtual_display(child);
}

virtual_display::~virtual_display() {
  if (server_ <= 0)
    return;
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
}

}  // namespace tedit
