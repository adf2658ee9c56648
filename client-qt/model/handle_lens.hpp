// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QSizeF>

#include <array>
#include <functional>
#include <optional>

#include "mesh/vec3.hpp"

/// Between the screen and space, as far as handles need it: plain geometry without a window.
namespace tedit::desktop {

/// A way of looking at the part. Pixels from the upper left.
struct lens {
  std::function<QPointF(const vec3&)> to_screen;
  std::function<std::array<vec3, 2>(QPointF)> ray;  ///< From before the part to behind it, m.
  vec3 right{1, 0, 0};                              ///< Unit, on the screen.
  vec3 up{0, 1, 0};
  QSizeF room;         ///< Of the view, pixels; empty: without end.
  double step = 1e-3;  ///< m: small beside the part, for measuring scales.

  /// Whether a knob there can be seen and grabbed.
  [[nodiscard]] bool shows(QPointF at) const;
  /// How long a pixel is there, m.
  [[nodiscard]] double metres_per_pixel(const vec3& at) const;
};

/// How far along an axis (`along` is unit) the point of it is that is nearest to a ray, m. Nothing
/// where they are within 8 degrees of parallel: a pixel would be metres.
[[nodiscard]] std::optional<double> along_axis(const std::array<vec3, 2>& ray, const vec3& at,
                                               const vec3& along);

/// Where a ray meets a plane. Nothing where it passes within 6 degrees of along it.
[[nodiscard]] std::optional<vec3> on_plane(const std::array<vec3, 2>& ray, const vec3& at,
                                           const vec3& normal);

/// Where a ray meets a sphere first (`near`) or last; beside it the point of the sphere that is
/// nearest to the ray.
[[nodiscard]] vec3 on_sphere(const std::array<vec3, 2>& ray, const vec3& middle, double radius,
                             bool near);

/// What a drag moves by, m: the next round step (`round_step`), however small a pixel is.
[[nodiscard]] double drag_step(double least);

[[nodiscard]] double pixels_between(QPointF a, QPointF b);

}  // namespace tedit::desktop
