// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace tedit::fem {

/// The manifests of the Vulkan drivers that its loader would find (LoaderDriverInterface, "Linux
/// driver discovery"): the files of its folders, then each file that a variable of the environment
/// names, after the name of that variable.
[[nodiscard]] std::vector<std::filesystem::path> driver_manifests();

/// A text that changes when drivers or graphics cards come, go or are exchanged: manifests by name,
/// size and time, the cards' device files, the version of a driver without a manifest of its own
/// for each release. No driver is loaded, which takes 20 to 200 ms. Cost: a few folders are listed.
[[nodiscard]] std::string installed_drivers(const std::vector<std::filesystem::path>& manifests);

/// A device for "auto", and what a person should know about the choice: which devices failed their
/// trial, and how. Mostly empty.
struct chosen_device {
  std::string name;
  std::string notice = {};

  friend bool operator==(const chosen_device&, const chosen_device&) = default;
};

/// How a device did in its trial.
struct device_trial {
  std::string name;
  expected<double> ms;  ///< Of a solve; or why there was none.
};

/// A device in the trial of all.
struct contestant {
  std::string name;
  std::function<expected<double>()> solve_ms;  ///< One solve; its time in ms.
};

/// Each contestant solves once without being timed, then all take turns, three times each; the
/// least time of each counts, or its first error, after which it is not asked again. Turns and the
/// least: what else runs on the machine comes and goes, and may slow one solve four times over; a
/// choice made by it would be kept. Cost: four solves of each.
[[nodiscard]] std::vector<device_trial> try_devices(const std::vector<contestant>& contestants);

/// The fastest of those that solved; "cpu" where none did. The notice names all others.
[[nodiscard]] chosen_device choose_device(const std::vector<device_trial>& trials);

/// The device that was the fastest, kept in a file for as long as the drivers are the same.
class device_choice {
public:
  device_choice(std::filesystem::path file, std::string drivers)
      : file_(std::move(file)), drivers_(std::move(drivers)) {}

  /// Of this user and this machine.
  [[nodiscard]] static device_choice of_this_machine();

  /// Nothing when none is kept, or with other drivers.
  [[nodiscard]] std::optional<chosen_device> kept() const;
  /// Where that is impossible, nothing is kept: it costs another trial, nothing else.
  void keep(const chosen_device& choice) const;

private:
  std::filesystem::path file_;
  std::string drivers_;
};

}  // namespace tedit::fem
