// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>

namespace tedit::desktop {

/// 1, 2 or 5 times a power of ten: the smallest that is at least `least`, which is above 0.
[[nodiscard]] inline double round_step(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least * (1 - 1e-9))
      return factor * power;
  return 10 * power;
}

}  // namespace tedit::desktop
