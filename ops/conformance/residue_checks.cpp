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

std::string quiet(plugin_trial& b) {
  const auto before = bytes_on_stdout();
  b.load();
  apply_all(b);
  if (const auto written = bytes_on_stdout() - before; written > 0)
    throw failure{"it wrote " + std::to_string(written) + " bytes to standard output",
                  "Programs speak JSON there: use ctx.log, ctx.run.report or a notice"};
  return "nothing was written";
}

std::string no_files(plugin_trial& b) {
  namespace fs = std::filesystem;
  b.load();
  apply_all(b);
  // Home, temporary and working folder are this one, which was empty.
  for (const auto& item : fs::recursive_directory_iterator(fs::current_path()))
    throw failure{"it left " + item.path().filename().string() + " behind",
                  "Keep everything in memory, or remove the file before returning"};
  return "the working, home and temporary folder is empty";
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

std::string no_traces(plugin_trial& b) {
  const auto before = surroundings();
  b.load();
  apply_all(b);
  const auto after = surroundings();
  for (const auto& [name, value] : after)
    if (const auto old = before.find(name); old == before.end() || old->second != value)
      throw failure{"it changed " + name,
                    "The process belongs to the host: restore what you must change"};
  if (before.size() != after.size())
    throw failure{"it removed an environment variable", "Leave the environment alone"};
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
  for (int i = 0; i < 3; ++i)
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
