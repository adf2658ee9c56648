// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "base/misdeed.hpp"
#include "base/program_line.hpp"
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

/// The other process that starts programs for this one, where this one may not.
struct starter {
  unique_fd line;
  std::vector<std::filesystem::path> programs;  ///< Those that it starts.
};

starter& other_starter() {
  static starter one;
  return one;
}

struct pipe_ends {
  unique_fd out;
  unique_fd in;
};

expected<pipe_ends> make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    return fail(ec::service_unavailable, std::string("no pipe: ") + std::strerror(errno),
                "Close other programs, or raise the limit of open files (ulimit -n)");
  return pipe_ends{unique_fd(ends[0]), unique_fd(ends[1])};
}

/// A program that runs for this process, as its child or another's.
class child_program {
public:
  /// Errors: `service_unavailable`.
  static expected<child_program> start(const std::vector<std::string>& command, int in, int out,
                                       const child_limits& limits) {
    const auto name = std::filesystem::path(command.front()).filename().string();
    child_program made;
    if (other_starter().line)
      return ask(command, in, out);
    made.pid_ = start_program(command, in, out, limits);
    if (made.pid_ < 0)
      return fail(ec::service_unavailable, name + " cannot be started: " + std::strerror(errno));
    return made;
  }

  void end() {
    if (pid_ > 0)
      kill(pid_, SIGKILL);
    wanted_.reset();
  }

  /// Its status once it has ended, as `waitpid` gives it. Nothing when nobody can say.
  std::optional<int> wait() {
    int status = 0;
    ssize_t got = -1;
    do
      got = pid_ > 0 ? waitpid(pid_, &status, 0) : read(status_.get(), &status, sizeof(status));
    while (got < 0 && errno == EINTR);
    return pid_ > 0 || got == sizeof(status) ? std::optional(status) : std::nullopt;
  }

private:
  static expected<child_program> ask(const std::vector<std::string>& command, int in, int out) {
    const auto& hosted = other_starter().programs;
    const auto found = std::ranges::find(hosted, std::filesystem::path(command.front()));
    if (command.size() != 1 || found == hosted.end())
      return fail(ec::service_unavailable, "this process may not start " + command.front(),
                  "Operations and files run without other programs");
    auto status = make_pipe();
    auto wanted = make_pipe();
    if (!status || !wanted)
      return fail((status ? wanted : status).error());
    if (!send_descriptors(other_starter().line.get(),
                          {in, out, status->in.get(), wanted->out.get()},
                          static_cast<std::uint8_t>(found - hosted.begin())))
      return fail(ec::service_unavailable, "the process that starts programs for this one is gone");
    child_program made;
    made.status_ = std::move(status->out);
    made.wanted_ = std::move(wanted->in);
    return made;
  }

  pid_t pid_ = -1;    ///< Of a child of this process; else both others.
  unique_fd status_;  ///< Where its status comes from.
  unique_fd wanted_;  ///< Closed: it is ended.
};

