// SPDX-License-Identifier: AGPL-3.0-or-later
// Plays many seeds and says what failed: simulate [FIRST [COUNT [--first]]]. Of the first failing
// seed it shows the least sequence of steps that still fails; with --first it only names that seed
// and ends. Of each code that requests were refused with it names the first seed.
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/logging/logging.hpp"
#include "tests/simulation/world.hpp"

namespace {

using namespace tedit::simulation;
using number = unsigned long long;

/// What is said should a signal end the program: only then is a seed that crashes or hangs known.
char last_words[100] = "";

extern "C" void say_last_words(int signal) {
  [[maybe_unused]] const auto written = ::write(STDOUT_FILENO, last_words, std::strlen(last_words));
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

struct refusals {
  int count = 0;
  number first_seed = 0;
};

struct totals {
  number failed = 0;
  number steps = 0;
  number answers = 0;
  double hours = 0;
  std::map<std::string, refusals> errors;

  void add(number seed, const outcome& one) {
    failed += one.faults.empty() ? 0 : 1;
    steps += one.steps;
    answers += one.answers;
    hours += std::chrono::duration<double, std::ratio<3600>>(one.lasted).count();
    for (const auto& [code, n] : one.errors)
      errors.try_emplace(code, refusals{0, seed}).first->second.count += n;
  }

  void say(number count, double seconds) const {
    std::printf(
      "%llu of %llu seeds failed; %llu steps, %llu answers, %.0f hours of virtual time in "
      "%.1f s: %.1f seeds a second\n",
      failed, count, steps, answers, hours, seconds, static_cast<double>(count) / seconds);
    for (const auto& [code, of] : errors)
      std::printf("  refused with %s: %d, first in seed %llu\n", code.c_str(), of.count,
                  of.first_seed);
  }
};

outcome play_seed(const scenario& all, const std::filesystem::path& folder) {
  std::snprintf(last_words, sizeof last_words, "seed %llu: a signal ended the program\n",
                static_cast<number>(all.seed));
  return play(all, folder);
}

void show_least(const scenario& all, const std::filesystem::path& folder) {
  const auto least = shrink(all, folder);
  std::printf("%s", describe(least).c_str());
  for (const auto& fault : play(least, folder).faults)
    std::printf("  => %s\n", fault.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  tedit::logging::set_level("off");
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGTERM})
    std::signal(signal, say_last_words);
  const number first = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1;
  const number count = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1000;
  const bool only_first = argc > 3 && std::strcmp(argv[3], "--first") == 0;
  const auto folder =
    std::filesystem::temp_directory_path() / ("tedit-simulation-" + std::to_string(::getpid()));
  const auto began = std::chrono::steady_clock::now();
  totals all;
  for (auto seed = first; seed < first + count && !(only_first && all.failed > 0); ++seed) {
    const auto made = make_scenario(seed);
    const auto result = play_seed(made, folder);
    all.add(seed, result);
    if (!result.faults.empty() && all.failed <= 10)
      std::printf("seed %llu: %s\n", seed, result.faults.front().c_str());
    if (!result.faults.empty() && all.failed == 1 && !only_first)
      show_least(made, folder);
    std::fflush(stdout);
  }
  std::filesystem::remove_all(folder);
  all.say(count, std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
  return all.failed == 0 ? 0 : 1;
}
