// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "base/control_groups.hpp"

namespace tedit {

namespace {

namespace fs = std::filesystem;

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

/// What groups leave. Files that were read count as used but give way.
std::uint64_t left_in(const std::vector<fs::path>& groups, const char* limit, const char* used,
                      const char* cache) {
  std::uint64_t result = std::numeric_limits<std::uint64_t>::max();
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
  take(left_in(control_groups(root), "memory.max", "memory.current", "inactive_file"),
       "the control group");
  take(left_in(control_groups_v1("memory", root), "memory.limit_in_bytes", "memory.usage_in_bytes",
               "total_inactive_file"),
       "the control group");
  take(left_of_address_space(root), "the process's address space");
  return result;
}

std::uint64_t whole_memory(const fs::path& root) {
  auto result = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  const auto take = [&](const std::vector<fs::path>& groups, const char* limit) {
    for (const auto& folder : groups)
      if (const auto most = number_in(folder / limit))
        result = std::min(result, *most);
  };
  take(control_groups(root), "memory.max");
  take(control_groups_v1("memory", root), "memory.limit_in_bytes");
  return result;
}

std::uint64_t memory_kills(const fs::path& root) {
  std::ifstream in(root / "proc/vmstat", std::ios::binary);
  std::string text(16384, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  constexpr std::string_view key = "\noom_kill ";
  const auto at = text.find(key);
  std::uint64_t count = 0;
  if (at != std::string::npos)
    std::from_chars(text.data() + at + key.size(), text.data() + text.size(), count);
  return count;
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
