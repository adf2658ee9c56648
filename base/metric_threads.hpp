// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace tedit {

/// An ISO metric coarse thread, and what is drilled before it is cut.
struct metric_thread {
  const char* name = "";  ///< "M6".
  double core = 0;        ///< m: the diameter.
};

/// Source: ISO 2306, tap drills of coarse pitches.
inline constexpr std::array<metric_thread, 13> metric_threads{{{"M2", 1.6e-3},
                                                               {"M2.5", 2.05e-3},
                                                               {"M3", 2.5e-3},
                                                               {"M4", 3.3e-3},
                                                               {"M5", 4.2e-3},
                                                               {"M6", 5.0e-3},
                                                               {"M8", 6.8e-3},
                                                               {"M10", 8.5e-3},
                                                               {"M12", 10.2e-3},
                                                               {"M14", 12.0e-3},
                                                               {"M16", 14.0e-3},
                                                               {"M20", 17.5e-3},
                                                               {"M24", 21.0e-3}}};

/// The core diameter (m) of the thread of this name; nothing for what is none.
[[nodiscard]] constexpr std::optional<double> metric_thread_core(std::string_view name) {
  for (const auto& thread : metric_threads)
    if (name == thread.name)
      return thread.core;
  return std::nullopt;
}

}  // namespace tedit
