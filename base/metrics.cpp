// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/metrics.hpp"

#include <dirent.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <variant>

namespace tedit::metrics {

namespace {

struct family {
  std::string help;
  const char* type = "";
  /// By labels as text; the objects never move.
  std::map<std::string,
           std::variant<std::unique_ptr<counter>, std::unique_ptr<gauge>, std::unique_ptr<times>>>
    members;
};

struct registry {
  std::mutex mutex;
  std::map<std::string, family> families;
};

/// Never destroyed: what counts may outlive `main`.
registry& all() {
  static auto* one = new registry;
  return *one;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    if (c == '\n')
      result += "\\n";
    else
      result += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  return result;
}

/// `kind="edit",role="solver"`
std::string text_of(const labels& which) {
  std::string text;
  for (const auto& [name, value] : which)
    text += (text.empty() ? "" : ",") + name + "=\"" + escaped(value) + "\"";
  return text;
}

template <class T>
T& find(const std::string& name, const std::string& help, const labels& which, const char* type) {
  auto& registered = all();
  const std::lock_guard lock(registered.mutex);
  auto& group = registered.families[name];
  group.help = help;
  group.type = type;
  auto& member = group.members[text_of(which)];
  auto* held = std::get_if<std::unique_ptr<T>>(&member);
  if (!held || !*held) {
    member = std::make_unique<T>();
    held = std::get_if<std::unique_ptr<T>>(&member);
  }
  return **held;
}

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string row(const std::string& name, const std::string& which, const std::string& value) {
  return name + (which.empty() ? "" : "{" + which + "}") + " " + value + "\n";
}

std::string rows(const std::string& name, const std::string& which, const times& of) {
  const auto bucket = [&](const std::string& bound, std::uint64_t n) {
    return row(name + "_bucket", which + (which.empty() ? "" : ",") + "le=\"" + bound + "\"",
               std::to_string(n));
  };
  std::string text;
  for (std::size_t i = 0; i < times::bounds_s.size(); ++i) {
    char bound[16];
    std::snprintf(bound, sizeof bound, "%g", times::bounds_s[i]);
    text += bucket(bound, of.within(i));
  }
  text += bucket("+Inf", of.count());
  text += row(name + "_sum", which, number(of.sum_s()));
  return text + row(name + "_count", which, std::to_string(of.count()));
}

std::size_t entries_of(const char* folder) {
  std::size_t n = 0;
  if (auto* opened = ::opendir(folder)) {
    while (const auto* entry = ::readdir(opened))
      n += entry->d_name[0] != '.';
    ::closedir(opened);
  }
  return n;
}

}  // namespace

void times::note(std::chrono::duration<double> took) noexcept {
  const double s = std::max(0.0, took.count());
  for (std::size_t i = 0; i < bounds_s.size(); ++i)
    if (s <= bounds_s[i]) {
      buckets_[i].add();
      break;
    }
  count_.add();
  sum_us_.add(static_cast<std::uint64_t>(std::llround(s * 1e6)));
}

std::uint64_t times::within(std::size_t i) const noexcept {
  std::uint64_t n = 0;
  for (std::size_t b = 0; b <= i; ++b)
    n += buckets_[b].get();
  return n;
}

counter& count_of(const std::string& name, const std::string& help, const labels& which) {
  return find<counter>(name, help, which, "counter");
}

gauge& level_of(const std::string& name, const std::string& help, const labels& which) {
  return find<gauge>(name, help, which, name.ends_with("_total") ? "counter" : "gauge");
}

times& times_of(const std::string& name, const std::string& help, const labels& which) {
  return find<times>(name, help, which, "histogram");
}

void note_process() {
  const auto page = static_cast<double>(::sysconf(_SC_PAGESIZE));
  const auto tick = static_cast<double>(::sysconf(_SC_CLK_TCK));
  double size = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> size >> resident;
  level_of("process_virtual_memory_bytes", "Address space.").set(size * page);
  level_of("process_resident_memory_bytes", "Memory that is in use.").set(resident * page);
  std::ifstream stat("/proc/self/stat");
  std::string text((std::istreambuf_iterator<char>(stat)), {});
  text.erase(0, text.rfind(')') + 1);  // The name may hold blanks.
  unsigned long long user = 0, system = 0, threads = 0, begun = 0;
  if (std::sscanf(text.c_str(),
                  " %*c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %llu %llu %*d %*d %*d %*d %llu "
                  "%*d %llu",
                  &user, &system, &threads, &begun) == 4) {
    level_of("process_cpu_seconds_total", "Processor time.")
      .set(static_cast<double>(user + system) / tick);
    level_of("process_threads", "Threads.").set(static_cast<double>(threads));
    double up = 0;
    std::ifstream("/proc/uptime") >> up;
    level_of("process_uptime_seconds", "Since the process began.")
      .set(std::max(0.0, up - static_cast<double>(begun) / tick));
  }
  level_of("process_open_fds", "Open descriptors.")
    .set(static_cast<double>(entries_of("/proc/self/fd")));
  level_of("process_max_fds", "The most descriptors that it may open.")
    .set(static_cast<double>(::sysconf(_SC_OPEN_MAX)));
}

std::string to_text() {
  auto& registered = all();
  const std::lock_guard lock(registered.mutex);
  std::string text;
  for (const auto& [name, group] : registered.families) {
    text += "# HELP " + name + " " + group.help + "\n# TYPE " + name + " " + group.type + "\n";
    for (const auto& [which, member] : group.members) {
      if (const auto* one = std::get_if<std::unique_ptr<counter>>(&member))
        text += row(name, which, std::to_string((*one)->get()));
      else if (const auto* level = std::get_if<std::unique_ptr<gauge>>(&member))
        text += row(name, which, number((*level)->get()));
      else
        text += rows(name, which, *std::get<std::unique_ptr<times>>(member));
    }
  }
  return text;
}

}  // namespace tedit::metrics
