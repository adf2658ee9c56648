// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/unique_fd.hpp"

namespace tedit {

namespace {

#ifdef TEDIT_SANITIZED
/// Sanitizers reserve terabytes of addresses for their shadow memory: no program would start.
constexpr bool limit_addresses = false;
#else
constexpr bool limit_addresses = true;
#endif

/// In the child between vfork and exec, in the parent's memory: system calls only.
[[noreturn]] void become(const std::vector<char*>& arguments, int in, int out, pid_t parent,
                         const child_limits& limits, const sigset_t& signals) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent)
    _exit(127);
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDERR_FILENO);
  if (limit_addresses && limits.memory_bytes > 0) {
    const rlimit limit{limits.memory_bytes, limits.memory_bytes};
    setrlimit(RLIMIT_AS, &limit);
  }
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  pthread_sigmask(SIG_SETMASK, &signals, nullptr);
  execv(arguments.front(), arguments.data());
  _exit(127);
}

/// The child's id; below zero with errno when there is none.
/// Not fork: to mark gigabytes of pages for copying, and each page's fault afterwards, cost more
/// than the child's work. No handler of a signal may run in the child, whose memory is ours.
pid_t start(const std::vector<char*>& arguments, int in, int out, const child_limits& limits) {
  const pid_t parent = getpid();
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t child = vfork();
  if (child == 0)
    become(arguments, in, out, parent, limits, before);
  const int reason = errno;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = reason;
  return child;
}

/// Moves bytes both ways until the child closes its output, the time is over or it is cancelled.
expected<std::vector<char>> exchange(unique_fd& to_child, unique_fd& from_child,
                                     std::span<const char> input,
                                     std::chrono::steady_clock::time_point deadline,
                                     const execution& run) {
  std::vector<char> output;
  std::array<char, 65536> buffer;
  while (true) {
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the work was cancelled");
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
      deadline - std::chrono::steady_clock::now());
    if (left.count() <= 0)
      return fail(ec::timeout, "a helper program did not end within its time limit");
    if (input.empty())
      to_child.reset();
    std::array<pollfd, 2> ends{{{from_child.get(), POLLIN, 0}, {to_child.get(), POLLOUT, 0}}};
    const int wait = static_cast<int>(std::min<std::int64_t>(left.count(), 50));
    if (poll(ends.data(), input.empty() ? 1 : 2, wait) < 0 && errno != EINTR)
      return fail(ec::internal, std::string("poll failed: ") + std::strerror(errno));
    if (!input.empty() && (ends[1].revents & (POLLOUT | POLLERR))) {
      const auto sent = write(to_child.get(), input.data(), input.size());
      if (sent > 0)
        input = input.subspan(static_cast<std::size_t>(sent));
      else if (errno != EAGAIN && errno != EINTR)
        input = {};  // The child stopped reading; its exit status says why.
    }
    if (ends[0].revents & (POLLIN | POLLHUP)) {
      const auto got = read(from_child.get(), buffer.data(), buffer.size());
      if (got == 0)
        return output;
      if (got > 0)
        output.insert(output.end(), buffer.data(), buffer.data() + got);
      else if (errno != EAGAIN && errno != EINTR)
        return output;
    }
  }
}

}  // namespace

std::filesystem::path executable_folder() {
  std::error_code code;
  return std::filesystem::read_symlink("/proc/self/exe", code).parent_path();
}

expected<std::vector<char>> run_child(const std::vector<std::string>& command,
                                      std::span<const char> input, const child_limits& limits,
                                      const execution& run) {
  const auto deadline = std::chrono::steady_clock::now() + limits.time;
  const std::string name = std::filesystem::path(command.front()).filename().string();
  if (access(command.front().c_str(), X_OK) != 0)
    return fail(ec::service_unavailable, "the program " + command.front() + " is not there",
                "Build or install it beside tedit, or set TEDIT_LIBEXEC to its folder");
  std::array<int, 2> in{};
  std::array<int, 2> out{};
  if (pipe2(in.data(), O_CLOEXEC) != 0)
    return fail(ec::service_unavailable, std::string("no pipe: ") + std::strerror(errno));
  unique_fd child_in(in[0]);
  unique_fd to_child(in[1]);
  if (pipe2(out.data(), O_CLOEXEC) != 0)
    return fail(ec::service_unavailable, std::string("no pipe: ") + std::strerror(errno));
  unique_fd from_child(out[0]);
  unique_fd child_out(out[1]);
  std::vector<char*> arguments;
  for (const auto& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  const pid_t child = start(arguments, child_in.get(), child_out.get(), limits);
  if (child < 0)
    return fail(ec::service_unavailable, name + " cannot be started: " + std::strerror(errno));
  child_in.reset();
  child_out.reset();
  fcntl(to_child.get(), F_SETFL, O_NONBLOCK);
  auto output = exchange(to_child, from_child, input, deadline, run);
  if (!output)
    kill(child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    // Interrupted by a signal of ours: wait on.
  }
  if (!output)
    return output;
  if (WIFSIGNALED(status))
    return fail(ec::mesher_failed,
                name + " crashed (signal " + std::to_string(WTERMSIG(status)) + ")");
  if (WEXITSTATUS(status) != 0)
    return fail(ec::mesher_failed,
                name + " gave up (exit status " + std::to_string(WEXITSTATUS(status)) + ")");
  return output;
}

}  // namespace tedit
