// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QSettings>
#include <QString>

#include <vector>

#include "client-qt/model/commands.hpp"
#include "client-qt/model/legend.hpp"
#include "client/types.hpp"

namespace tedit::desktop {

enum class look_wish { system, light, dark };

/// How a drag turns the part: as a turntable does, upright, or freely.
enum class turning_wish { turntable, orbit };

/// What the log shows: each takes in those before it.
enum class log_level { errors, notices, everything };

/// What a person set once for all parts.
struct preferences {
  QString language;  ///< "de", ...; empty: the system's.
  look_wish look = look_wish::system;
  turning_wish turning = turning_wish::turntable;
  QString device;  ///< "cpu", "gpu", ...; empty: the server's default.
  int element_order = 2;
  double energy_tolerance = 0;  ///< A preview at this estimated relative error; 0: none.
  colour_map map = colour_map::viridis;
  bool locked = false;  ///< The range of the first field holds for all that follow.
  bool logarithmic = false;
  log_level log = log_level::everything;

  friend bool operator==(const preferences&, const preferences&) = default;
};

/// What is kept; values that make no sense are as if they were not there.
[[nodiscard]] preferences load_preferences(const QSettings& settings);
void save(const preferences& wanted, QSettings& settings);
/// The settings of a solve of all load cases.
[[nodiscard]] client::solve_settings solve_settings_of(const preferences& wanted);

/// The keys of all commands: those that each came with, or a person's own, which are kept.
class shortcut_table {
public:
  shortcut_table(const commands& all, QSettings& settings) : all_(all), settings_(settings) {}

  [[nodiscard]] QString keys(const command& what) const;
  /// Other commands with these keys.
  [[nodiscard]] std::vector<const command*> others_with(const QString& keys,
                                                        const QString& id) const;
  /// The keys that a command came with again, when they are these.
  void set(const command& what, const QString& keys);
  void reset_all();
  /// All that have keys, group by group, for a sheet on the wall.
  [[nodiscard]] QString as_text() const;
  [[nodiscard]] const commands& all() const noexcept { return all_; }

private:
  const commands& all_;
  QSettings& settings_;
};

}  // namespace tedit::desktop
