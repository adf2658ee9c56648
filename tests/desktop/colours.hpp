// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

namespace tedit::desktop {

/// CIE L*a*b* (D65) of a colour in sRGB, each channel in [0,1].
inline std::array<double, 3> lab_of(const std::array<double, 3>& c) {
  std::array<double, 3> light{};
  for (std::size_t i = 0; i < 3; ++i)
    light[i] = c[i] <= 0.04045 ? c[i] / 12.92 : std::pow((c[i] + 0.055) / 1.055, 2.4);
  const auto f = [](double t) {
    return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  };
  const double x =
    f((0.4124564 * light[0] + 0.3575761 * light[1] + 0.1804375 * light[2]) / 0.95047);
  const double y = f(0.2126729 * light[0] + 0.7151522 * light[1] + 0.0721750 * light[2]);
  const double z =
    f((0.0193339 * light[0] + 0.1191920 * light[1] + 0.9503041 * light[2]) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// Their distance (CIE 1976).
inline double delta_e(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  const auto p = lab_of(a);
  const auto q = lab_of(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

}  // namespace tedit::desktop
