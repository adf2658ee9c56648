// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace tedit::picture {

struct picture_options {
  std::string input;   ///< VTU file.
  std::string output;  ///< PNG file.
  std::string field = "von_mises_pa";
  std::string unit = "MPa";                        ///< Unit of the legend.
  double scale = 1e-6;                             ///< Field value times this is in `unit`.
  std::optional<std::pair<double, double>> range;  ///< In `unit`; automatic when empty.
  /// Blue below zero, red above it; without a range it reaches as far on both sides. Always so for
  /// a difference of versions, whose points without a value are grey.
  bool diverging = false;
  std::string title;
  std::string caption;  ///< Small print at the lower edge: what the numbers are worth.
  int width = 1600;
  int height = 1000;
  std::string view = "iso";  ///< iso, x, y, z, -x, -y, -z.
  double zoom = 1;           ///< Above 1: nearer.
  std::optional<std::array<double, 3>>
    focus;             ///< m: what lies in the middle; the part's when empty.
  double deform = 0;   ///< Factor on the field displacement_m; 0 for none.
  bool edges = false;  ///< Draw the mesh.
};

/// Draws the boundary of a VTU file coloured by a field. Vectors are drawn by magnitude.
/// Errors: `io_error`, `bad_input` naming the fields that there are.
[[nodiscard]] expected<void> draw_picture(const picture_options& options);

}  // namespace tedit::picture
