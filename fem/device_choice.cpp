// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/device_choice.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include "base/hash.hpp"

namespace tedit::fem {

namespace {

namespace fs = std::filesystem;

std::string variable(const char* name, const std::string& otherwise = {}) {
  const char* value = std::getenv(name);
  return value && *value ? value : otherwise;
}

std::vector<fs::path> split(const std::string& list) {
  std::vector<fs::path> result;
  std::istringstream in(list);
  for (std::string item; std::getline(in, item, ':');)
    if (!item.empty())
      result.emplace_back(item);
  return result;
}

/// The files of a folder whose names begin so, by name; none when it cannot be read.
std::vector<fs::path> files_of(const fs::path& folder, const std::string& prefix = {}) {
  std::vector<fs::path> result;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().filename().string().starts_with(prefix))
      result.push_back(entry.path());
  std::ranges::sort(result);
  return result;
}

fs::path cache_file() {
  const auto home = variable("HOME");
  const auto cache = variable("XDG_CACHE_HOME", home.empty() ? "" : home + "/.cache");
  return cache.empty() ? fs::path{} : fs::path(cache) / "tedit/fastest-device";
}

}  // namespace

std::vector<fs::path> driver_manifests() {
  const auto home = variable("HOME");
  std::string roots = variable("XDG_CONFIG_HOME", home + "/.config") + ":" +
                      variable("XDG_CONFIG_DIRS", "/etc/xdg") +
                      ":/etc:" + variable("XDG_DATA_HOME", home + "/.local/share") + ":" +
                      variable("XDG_DATA_DIRS", "/usr/local/share:/usr/share");
  std::vector<fs::path> result;
  for (const auto& root : split(roots))
    std::ranges::copy(files_of(root / "vulkan/icd.d"), std::back_inserter(result));
  for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES", "VK_ADD_DRIVER_FILES"})
    for (const auto& file : split(variable(name))) {
      // Which variable names it matters: some replace the folders, one adds to them.
      result.push_back(fs::path(name) / "");
      result.push_back(file);
    }
  return result;
}

std::string installed_drivers(const std::vector<fs::path>& manifests) {
  std::ostringstream text;
  std::error_code missing;
  for (const auto& file : manifests) {
    text << file.string();
    const auto size = fs::file_size(file, missing);
    if (!missing)
      text << '|' << size << '|' << fs::last_write_time(file, missing).time_since_epoch().count();
    text << '\n';
  }
  for (const auto& card : files_of("/dev/dri"))
    text << card.string() << '\n';
  for (const auto& card : files_of("/dev", "nvidia"))
    text << card.string() << '\n';
  text << std::ifstream("/proc/driver/nvidia/version").rdbuf();
  return text.str();
}

std::vector<device_trial> try_devices(const std::vector<contestant>& contestants) {
  constexpr double untimed = std::numeric_limits<double>::infinity();
  constexpr int turns = 3;
  std::vector<device_trial> trials;
  for (const auto& one : contestants)
    trials.push_back({one.name, one.solve_ms().map([](double) { return untimed; })});
  for (int turn = 0; turn < turns; ++turn)
    for (std::size_t i = 0; i < trials.size(); ++i)
      if (auto& least = trials[i].ms) {
        const auto now = contestants[i].solve_ms();
        least = now ? std::min(*least, *now) : now;
      }
  return trials;
}

chosen_device choose_device(const std::vector<device_trial>& trials) {
  chosen_device best{"cpu"};
  double least = std::numeric_limits<double>::infinity();
  for (const auto& trial : trials)
    if (!trial.ms) {
      best.notice += (best.notice.empty() ? "" : "; ") + std::string("the device \"") + trial.name +
                     "\" failed its trial and is not used: " + trial.ms.error().message;
    } else if (*trial.ms < least) {
      least = *trial.ms;
      best.name = trial.name;
    }
  std::ranges::replace(best.notice, '\n', ' ');  // It is kept on a line.
  return best;
}

device_choice device_choice::of_this_machine() {
  // A file of the trial that timed each device once, one after the other, is not believed: on a
  // busy machine it took a slower one, for good.
  return {cache_file(), "trial 2\n" + installed_drivers(driver_manifests())};
}

std::optional<chosen_device> device_choice::kept() const {
  std::ifstream in(file_);
  std::string drivers;
  chosen_device choice;
  if (!std::getline(in, drivers) || !std::getline(in, choice.name) || choice.name.empty() ||
      drivers != to_hex(hash_bytes(std::as_bytes(std::span(drivers_)))))
    return {};
  std::getline(in, choice.notice);
  return choice;
}

void device_choice::keep(const chosen_device& choice) const {
  std::error_code ignored;
  std::filesystem::create_directories(file_.parent_path(), ignored);
  std::ofstream(file_) << to_hex(hash_bytes(std::as_bytes(std::span(drivers_)))) << '\n'
                       << choice.name << '\n'
                       << choice.notice << '\n';
}

}  // namespace tedit::fem
