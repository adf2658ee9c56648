// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/conformance/child.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <optional>
#include <sstream>
#include <thread>

#include "base/misdeed.hpp"
#include "base/program_line.hpp"

namespace tedit::ops {

namespace {

using clock = std::chrono::steady_clock;

constexpr int status_not_confined = 118;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
/// Sanitizers reserve terabytes of addresses for their shadow memory.
constexpr bool limit_addresses = false;
#else
constexpr bool limit_addresses = true;
#endif

/// A file without a name that parent and child share. Each write goes to its end: threads that
/// write at once by the file's position would write over each other.
class shared_file {
public:
  shared_file() : fd_(memfd_create("tedit-conformance", MFD_CLOEXEC)) {
    fcntl(fd_, F_SETFL, O_APPEND);
  }
  shared_file(const shared_file&) = delete;
  shared_file& operator=(const shared_file&) = delete;
  ~shared_file() { close(fd_); }

  [[nodiscard]] int get() const { return fd_; }

  [[nodiscard]] std::size_t size() const {
    struct stat info {};
    return fstat(fd_, &info) == 0 ? static_cast<std::size_t>(info.st_size) : 0;
  }

  [[nodiscard]] std::string content(std::size_t most) const { return part(0, most); }
  [[nodiscard]] std::string end(std::size_t most) const {
    return part(size() - std::min(size(), most), most);
  }

private:
  [[nodiscard]] std::string part(std::size_t from, std::size_t most) const {
    std::string text(std::min(size(), most), '\0');
    const auto got = pread(fd_, text.data(), text.size(), static_cast<off_t>(from));
    text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return text;
  }

  int fd_;
};

[[noreturn]] void become_child(const std::function<void(const child_reporter&)>& work,
                               const std::filesystem::path& folder, const sandbox_limits& limits,
                               unique_fd programs, int report, int out, int err) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int number : {SIGINT, SIGTERM, SIGPIPE, SIGABRT})
    signal(number, SIG_DFL);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  if (limit_addresses && limits.memory_bytes > 0) {
    const rlimit limit{limits.memory_bytes, limits.memory_bytes};
    setrlimit(RLIMIT_AS, &limit);
  }
  // What a plugin leaves behind shall lie where it is found.
  for (const char* name : {"HOME", "TMPDIR", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"})
    setenv(name, folder.c_str(), 1);
  if (programs)
    start_programs_by(std::move(programs), limits.programs);
  if (chdir(folder.c_str()) == 0) {
    if (limits.confine)
      if (const auto done = limits.confine(); !done) {
        std::cerr << render(done.error()) << std::endl;
        _exit(status_not_confined);
      }
    work(child_reporter(report));
  }
  std::cout.flush();
  std::fflush(nullptr);
  _exit(0);
}

std::string describe_death(int status) {
  if (auto deed = misdeed_of(status))
    return *deed;
  if (WIFSIGNALED(status))
    return "crashed with signal " + std::to_string(WTERMSIG(status)) + " (" +
           strsignal(WTERMSIG(status)) + ")";
  if (WEXITSTATUS(status) == status_not_confined)
    return "could not be confined";
  if (WEXITSTATUS(status) != 0)
    return "ended the process with status " + std::to_string(WEXITSTATUS(status));
  return {};
}

/// Waits for the end of the child; kills it when its file has not grown for a step's time.
std::string wait_for(pid_t child, const shared_file& report, const sandbox_limits& limits,
                     program_host* programs) {
  const auto step = limits.step;
  auto size = report.size();
  auto deadline = clock::now() + step;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (const auto now = report.size(); now != size) {
      size = now;
      deadline = clock::now() + step;
    }
    const bool cancelled = limits.cancel.cancelled();
    if (cancelled || clock::now() > deadline) {
      kill(-child, SIGKILL);
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return cancelled ? "was cancelled"
                       : "did not end within " + std::to_string(step.count()) + " ms";
    }
    if (programs)
      programs->look();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  kill(-child, SIGKILL);  // What the plugin started and left.
  return describe_death(status);
}

std::vector<std::string> last_lines(const std::string& text) {
  constexpr std::size_t most = 20;
  std::vector<std::string> result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(' ') != std::string::npos)
      result.push_back(line.substr(0, 0x100));
  result.erase(result.begin(),
               result.end() - static_cast<std::ptrdiff_t>(std::min(most, result.size())));
  return result;
}

}  // namespace

void child_reporter::write_line(char kind, const std::string& text) const {
  std::string line = kind + text + "\n";
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    if (line[i] == '\n')
      line[i] = ' ';
  // Straight to the kernel: what was said stays said when the process dies.
  if (write(fd_, line.data(), line.size()) < 0)
    _exit(125);
}

child_outcome run_forked(const std::function<void(const child_reporter&)>& work,
                         const std::filesystem::path& folder, const sandbox_limits& limits) {
  const shared_file report;
  const shared_file out;
  const shared_file err;
  child_outcome result;
  std::cout.flush();
  std::fflush(nullptr);  // Else the child would print it a second time.
  line_ends programs;
  if (limits.confine && !limits.programs.empty())
    programs = make_line().value_or(line_ends{});
  const pid_t child = fork();
  if (child == 0) {
    programs.ours.reset();
    become_child(work, folder, limits, std::move(programs.theirs), report.get(), out.get(),
                 err.get());
  }
  programs.theirs.reset();
  if (child < 0) {
    result.death = std::string("could not be started: ") + std::strerror(errno);
    return result;
  }
  std::optional<program_host> host;
  if (programs.ours)
    host.emplace(std::move(programs.ours), limits.programs, child_limits{});
  result.death = wait_for(child, report, limits, host ? &*host : nullptr);
  std::istringstream lines(report.content(std::size_t{64} << 20));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('>'))
      result.doing = line.substr(1);
    else if (line.starts_with('='))
      result.lines.push_back(line.substr(1));
  }
  result.last_stderr = last_lines(err.end(65536));
  result.out = out.content(4096);
  return result;
}

std::size_t bytes_on_stdout() {
  std::cout.flush();
  std::fflush(nullptr);
  struct stat info {};
  return fstat(STDOUT_FILENO, &info) == 0 ? static_cast<std::size_t>(info.st_size) : 0;
}

}  // namespace tedit::ops
