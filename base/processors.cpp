// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/processors.hpp"

#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <thread>

#include "base/control_groups.hpp"

namespace tedit {

namespace {

namespace fs = std::filesystem;

unsigned may_run_on() {
#ifdef __linux__
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof(set), &set) == 0)
    return static_cast<unsigned>(std::max(1, CPU_COUNT(&set)));
#endif
  return std::max(1U, std::thread::hardware_concurrency());
}

/// Processors that so much time in each period keeps busy.
unsigned for_quota(std::uint64_t quota, std::uint64_t period, unsigned most) {
  if (quota == 0 || period == 0)
    return most;
  const auto needed = quota / period + (quota % period > 0 ? 1 : 0);
  return static_cast<unsigned>(std::min<std::uint64_t>(needed, most));
}

/// Of "200000 100000"; "max 100000" says nothing.
unsigned for_line(const fs::path& file, unsigned most) {
  const auto quota = number_in(file);
  std::string first;
  std::uint64_t period = 0;
  std::ifstream in(file);
  return quota && in >> first >> period ? for_quota(*quota, period, most) : most;
}

}  // namespace

unsigned processors(const fs::path& root) {
  auto result = may_run_on();
  for (const auto& group : control_groups(root))
    result = for_line(group / "cpu.max", result);
  for (const auto& group : control_groups_v1("cpu", root))
    if (const auto quota = number_in(group / "cpu.cfs_quota_us"))
      result = for_quota(*quota, number_in(group / "cpu.cfs_period_us").value_or(0), result);
  return result;
}

}  // namespace tedit
