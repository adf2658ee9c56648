// SPDX-License-Identifier: AGPL-3.0-or-later
// What a confined process reaches by name: Landlock, limits and rights.
#include <fcntl.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <string>
#include <string_view>

#include "base/unique_fd.hpp"
#include "sandbox/sandbox.hpp"

namespace tedit::sandbox {

namespace {

/// The kernel's numbers: Debian 12's header knows those of its own kernel only.
namespace landlock {
constexpr std::uint64_t write_file = 1 << 1;
constexpr std::uint64_t read_file = 1 << 2;
constexpr std::uint64_t read_folder = 1 << 3;
constexpr std::uint64_t remove_folder = 1 << 4;
constexpr std::uint64_t remove_file = 1 << 5;
constexpr std::uint64_t make_folder = 1 << 7;
constexpr std::uint64_t make_file = 1 << 8;
constexpr std::uint64_t rename = 1 << 13;
constexpr std::uint64_t truncate = 1 << 14;
constexpr std::uint64_t of_files = write_file | read_file | truncate;
constexpr std::uint64_t reading = read_file | read_folder;
constexpr std::uint64_t owning =
  reading | write_file | remove_folder | remove_file | make_folder | make_file | rename | truncate;

struct ruleset {
  std::uint64_t files = 0;
  std::uint64_t network = 0;
  std::uint64_t others = 0;
};

struct [[gnu::packed]] beneath {
  std::uint64_t allowed = 0;
  std::int32_t folder = -1;
};

/// Which rules there are: each version of the interface added some. Below 1: none.
long version() {
  return syscall(SYS_landlock_create_ruleset, nullptr, 0, 1);
}

/// Everything that this version can deny.
ruleset all_of(long version) {
  const int rights = version >= 5 ? 16 : version >= 3 ? 15 : version >= 2 ? 14 : 13;
  ruleset all;
  all.files = (std::uint64_t{1} << rights) - 1;
  if (version >= 4)
    all.network = 3;
  if (version >= 6)
    all.others = 3;
  return all;
}

std::size_t size_for(long version) {
  return version >= 6 ? 24 : version >= 4 ? 16 : 8;
}
}  // namespace landlock

constexpr auto way_out =
  "Use a kernel with Landlock and seccomp (Linux 5.13; Debian 12's has both), or set sandbox = "
  "\"off\" under [work] (TEDIT_SANDBOX=off for other commands): plugins can then do all that your "
  "user can";

tl::unexpected<error> cannot(const std::string& what) {
  return fail(ec::service_unavailable, "workers cannot be confined here: " + what, way_out);
}

std::string reason() {
  return std::strerror(errno);
}

expected<void> allow(int rules, const std::filesystem::path& path, std::uint64_t rights) {
  const unique_fd opened(open(path.c_str(), O_PATH | O_CLOEXEC));
  struct stat about {};
  if (!opened || fstat(opened.get(), &about) != 0)
    return {};  // What is not there cannot be reached.
  if (!S_ISDIR(about.st_mode))
    rights &= landlock::of_files;
  const landlock::beneath rule{rights, opened.get()};
  if (syscall(SYS_landlock_add_rule, rules, 1, &rule, 0) != 0)
    return cannot("no rule for " + path.string() + ": " + reason());
  return {};
}

/// What holds for files by name; see landlock(7).
expected<void> bound_names(const reach& to) {
  const auto version = landlock::version();
  const auto all = landlock::all_of(version);
  const unique_fd rules(
    static_cast<int>(syscall(SYS_landlock_create_ruleset, &all, landlock::size_for(version), 0)));
  if (!rules)
    return cannot("no rules for files: " + reason());
  auto readable = to.readable;
#ifdef TEDIT_SANITIZED
  // A sanitizer's last words need the program's own maps and libraries.
  std::ranges::copy(system_files(), std::back_inserter(readable));
#endif
  for (const auto& path : readable)
    if (auto ok = allow(rules.get(), path, landlock::reading & all.files); !ok)
      return ok;
  if (auto ok = allow(rules.get(), "/dev/null", landlock::of_files & all.files); !ok)
    return ok;
  if (!to.own_folder.empty())
    if (auto ok = allow(rules.get(), to.own_folder, landlock::owning & all.files); !ok)
      return ok;
  if (syscall(SYS_landlock_restrict_self, rules.get(), 0) != 0)
    return cannot("rules for files do not hold: " + reason());
  return {};
}

/// Today's limits are the last word.
void bound_resources(const reach& to) {
  const auto set = [](__rlimit_resource what, rlim_t most) {
    const rlimit limit{most, most};
    setrlimit(what, &limit);
  };
  set(RLIMIT_CORE, 0);
  set(RLIMIT_MSGQUEUE, 0);
  set(RLIMIT_MEMLOCK, 0);
  set(RLIMIT_FSIZE, to.file_bytes);
  for (const auto what : {RLIMIT_DATA, RLIMIT_AS, RLIMIT_NOFILE}) {
    rlimit now{};
    if (getrlimit(what, &now) == 0)
      set(what, now.rlim_cur);
  }
}

/// Root's rights beyond those of the owner of files.
expected<void> drop_rights() {
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
    return cannot("new rights cannot be ruled out: " + reason());
  __user_cap_header_struct head{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, 2> none{};
  if (syscall(SYS_capset, &head, none.data()) != 0)
    return cannot("rights cannot be given up: " + reason());
  return {};
}

}  // namespace

std::vector<std::filesystem::path> system_files() {
  std::vector<std::filesystem::path> list{"/usr",
                                          "/lib",
                                          "/lib64",
                                          "/lib32",
                                          "/etc/ld.so.cache",
                                          "/etc/localtime",
                                          "/etc/timezone",
                                          "/dev/zero",
                                          "/dev/urandom",
                                          "/dev/random",
                                          "/proc/self",
                                          "/proc/meminfo",
                                          "/proc/cpuinfo",
                                          "/proc/stat",
                                          "/proc/version",
                                          "/proc/sys/vm/overcommit_memory",
                                          "/proc/sys/kernel/osrelease",
                                          "/sys/devices/system",
                                          "/sys/fs/cgroup",
                                          "/sys/kernel/mm/transparent_hugepage"};
  if (const char* more = std::getenv("LD_LIBRARY_PATH")) {
    std::string_view left = more;
    while (!left.empty()) {
      const auto end = std::min(left.find(':'), left.size());
      if (left.starts_with('/'))
        list.emplace_back(left.substr(0, end));
      left.remove_prefix(std::min(end + 1, left.size()));
    }
  }
  return list;
}

bool is_switched_off() {
  const char* given = std::getenv("TEDIT_SANDBOX");
  return given != nullptr && std::string_view(given) == "off";
}

bool is_wanted() {
  const char* given = std::getenv("TEDIT_SANDBOX");
  if (given != nullptr && std::string_view(given) == "on")
    return true;
  // Asked once: a process that is confined cannot ask any more.
  static const bool can = check().has_value();
  return !is_switched_off() && can;
}

expected<void> check() {
  if (landlock::version() < 1)
    return cannot(errno == EOPNOTSUPP
                    ? "Landlock is switched off in this kernel (boot it with "
                      "landlock in \"lsm=\")"
                    : "this kernel, or the container, has no Landlock (" + reason() + ")");
  constexpr long is_action_there = 2;
  for (const std::uint32_t action : {0x00030000U, 0x00050000U})  // A signal, an error.
    if (syscall(SYS_seccomp, is_action_there, 0, &action) != 0)
      return cannot("this kernel, or the container, cannot bound system calls (" + reason() + ")");
  return {};
}

expected<void> confine_files(const reach& to) {
  if (auto can = check(); !can)
    return can;
  bound_resources(to);
  if (auto ok = drop_rights(); !ok)
    return ok;
  return bound_names(to);
}

}  // namespace tedit::sandbox
