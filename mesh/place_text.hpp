// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

#include "mesh/vec3.hpp"

namespace tedit {

/// A place as messages name it: "(1.5, 2, 0) mm" for one in m. Below a millionth of a millimetre is
/// 0: people must not read the rounding errors of a coordinate.
[[nodiscard]] inline std::string place_text(const vec3& at) {
  const auto shown = [](double metres) {
    const double mm = 1e3 * metres;
    return std::abs(mm) < 1e-6 ? 0.0 : mm;
  };
  char text[96];
  std::snprintf(text, sizeof(text), "(%.4g, %.4g, %.4g) mm", shown(at.x), shown(at.y), shown(at.z));
  return text;
}

}  // namespace tedit
