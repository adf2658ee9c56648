// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>

namespace tedit {

/// Wall-clock time since construction or the last `restart`.
class stopwatch {
public:
  [[nodiscard]] double milliseconds() const {
    return std::chrono::duration<double, std::milli>(clock::now() - start_).count();
  }

  /// Returns the time so far and starts again from zero.
  double restart() {
    const double elapsed = milliseconds();
    start_ = clock::now();
    return elapsed;
  }

private:
  using clock = std::chrono::steady_clock;
  clock::time_point start_ = clock::now();
};

}  // namespace tedit
