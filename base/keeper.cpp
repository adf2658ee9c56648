// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/keeper.hpp"

#include <poll.h>
#include <sys/inotify.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "base/misdeed.hpp"
#include "base/process.hpp"
#include "base/program_line.hpp"

namespace tedit {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view folder_prefix = "tedit-worker-";

fs::path folder_of(pid_t keeper) {
  std::error_code code;
  const auto all = fs::temp_directory_path(code);
  return code ? fs::path() : all / (std::string(folder_prefix) + std::to_string(keeper));
}

/// Not a link, nor another user's.
bool is_own_folder(const fs::path& path) {
  struct stat about {};
  return lstat(path.c_str(), &about) == 0 && S_ISDIR(about.st_mode) && about.st_uid == geteuid();
}

/// Those of keepers that were killed, and their servers with them.
void remove_left_folders() {
  std::error_code code;
  for (const auto& item : fs::directory_iterator(fs::temp_directory_path(code), code)) {
    const auto name = item.path().filename().string();
    pid_t keeper = 0;
    if (!name.starts_with(folder_prefix) ||
        std::from_chars(name.data() + folder_prefix.size(), name.data() + name.size(), keeper)
            .ptr != name.data() + name.size())
      continue;
    if (keeper > 0 && kill(keeper, 0) != 0 && errno == ESRCH)
      remove_temporary_folder(keeper);
  }
}

fs::path make_folder() {
  remove_left_folders();
  remove_temporary_folder(getpid());  // Of another process that had this number.
  const auto folder = folder_of(getpid());
  return !folder.empty() && mkdir(folder.c_str(), 0700) == 0 ? folder : fs::path();
}

std::uint64_t bytes_on_disk(const struct stat& about) {
  return 512 * static_cast<std::uint64_t>(about.st_blocks);
}

/// Looks after the temporary folder. Nobody is woken while it is empty.
class folder_watch {
public:
  folder_watch(fs::path folder, std::uint64_t most)
      : folder_(std::move(folder)), most_(most), news_(inotify_init1(IN_CLOEXEC | IN_NONBLOCK)) {
    if (!folder_.empty() && inotify_add_watch(news_.get(), folder_.c_str(), IN_CREATE) < 0)
      news_.reset();
  }

  void wait_for(std::vector<pollfd>& list) const {
    if (news_)
      list.push_back({news_.get(), POLLIN, 0});
  }

  /// How long the next look may wait; -1: until there is a file.
  [[nodiscard]] int pause_ms() const { return folder_.empty() || (news_ && !in_use_) ? -1 : 500; }

  /// Whether the child's files fill more than they may.
  bool is_full(pid_t child) {
    std::array<char, 4096> heard;
    while (news_ && read(news_.get(), heard.data(), heard.size()) > 0)
      in_use_ = true;
    if (folder_.empty() || pause_ms() < 0)
      return false;
    const auto bytes = in_folder() + without_name(child);
    return bytes > most_;
  }

private:
  std::uint64_t in_folder() {
    std::uint64_t sum = 0;
    std::error_code code;
    in_use_ = !fs::is_empty(folder_, code);
    for (fs::recursive_directory_iterator at(folder_, code), end; !code && at != end;
         at.increment(code)) {
      struct stat about {};
      if (lstat(at->path().c_str(), &about) == 0)
        sum += bytes_on_disk(about);
    }
    return sum;
  }

  /// Files that were removed while they are open.
  std::uint64_t without_name(pid_t child) {
    std::uint64_t sum = 0;
    std::error_code code;
    struct stat disk {};
    if (stat(folder_.c_str(), &disk) != 0)
      return 0;
    for (const auto& item :
         fs::directory_iterator("/proc/" + std::to_string(child) + "/fd", code)) {
      struct stat about {};
      if (stat(item.path().c_str(), &about) == 0 && S_ISREG(about.st_mode) && about.st_nlink == 0 &&
          about.st_dev == disk.st_dev) {
        sum += bytes_on_disk(about);
        in_use_ = true;
      }
    }
    return sum;
  }

  fs::path folder_;
  std::uint64_t most_;
  unique_fd news_;
  bool in_use_ = true;  ///< Until a look: the child may have been quicker than the watch.
};

pid_t kept = 0;

void pass_on(int signal) {
  kill(kept, signal);
}

/// Ends this process as another ended.
[[noreturn]] void end_as(int status) {
  if (WIFSIGNALED(status)) {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);  // The child has left the core already.
    std::signal(WTERMSIG(status), SIG_DFL);
    raise(WTERMSIG(status));
  }
  _exit(WEXITSTATUS(status));
}

/// Until the child has ended: its status, or that of its misdeed.
int serve(pid_t child, program_host* programs, folder_watch& files) {
  // By its number: the header of glibc 2.36 declares it for C alone.
  const unique_fd end(static_cast<int>(syscall(SYS_pidfd_open, child, 0)));
  bool full = false;
  int status = 0;
  for (pid_t ended = 0; ended != child; ended = waitpid(child, &status, WNOHANG)) {
    std::vector<pollfd> list{{end.get(), POLLIN, 0}};
    if (programs)
      programs->wait_for(list);
    files.wait_for(list);
    poll(list.data(), list.size(), end ? files.pause_ms() : 100);
    if (programs)
      programs->look();
    if (!full && files.is_full(child)) {
      full = true;
      kill(child, SIGKILL);
    }
  }
  return full ? status_of(misdeed::disk) << 8 : status;
}

[[noreturn]] void keep(pid_t child, const keeper_options& options, unique_fd programs,
                       unique_fd line, const fs::path& folder) {
  std::signal(SIGINT, SIG_IGN);
  close_files_except({programs.get(), line.get()});
  if (options.prepare)
    if (const int status = options.prepare(line.get()); status != 0) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
      remove_temporary_folder(getpid());
      _exit(status);
    }
  line.reset();
  kept = child;
  std::signal(SIGTERM, pass_on);
  std::optional<program_host> host;
  if (!options.programs.empty())
    host.emplace(std::move(programs), options.programs, child_limits{});
  folder_watch files(folder, options.temporary_bytes);
  const int status = serve(child, host ? &*host : nullptr, files);
  host.reset();
  if (!folder.empty())
    remove_temporary_folder(getpid());
  end_as(status);
}

}  // namespace

void remove_temporary_folder(pid_t keeper) {
  const auto folder = folder_of(keeper);
  // A process that was killed may be in the middle of making a file.
  for (int i = 0; i < 50 && !folder.empty() && is_own_folder(folder); ++i) {
    std::error_code code;
    fs::remove_all(folder, code);
    if (code)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

keeper_gifts continue_in_child(const keeper_options& options) {
  auto programs = options.programs.empty() ? line_ends{} : make_line().value_or(line_ends{});
  auto line = options.prepare ? make_line().value_or(line_ends{}) : line_ends{};
  const auto folder = options.temporary_folder ? make_folder() : fs::path();
  const pid_t keeper = getpid();
  const pid_t child = fork();
  if (child > 0) {
    programs.theirs.reset();
    line.theirs.reset();
    keep(child, options, std::move(programs.ours), std::move(line.ours), folder);
  }
  if (child < 0)
    return {};  // Without a keeper it works as well.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != keeper)
    _exit(127);
  setpgid(0, 0);
  if (!folder.empty())
    setenv("TMPDIR", folder.c_str(), 1);
  return {std::move(programs.theirs), std::move(line.theirs), folder};
}

}  // namespace tedit
