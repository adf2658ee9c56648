// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "fem/load_case.hpp"

namespace tedit::desktop {

/// The load cases of a version as a person changed them, so that undo and redo go over those
/// changes as they go over edits: each version keeps its own steps. Only changes that were asked
/// for here are in it; where somebody else changed the load cases since, its steps are void.
class load_history {
public:
  using load_cases = std::vector<fem::load_case>;

  /// A change that the server granted. What was undone before it cannot be redone any more.
  void changed(std::uint32_t version, load_cases before, load_cases after);

  /// The load cases to go back to from `now`; none when the last step of this version is no change
  /// of loads that led to `now`.
  [[nodiscard]] const load_cases* to_undo(std::uint32_t version, const load_cases& now) const;
  /// The load cases that the last undo took away; none when there are none.
  [[nodiscard]] const load_cases* to_redo(std::uint32_t version, const load_cases& now) const;
  /// Undo, redo: `to_undo`, `to_redo` are the load cases now. Nothing when there is none.
  void undone(std::uint32_t version);
  void redone(std::uint32_t version);

  void clear() { of_version_.clear(); }

private:
  /// States in their order; `at` is the present one.
  struct steps {
    std::vector<load_cases> states;
    std::size_t at = 0;
  };
  [[nodiscard]] const steps* standing(std::uint32_t version, const load_cases& now) const;

  std::map<std::uint32_t, steps> of_version_;
};

}  // namespace tedit::desktop
