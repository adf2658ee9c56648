// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tedit::desktop {

/// What can be drawn on the surface.
enum class shown_field {
  none,
  surfaces,
  von_mises,
  displacement,
  displacement_x,
  displacement_y,
  displacement_z,
  safety_factor
};

[[nodiscard]] QString field_title(shown_field field);
/// SI: "Pa", "m" or nothing.
[[nodiscard]] QString field_unit(shown_field field);
/// For scripts and settings: "von_mises".
[[nodiscard]] QString field_id(shown_field field);
/// `none` when there is no such id.
[[nodiscard]] shown_field field_from_id(const QString& id);

enum class range_mode {
  automatic,  ///< From the smallest to the largest value, anew with each field.
  manual,     ///< As the user typed it.
  locked      ///< As it was when it was locked: versions can be compared.
};

enum class colour_map { viridis, cividis, grey, coolwarm };

/// Red, green, blue in [0,1].
using rgb = std::array<float, 3>;

/// The colour at `at` in [0,1]; outside that the ends. Viridis, cividis: perceptually even and
/// readable with colour blindness; coolwarm: diverging, for differences.
[[nodiscard]] rgb colour(colour_map map, double at);

/// How values become colours.
struct legend {
  shown_field field = shown_field::von_mises;
  range_mode mode = range_mode::automatic;
  double low = 0;   ///< SI.
  double high = 1;  ///< SI; above `low`.
  bool logarithmic = false;
  colour_map map = colour_map::viridis;
  bool reversed = false;
  QString title;  ///< Instead of the field's; may be empty.

  /// Takes the range of new values when the mode is automatic; a uniform field gets a range around
  /// its value. Values that are not finite do not count.
  void fit(std::span<const float> values);

  /// Where a value lies on the scale, in [0,1].
  [[nodiscard]] double place(double value) const;

  /// At most `most` round values between low and high, ascending, in SI; with a logarithmic scale
  /// powers of ten and their halves.
  [[nodiscard]] std::vector<double> ticks(int most) const;
};

}  // namespace tedit::desktop
