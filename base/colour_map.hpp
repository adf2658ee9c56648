// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

namespace tedit {

/// A colour at eleven even steps: red, green, blue, each 0 to 1.
using colour_steps = std::array<std::array<double, 3>, 11>;

/// Smith & van der Walt 2015, CC0: perceptually even, readable with colour blindness.
inline constexpr colour_steps viridis{{{0.267, 0.005, 0.329},
                                       {0.283, 0.141, 0.458},
                                       {0.254, 0.265, 0.530},
                                       {0.207, 0.372, 0.553},
                                       {0.164, 0.471, 0.558},
                                       {0.128, 0.567, 0.551},
                                       {0.135, 0.659, 0.518},
                                       {0.267, 0.749, 0.441},
                                       {0.478, 0.821, 0.318},
                                       {0.741, 0.873, 0.150},
                                       {0.993, 0.906, 0.144}}};

/// From blue over a light grey to red in even steps of lightness (Moreland 2009, "cool to warm"):
/// what is near zero steps back, and a sign is never mistaken.
inline constexpr colour_steps cool_to_warm{{{0.230, 0.299, 0.754},
                                            {0.348, 0.466, 0.888},
                                            {0.484, 0.622, 0.975},
                                            {0.619, 0.744, 0.999},
                                            {0.754, 0.830, 0.961},
                                            {0.865, 0.865, 0.865},
                                            {0.947, 0.795, 0.717},
                                            {0.969, 0.679, 0.561},
                                            {0.934, 0.525, 0.412},
                                            {0.839, 0.346, 0.279},
                                            {0.706, 0.016, 0.150}}};

/// The colour between the steps at a share of 0 to 1 of the way through them.
[[nodiscard]] constexpr std::array<double, 3> colour_at(const colour_steps& steps, double share) {
  const double at = 10.0 * std::clamp(share, 0.0, 1.0);
  const auto low = std::min<std::size_t>(9, static_cast<std::size_t>(at));
  std::array<double, 3> result{};
  for (std::size_t k = 0; k < 3; ++k)
    result[k] =
      steps[low][k] + (at - static_cast<double>(low)) * (steps[low + 1][k] - steps[low][k]);
  return result;
}

}  // namespace tedit
