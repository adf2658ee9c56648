// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/memory.hpp"

#include <sys/resource.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

namespace tedit {

namespace {

namespace fs = std::filesystem;

/// The first number of a file; nothing when there is none ("max").
std::optional<std::uint64_t> number_in(const fs::path& file) {
  std::ifstream in(file);
  std::uint64_t value = 0;
  return in >> value ? std::optional(value) : std::nullopt;
}

/// The number behind a key: "MemAvailable:  123 kB", "inactive_file 456".
std::optional<std::uint64_t> number_of(const fs::path& file, const std::string& key) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string name;
    std::uint64_t value = 0;
    if (words >> name >> value && name == key)
      return value;
  }
  return {};
}

/// The folder of this process's group below a hierarchy: the path behind "0::" or ":memory:".
std::string group_path(const fs::path& root, const std::string& controller) {
  std::ifstream in(root / "proc/self/cgroup");
  std::string line;
  while (std::getline(in, line)) {
    const auto first = line.find(':');
    const auto second = line.find(':', first + 1);
    if (second != std::string::npos && line.substr(first + 1, second - first - 1) == controller)
      return fs::path(line.substr(second + 1)).relative_path();
  }
  return {};
}

/// What a group and all above it leave. Files that were read count as used but give way.
std::uint64_t left_in_groups(const fs::path& top, const std::string& path, const char* limit,
                             const char* used, const char* cache) {
  std::uint64_t result = std::numeric_limits<std::uint64_t>::max();
  fs::path group = top;
  auto part = fs::path(path);
  std::vector<fs::path> groups{group};
  for (const auto& name : part)
    groups.push_back(group /= name);
  for (const auto& folder : groups)
    if (const auto most = number_in(folder / limit); const auto now = number_in(folder / used))
      if (most) {
        const auto gives_way = std::min(*now, number_of(folder / "memory.stat", cache).value_or(0));
        const auto held = *now - gives_way;
        result = std::min(result, *most > held ? *most - held : 0);
      }
  return result;
}

std::uint64_t left_of_address_space(const fs::path& root) {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return std::numeric_limits<std::uint64_t>::max();
  const auto mapped = number_of(root / "proc/self/status", "VmSize:").value_or(0) << 10;
  return limit.rlim_cur > mapped ? limit.rlim_cur - mapped : 0;
}

std::string mebibytes(std::uint64_t bytes) {
  return std::to_string(bytes >> 20) + " MiB";
}

}  // namespace

void return_large_blocks() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

void return_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

memory_room available_memory(const fs::path& root) {
  memory_room result{std::numeric_limits<std::uint64_t>::max(), "nothing"};
  const auto take = [&](std::uint64_t bytes, const char* limit) {
    if (bytes < result.bytes)
      result = {bytes, limit};
  };
  if (const auto free = number_of(root / "proc/meminfo", "MemAvailable:"))
    take(*free << 10, "the machine");
  const auto groups = root / "sys/fs/cgroup";
  take(
    left_in_groups(groups, group_path(root, ""), "memory.max", "memory.current", "inactive_file"),
    "the control group");
  take(left_in_groups(groups / "memory", group_path(root, "memory"), "memory.limit_in_bytes",
                      "memory.usage_in_bytes", "total_inactive_file"),
       "the control group");
  take(left_of_address_space(root), "the process's address space");
  return result;
}

expected<void> check_memory(std::uint64_t bytes, const memory_room& room, const std::string& what) {
  if (bytes <= room.bytes)
    return {};
  return fail(ec::out_of_memory,
              what + " needs about " + mebibytes(bytes) + ", " + room.limit + " has " +
                mebibytes(room.bytes) + " left",
              "Close other programs, raise the limit, or take a coarser mesh");
}

}  // namespace tedit
