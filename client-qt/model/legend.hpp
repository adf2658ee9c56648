// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fem/quantities.hpp"

namespace tedit::desktop {

/// What can be drawn on the surface: a row of `fem::shown_quantities`, or one of two that are of no
/// result. The table knows each; a name here is for code that means it in particular.
struct shown_field {
  int row = -2;

  static const shown_field none;
  static const shown_field surfaces;
  static const shown_field von_mises;
  static const shown_field displacement;
  static const shown_field displacement_x;
  static const shown_field displacement_y;
  static const shown_field displacement_z;
  static const shown_field safety_factor;

  friend auto operator<=>(const shown_field&, const shown_field&) = default;
};

/// By its id in the table.
consteval shown_field field_named(std::string_view id) {
  const auto* found = std::ranges::find(fem::shown_quantities, id, &fem::shown_quantity::id);
  if (found == std::end(fem::shown_quantities))
    throw "there is no such field";  // The program does not compile then.
  return {static_cast<int>(found - fem::shown_quantities)};
}

inline constexpr shown_field shown_field::none{-2};
inline constexpr shown_field shown_field::surfaces{-1};
inline constexpr shown_field shown_field::von_mises = field_named("von_mises");
inline constexpr shown_field shown_field::displacement = field_named("displacement");
inline constexpr shown_field shown_field::displacement_x = field_named("displacement_x");
inline constexpr shown_field shown_field::displacement_y = field_named("displacement_y");
inline constexpr shown_field shown_field::displacement_z = field_named("displacement_z");
inline constexpr shown_field shown_field::safety_factor = field_named("safety_factor");

/// Its row. @pre It is of a result.
[[nodiscard]] inline const fem::shown_quantity& quantity_of(shown_field field) {
  return fem::shown_quantities[field.row];
}
[[nodiscard]] inline bool is_of_result(shown_field field) {
  return field.row >= 0;
}

[[nodiscard]] QString field_title(shown_field field);
/// One or two sentences: what it says, and what it does not.
[[nodiscard]] QString field_help(shown_field field);
/// SI: "Pa", "m", "m/m" (shown as µm/m), "ratio" (shown as %) or nothing.
[[nodiscard]] QString field_unit(shown_field field);
/// A value with its unit; safety factors from 1000 on are "over 1000".
[[nodiscard]] QString field_value(shown_field field, double value);
/// All that can be chosen, in groups of what belongs together.
[[nodiscard]] const std::vector<std::vector<shown_field>>& field_groups();

using fem::field_kind;
[[nodiscard]] field_kind kind_of(shown_field field);
/// Whether the envelope of several load cases has it.
[[nodiscard]] bool in_envelope(shown_field field);
/// For scripts and settings: "von_mises".
[[nodiscard]] QString field_id(shown_field field);
/// `none` when there is no such id.
[[nodiscard]] shown_field field_from_id(const QString& id);

enum class range_mode {
  automatic,  ///< Up to what a hundredth of the area is above, anew with each field: one hot
              ///< corner does not take the colours from all the rest.
  full,       ///< From the smallest to the largest value, anew with each field.
  manual,     ///< As the user typed it.
  locked      ///< As it was when it was locked: versions can be compared.
};

enum class colour_map { viridis, cividis, grey, coolwarm, safety };

/// Red, green, blue in [0,1].
using rgb = std::array<float, 3>;

/// The colour at `at` in [0,1]; outside that the ends. Viridis, cividis: perceptually even and
/// readable with colour blindness, viridis with a low end that is light enough for a shaded part;
/// coolwarm: diverging, for what has a sign; safety: six steps from red (below 1) to blue.
[[nodiscard]] rgb colour(colour_map map, double at);

/// Where the steps of the safety map begin and end, from 0 on.
inline constexpr std::array<double, 7> safety_steps{0, 1, 1.5, 2, 3, 5, 10};

/// How values become colours.
struct legend {
  shown_field field = shown_field::von_mises;
  range_mode mode = range_mode::automatic;
  double low = 0;   ///< SI.
  double high = 1;  ///< SI; above `low`.
  bool logarithmic = false;
  colour_map map = colour_map::viridis;
  bool reversed = false;
  QString title;                 ///< Instead of the field's; may be empty.
  int bands = 0;                 ///< So many steps of one colour each; 0: smooth.
  std::optional<double> beyond;  ///< The largest value, when it is above the scale; its size when
                                 ///< it has a sign.

  /// Takes the range of new values when the mode is automatic or full; a uniform field gets a range
  /// around its value; with the diverging map 0 is in its middle. Values that are not finite do not
  /// count. `areas`: what each value stands for; without them the automatic range is the full one.
  /// Cost: O(values).
  void fit(std::span<const float> values, std::span<const float> areas = {});

  /// The colour at a place of the scale, by its bands.
  [[nodiscard]] rgb colour_at(double place) const;

  /// The values at which colours or, when they are smooth, labelled lines change: the edges of the
  /// bands without the ends of the scale, ascending, SI.
  [[nodiscard]] std::vector<double> levels() const;

  /// The value at a place of the scale: what `place` undoes.
  [[nodiscard]] double value(double place) const;

  /// Where a value lies on the scale, in [0,1].
  [[nodiscard]] double place(double value) const;

  /// At most `most` round values between low and high, ascending, in SI; with a logarithmic scale
  /// powers of ten and their halves.
  [[nodiscard]] std::vector<double> ticks(int most) const;

  /// Where numbers stand beside the scale: both of its ends, and the ticks that are far enough from
  /// them and from each other for so many numbers; ascending.
  [[nodiscard]] std::vector<double> labels(int most) const;
  /// Such a number in the unit that is shown, rounded by the size of the range; at the upper end of
  /// the safety steps what its colour means: "5 or more".
  [[nodiscard]] QString label(double value) const;

  /// Whether both give any values the same colours: a range that follows them is that of the
  /// values.
  [[nodiscard]] bool draws_like(const legend& other) const;

  friend bool operator==(const legend&, const legend&) = default;

private:
  [[nodiscard]] bool follows_values() const;
  void cap(std::span<const float> values, std::span<const float> areas, bool both_ways);
};

}  // namespace tedit::desktop
