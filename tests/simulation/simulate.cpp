// SPDX-License-Identifier: AGPL-3.0-or-later
// Plays many seeds and says what failed: simulate [FIRST [COUNT]]. Of the first failing seed it
// shows the least sequence of steps that still fails.
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include <spdlog/spdlog.h>

#include "tests/simulation/world.hpp"

int main(int argc, char** argv) {
  using namespace tedit::simulation;
  spdlog::set_level(spdlog::level::off);
  const auto first = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1;
  const auto count = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1000;
  const auto folder =
    std::filesystem::temp_directory_path() / ("tedit-simulation-" + std::to_string(::getpid()));
  const auto began = std::chrono::steady_clock::now();
  std::uint64_t failed = 0;
  std::uint64_t steps = 0;
  std::uint64_t answers = 0;
  double hours = 0;
  std::map<std::string, int> errors;
  for (auto seed = first; seed < first + count; ++seed) {
    const auto all = make_scenario(seed);
    const auto result = play(all, folder);
    steps += result.steps;
    answers += result.answers;
    hours += std::chrono::duration<double, std::ratio<3600>>(result.lasted).count();
    for (const auto& [code, n] : result.errors)
      errors[code] += n;
    if (result.faults.empty())
      continue;
    if (failed < 10)
      std::printf("seed %llu: %s\n", static_cast<unsigned long long>(seed),
                  result.faults.front().c_str());
    if (failed++ == 0) {
      const auto least = shrink(all, folder);
      std::printf("%s", describe(least).c_str());
      for (const auto& fault : play(least, folder).faults)
        std::printf("  => %s\n", fault.c_str());
    }
    std::fflush(stdout);
  }
  std::filesystem::remove_all(folder);
  const auto seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  std::printf(
    "%llu of %llu seeds failed; %llu steps, %llu answers, %.0f hours of virtual time in "
    "%.1f s: %.1f seeds a second\n",
    static_cast<unsigned long long>(failed), static_cast<unsigned long long>(count),
    static_cast<unsigned long long>(steps), static_cast<unsigned long long>(answers), hours,
    seconds, static_cast<double>(count) / seconds);
  for (const auto& [code, n] : errors)
    std::printf("  refused with %s: %d\n", code.c_str(), n);
  return failed == 0 ? 0 : 1;
}