/// As `write`; a child that stopped reading is an error (EPIPE), whatever this process does of
/// SIGPIPE: it may be one that nobody prepared, as a plugin's own.
ssize_t write_to_child(int to, std::span<const char> bytes) {
  sigset_t broken;
  sigset_t before;
  sigemptyset(&broken);
  sigaddset(&broken, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &broken, &before);
  const auto sent = write(to, bytes.data(), bytes.size());
  const int reason = errno;
  if (sent < 0 && reason == EPIPE) {
    const timespec at_once{};
    while (sigtimedwait(&broken, nullptr, &at_once) < 0 && errno == EINTR) {
    }
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = reason;
  return sent;
}

/// Moves bytes both ways until the child closes its output, the time is over or it is cancelled.
expected<std::vector<char>> exchange(unique_fd& to_child, unique_fd& from_child,
                                     std::span<const char> input,
                                     std::chrono::steady_clock::time_point deadline,
                                     std::size_t most, const std::string& name,
                                     const execution& run) {
  std::vector<char> output;
  std::array<char, 65536> buffer;
  while (true) {
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the work was cancelled");
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
      deadline - std::chrono::steady_clock::now());
    if (left.count() <= 0)
      return fail(ec::timeout, name + " did not end within its time limit",
                  "Try again when the machine has less to do, or take other values");
    if (input.empty())
      to_child.reset();
    std::array<pollfd, 2> ends{{{from_child.get(), POLLIN, 0}, {to_child.get(), POLLOUT, 0}}};
    const int wait = static_cast<int>(std::min<std::int64_t>(left.count(), 10));
    if (poll(ends.data(), input.empty() ? 1 : 2, wait) < 0 && errno != EINTR)
      return fail(ec::internal, std::string("poll failed: ") + std::strerror(errno));
    if (!input.empty() && (ends[1].revents & (POLLOUT | POLLERR))) {
      const auto sent = write_to_child(to_child.get(), input);
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
      if (most > 0 && output.size() > most)
        return fail(ec::mesher_failed, name + " wrote more than " + std::to_string(most) +
                                         " bytes, which is no answer");
    }
  }
}

}  // namespace

/// Not fork: to mark gigabytes of pages for copying, and each page's fault afterwards, cost more
/// than the child's work. No handler of a signal may run in the child, whose memory is ours.
pid_t start_program(const std::vector<std::string>& command, int in, int out,
                    const child_limits& limits) {
  std::vector<char*> arguments;
  for (const auto& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
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

void start_programs_by(unique_fd line, std::vector<std::filesystem::path> programs) {
  other_starter() = {std::move(line), std::move(programs)};
}

int program_line_fd() {
  return other_starter().line.get();
}

std::filesystem::path executable_folder() {
  std::error_code code;
  return std::filesystem::read_symlink("/proc/self/exe", code).parent_path();
}

std::filesystem::path helper_program(std::string_view name) {
  const char* folder = std::getenv("TEDIT_LIBEXEC");
  return (folder ? std::filesystem::path(folder) : executable_folder()) / name;
}

expected<std::vector<char>> run_child(const std::vector<std::string>& command,
                                      std::span<const char> input, const child_limits& limits,
                                      const execution& run) {
  const auto deadline = std::chrono::steady_clock::now() + limits.time;
  const std::string name = std::filesystem::path(command.front()).filename().string();
  if (access(command.front().c_str(), X_OK) != 0)
    return fail(ec::service_unavailable, "the program " + command.front() + " is not there",
                "Build or install it beside tedit, or set TEDIT_LIBEXEC to its folder");
  auto in = make_pipe();
  auto out = make_pipe();
  if (!in || !out)
    return fail((in ? out : in).error());
  auto child = child_program::start(command, in->out.get(), out->in.get(), limits);
  if (!child)
    return fail(child.error());
  in->out.reset();
  out->in.reset();
  fcntl(in->in.get(), F_SETFL, O_NONBLOCK);
  auto output = exchange(in->in, out->out, input, deadline, limits.output_bytes, name, run);
  if (!output)
    child->end();
  const auto status = child->wait();
  if (!output)
    return output;
  if (!status)
    return fail(ec::service_unavailable, name + " could not be started by the worker's keeper",
                "Try again; the server's log may say more");
  if (const auto deed = misdeed_of(*status))
    return fail(ec::mesher_failed, name + " " + *deed, misdeed_remedy);
  if (WIFSIGNALED(*status) && WTERMSIG(*status) == SIGPROF)
    return fail(ec::timeout, name + " found no end in the time that it may compute",
                "Take other values");
  if (WIFSIGNALED(*status))
    return fail(ec::mesher_failed,
                name + " crashed (signal " + std::to_string(WTERMSIG(*status)) + ")");
  if (WEXITSTATUS(*status) != 0)
    return fail(ec::mesher_failed,
                name + " gave up (exit status " + std::to_string(WEXITSTATUS(*status)) + ")");
  return output;
}

}  // namespace tedit
