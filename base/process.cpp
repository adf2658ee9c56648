// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/misdeed.hpp"

namespace tedit {

namespace {

/// Pointers to the texts and a null behind them, as exec wants them.
std::vector<char*> pointers(const std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (const auto& text : texts)
    result.push_back(const_cast<char*>(text.c_str()));
  result.push_back(nullptr);
  return result;
}

}  // namespace

expected<pid_t> spawn_process(const std::vector<std::string>& command, int inherited) {
  if (access(command.front().c_str(), X_OK) != 0)
    return fail(ec::service_unavailable, "the program " + command.front() + " is not there",
                "Build or install TEdit again");
  // Everything that allocates stands before the fork: other threads may hold the allocator's locks.
  const auto arguments = pointers(command);
  const int nowhere = open("/dev/null", O_RDONLY | O_CLOEXEC);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
      _exit(127);
    setpgid(0, 0);
    dup2(nowhere, STDIN_FILENO);
    dup2(STDERR_FILENO, STDOUT_FILENO);
    if (inherited == inherited_fd)
      fcntl(inherited, F_SETFD, 0);  // dup2 onto itself would leave it closed by exec.
    else if (inherited >= 0)
      dup2(inherited, inherited_fd);
    close_range(inherited >= 0 ? inherited_fd + 1 : inherited_fd, ~0U, 0);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    execv(arguments.front(), arguments.data());
    _exit(127);
  }
  const int reason = errno;
  close(nowhere);
  if (child < 0)
    return fail(ec::service_unavailable,
                command.front() + " cannot be started: " + std::strerror(reason));
  return child;
}

void close_files_except(std::vector<int> kept) {
  std::ranges::sort(kept);
  int next = STDERR_FILENO + 1;
  for (const int fd : kept) {
    if (fd > next)
      close_range(static_cast<unsigned>(next), static_cast<unsigned>(fd) - 1, 0);
    next = std::max(next, fd + 1);
  }
  close_range(static_cast<unsigned>(next), ~0U, 0);
}

std::string describe_end(int status) {
  if (auto deed = misdeed_of(status))
    return *deed;
  if (WIFSIGNALED(status))
    return "was killed by signal " + std::to_string(WTERMSIG(status)) + " (" +
           strsignal(WTERMSIG(status)) + ")";
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

std::optional<std::string> reap_process(pid_t pid) {
  int status = 0;
  const pid_t ended = waitpid(pid, &status, WNOHANG);
  if (ended == 0 || (ended < 0 && errno == EINTR))
    return std::nullopt;
  if (ended < 0)
    return "is gone";
  return describe_end(status);
}

void kill_process(pid_t pid) {
  kill(pid, SIGKILL);
  while (waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
    // Interrupted by a signal of ours: wait on.
  }
}

}  // namespace tedit
