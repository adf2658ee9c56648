// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/process_usage.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace tedit {

namespace {

/// Libraries open a few files and start a few threads when they are first used.
constexpr std::uint64_t spare_descriptors = 32;
constexpr std::uint64_t spare_threads = 64;

std::uint64_t entries_of(const char* folder) {
  std::error_code unreadable;
  const std::filesystem::directory_iterator items(folder, unreadable);
  // Without a descriptor to read it by, there are none left.
  return unreadable ? UINT64_MAX
                    : static_cast<std::uint64_t>(std::distance(begin(items), end(items)));
}

std::uint64_t limit_of(__rlimit_resource what) {
  rlimit limit{};
  return getrlimit(what, &limit) == 0 ? limit.rlim_cur : RLIM_INFINITY;
}

}  // namespace

process_usage usage_of_this_process() {
  process_usage usage;
  usage.descriptors = entries_of("/proc/self/fd");
  usage.threads = entries_of("/proc/self/task");
  std::uint64_t pages = 0;
  std::ifstream statm("/proc/self/statm");
  statm >> pages >> pages;
  usage.resident_bytes = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  usage.descriptor_limit = limit_of(RLIMIT_NOFILE);
  usage.memory_limit = limit_of(RLIMIT_DATA);
  return usage;
}

std::optional<std::string> used_up(const process_usage& at_start, const process_usage& now) {
  if (now.descriptors == UINT64_MAX)
    return "it has no file descriptor left";
  if (now.descriptors > at_start.descriptors + spare_descriptors)
    return "it left " + std::to_string(now.descriptors - at_start.descriptors) + " files open";
  if (now.threads > at_start.threads + spare_threads)
    return "it left " + std::to_string(now.threads - at_start.threads) + " threads running";
  if (now.descriptor_limit < at_start.descriptor_limit || now.memory_limit < at_start.memory_limit)
    return "its limits were lowered";
  if (now.resident_bytes > at_start.memory_limit / 4 * 3)
    return "it holds " + std::to_string(now.resident_bytes >> 20) + " of the " +
           std::to_string(at_start.memory_limit >> 20) + " MiB that it may have";
  return std::nullopt;
}

void limit_memory(std::uint64_t bytes) {
#ifdef TEDIT_SANITIZED
  (void)bytes;
#else
  rlimit limit{};
  if (getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur <= bytes)
    return;
  limit.rlim_cur = bytes;
  setrlimit(RLIMIT_DATA, &limit);
#endif
}

}  // namespace tedit
