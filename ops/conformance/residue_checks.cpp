// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fenv.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <clocale>
#include <map>

#include "ops/conformance/kit.hpp"

namespace tedit::ops::kit {

namespace {

void apply_all(plugin_trial& b) {
  for (const auto& c : b.the_plan().cases)
    (void)b.succeed(c);
}

/// What a process has beside its memory.
std::map<std::string, std::string> surroundings() {
  std::map<std::string, std::string> result;
  for (char** row = environ; *row; ++row) {
    const std::string text = *row;
    const auto split = text.find('=');
    result["the environment variable " + text.substr(0, split)] = text.substr(split + 1);
  }
  result["the working folder"] = std::filesystem::current_path().string();
  const auto mask = umask(0);
  umask(mask);
  result["the file mode mask"] = std::to_string(mask);
  result["the locale"] = std::setlocale(LC_ALL, nullptr);
  result["the rounding mode"] = std::to_string(fegetround());
  result["floating-point traps"] = std::to_string(fegetexcept());
  for (int number = 1; number < 32; ++number) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) == 0)
      result["the handler of signal " + std::to_string(number)] =
        std::to_string(reinterpret_cast<std::uintptr_t>(action.sa_handler));
  }
  sigset_t blocked;
  sigprocmask(SIG_SETMASK, nullptr, &blocked);
  for (int number = 1; number < 32; ++number)
    result["the mask of signal " + std::to_string(number)] =
      std::to_string(sigismember(&blocked, number));
  return result;
}

constexpr auto writes = "quiet";
constexpr auto leaves_file = "no_files";
constexpr auto leaves_trace = "no_traces";

std::string changed_since(const std::map<std::string, std::string>& before) {
  const auto after = surroundings();
  for (const auto& [name, value] : after)
    if (const auto old = before.find(name); old == before.end() || old->second != value)
      return "it changed " + name;
  return before.size() == after.size() ? "" : "it removed an environment variable";
}

/// What the working cases leave behind. Runs them unless another check has told.
std::vector<broken_rule> left_behind(plugin_trial& b) {
  if (b.the_plan().left_behind)
    return *b.the_plan().left_behind;
  namespace fs = std::filesystem;
  const auto said = bytes_on_stdout();
  const auto before = surroundings();
  b.load();
  apply_all(b);
  std::vector<broken_rule> result;
  if (const auto written = bytes_on_stdout() - said; written > 0)
    result.push_back({writes, "it wrote " + std::to_string(written) + " bytes to standard output"});
  // Home, temporary and working folder are this one, which was empty.
  for (const auto& item : fs::recursive_directory_iterator(fs::current_path()))
    result.push_back({leaves_file, "it left " + item.path().filename().string() + " behind"});
  if (const auto changed = changed_since(before); !changed.empty())
    result.push_back({leaves_trace, changed});
  return result;
}

void judge(const std::vector<broken_rule>& left, std::string_view rule, const char* remedy) {
  for (const auto& one : left)
    if (one.rule == rule)
      throw failure{one.seen, remedy};
}

/// Tells those that come after it what else is left.
std::string quiet(plugin_trial& b) {
  const auto left = left_behind(b);
  for (const auto& one : left)
    b.say(std::string(leaves) + one.rule + "\t" + one.seen);
  b.say(std::string(looked_at));
  judge(left, writes, "Programs speak JSON there: use ctx.log, ctx.run.report or a notice");
  return "nothing was written";
}

std::string no_files(plugin_trial& b) {
  judge(left_behind(b), leaves_file,
        "Keep everything in memory, or remove the file before returning");
  return "the working, home and temporary folder is empty";
}

std::string no_traces(plugin_trial& b) {
  judge(left_behind(b), leaves_trace,
        "The process belongs to the host: restore what you must change");
  return "environment, locale, signals and floating point are as before";
}

std::size_t entries_of(const char* folder) {
  namespace fs = std::filesystem;
  return static_cast<std::size_t>(
    std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

std::string no_handles(plugin_trial& b) {
  b.load();
  apply_all(b);  // What is made once, on first use, may stay.
  const auto files = entries_of("/proc/self/fd");
  const auto threads = entries_of("/proc/self/task");
  apply_all(b);
  if (entries_of("/proc/self/fd") > files)
    throw failure{"every edit leaves a file open", "Close what you open, also on errors"};
  if (entries_of("/proc/self/task") > threads)
    throw failure{"every edit leaves a thread running", "Join every thread before returning"};
  if (waitpid(-1, nullptr, WNOHANG) >= 0)
    throw failure{"it leaves a child process", "Wait for every process that you start"};
  return "no open files, threads or child processes stay";
}

}  // namespace

const std::vector<check>& residue_checks() {
  static const std::vector<check> list{
    {"quiet", "Nothing is written to standard output", need::working_case, quiet},
    {"no_files", "No file is left behind", need::working_case, no_files},
    {"no_traces", "Environment, locale, signals and floating point stay as they are",
     need::working_case, no_traces},
    {"no_handles", "No open file, thread or child process is left", need::working_case,
     no_handles}};
  return list;
}

}  // namespace tedit::ops::kit
