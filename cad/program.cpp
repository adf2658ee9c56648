// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <ctime>

#include "base/child_process.hpp"
#include "base/misdeed.hpp"
#include "base/text.hpp"
#include "base/unique_fd.hpp"

namespace tedit::cad {

namespace {

using clock = std::chrono::steady_clock;

/// More than any line that the programs write.
constexpr std::size_t longest_line = 65536;

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  while (true) {
    const auto tab = line.find('\t');
    auto field = to_utf8(line.substr(0, tab));
    std::ranges::replace_if(
      field, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    fields.push_back(std::move(field));
    if (tab == std::string_view::npos)
      return fields;
    line.remove_prefix(tab + 1);
  }
}

/// What a program says while it runs.
class listener {
public:
  listener(program_end& end, const execution& run) : end_(end), run_(run) {}

  void hear(std::string_view bytes) {
    line_ += bytes;
    for (auto at = line_.find('\n'); at != std::string::npos; at = line_.find('\n')) {
      take(fields_of(std::string_view(line_).substr(0, at)));
      line_.erase(0, at + 1);
    }
    if (line_.size() > longest_line)
      line_.clear();
  }

private:
  void take(const std::vector<std::string>& fields) {
    if (fields.size() == 3 && fields[0] == "S") {
      double fraction = 0;
      std::from_chars(fields[1].data(), fields[1].data() + fields[1].size(), fraction);
      farthest_ = std::max(farthest_, std::min(fraction, 1.0));
      end_.doing = fields[2];
      run_.report(farthest_, end_.doing);
    } else if (fields.size() == 5 && fields[0] == "E") {
      end_.why = {code_from_name(fields[1]), fields[2], fields[3], fields[4]};
    }
  }

  program_end& end_;
  const execution& run_;
  std::string line_;
  double farthest_ = 0;
};

/// Why it was stopped from here; nothing when it closed its line itself.
enum class stop { none, time, cancel };

stop listen(int from, clock::time_point deadline, listener& to, const execution& run) {
  std::array<char, 4096> buffer;
  while (true) {
    if (run.cancel.cancelled())
      return stop::cancel;
    const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(deadline - clock::now());
    if (left.count() <= 0)
      return stop::time;
    pollfd line{from, POLLIN, 0};
    if (poll(&line, 1, static_cast<int>(std::min<std::int64_t>(left.count(), 50))) <= 0)
      continue;
    const auto got = read(from, buffer.data(), buffer.size());
    if (got == 0 || (got < 0 && errno != EINTR && errno != EAGAIN))
      return stop::none;
    if (got > 0)
      to.hear({buffer.data(), static_cast<std::size_t>(got)});
  }
}

/// A program that closed its line may still be there: its status, once it has ended or was ended.
int wait_for(pid_t pid, clock::time_point deadline, stop& stopped, const execution& run) {
  constexpr timespec pause{0, 1'000'000};
  int status = 0;
  while (waitpid(pid, &status, WNOHANG) == 0) {
    if (stopped == stop::none && run.cancel.cancelled())
      stopped = stop::cancel;
    if (stopped == stop::none && clock::now() >= deadline)
      stopped = stop::time;
    if (stopped != stop::none)
      kill(pid, SIGKILL);
    nanosleep(&pause, nullptr);
  }
  return status;
}

std::string while_doing(const program_end& end) {
  return end.doing.empty() ? " before it began" : " while " + end.doing;
}

error time_is_up(const std::string& what, const program_end& end, const program_limits& limits) {
  return {
    ec::timeout,
    what + " took longer than " + std::to_string(limits.time.count()) + " s" + while_doing(end),
    "Give it more time, mesh it coarser, or take a simpler part",
    {}};
}

/// How one ended that said nothing of why.
error reason_of(int status, const std::string& what, const program_end& end,
                const program_limits& limits) {
  if (const auto deed = misdeed_of(status))
    return {ec::service_unavailable,
            what + " " + *deed + while_doing(end),
            "The file may be made to do harm: nothing was changed. Report it if it is yours",
            {}};
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))
    return time_is_up(what, end, limits);
  const bool by_signal = WIFSIGNALED(status);
  return {ec::bad_input,
          what + " died" + while_doing(end) +
            (by_signal ? " (signal " + std::to_string(WTERMSIG(status)) + ")"
                       : " (exit status " + std::to_string(WEXITSTATUS(status)) + ")"),
          "Nothing else is lost. Export the part again from the CAD program, as AP203 or AP214 "
          "without annotations, or with fewer details",
          {}};
}

struct running {
  pid_t pid = -1;
  unique_fd line;
};

running start(const std::string& name, const std::filesystem::path& folder,
              const std::vector<std::string>& arguments, const program_limits& limits) {
  std::vector<std::string> command{helper_program(name).string(), folder.string(),
                                   std::to_string(limits.time.count()),
                                   std::to_string(limits.file_bytes)};
  command.insert(command.end(), arguments.begin(), arguments.end());
  std::array<int, 2> ends{};
  const unique_fd nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));
  if (!nothing || pipe2(ends.data(), O_CLOEXEC) != 0)
    return {};
  running made{-1, unique_fd(ends[0])};
  const unique_fd to(ends[1]);
  made.pid = start_program(command, nothing.get(), to.get(), {limits.time, limits.memory_bytes});
  return made;
}

}  // namespace

expected<void> find_program(const std::string& name) {
  const auto path = helper_program(name);
  if (access(path.c_str(), X_OK) == 0)
    return {};
  return fail(ec::service_unavailable,
              "this installation reads no CAD files: there is no " + path.string(),
              "Build TEdit where the packages libocct-data-exchange-dev and libgmsh-dev are "
              "installed (scripts/install_deps.sh), or set TEDIT_LIBEXEC to the program's folder");
}

program_end run_program(const std::string& name, const std::string& what,
                        const std::filesystem::path& folder,
                        const std::vector<std::string>& arguments, const program_limits& limits,
                        const execution& run) {
  program_end end;
  const auto child = start(name, folder, arguments, limits);
  if (child.pid < 0) {
    end.why = {ec::service_unavailable,
               what + " cannot be started: " + std::strerror(errno),
               "Close other programs, or raise the limits of open files and processes",
               {}};
    return end;
  }
  const auto deadline = clock::now() + std::max(limits.time, limits.clock);
  listener hears(end, run);
  auto stopped = listen(child.line.get(), deadline, hears, run);
  const int status = wait_for(child.pid, deadline, stopped, run);
  const bool refused = !end.why.message.empty();
  end.done = stopped == stop::none && !refused && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (stopped == stop::cancel) {
    end.why = {ec::cancelled, "the import was cancelled", "", {}};
  } else if (stopped == stop::time) {
    end.by_clock = true;
    end.why = time_is_up(what, end, limits);
  } else if (!end.done && !refused) {
    end.why = reason_of(status, what, end, limits);
    end.died = end.why.code == ec::bad_input;
  }
  return end;
}

}  // namespace tedit::cad
