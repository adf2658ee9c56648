// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cmath>

#include "mesh/vec3.hpp"

class vtkCamera;

namespace tedit::desktop {

/// `v / |v|`; up for the zero vector.
[[nodiscard]] inline vec3 unit_or_up(const vec3& v) {
  const double size = std::sqrt(dot(v, v));
  return size > 0 ? v / size : vec3{0, 0, 1};
}

/// Where a view is looked at from, moved as a hand would: about the middle of what is seen. Pixels
/// are the widget's, from its lower left. The renderer, which belongs to another thread, gets
/// copies.
class camera {
public:
  enum class direction { front, back, left, right, top, bottom, isometric };

  /// How a drag turns the part: `turntable` about the z axis, which stays upright, and up and down
  /// between the poles; `orbit` any way, also head over heels.
  enum class turning { turntable, orbit };

  /// Position, focus and up vector, m; and the size of what a parallel view shows.
  struct pose {
    vec3 position;
    vec3 focus;
    vec3 up;
    double parallel_scale = 1;

    friend bool operator==(const pose&, const pose&) = default;
  };

  /// From space to pixels, as it was when it was asked for.
  struct projection {
    std::array<double, 16> matrix{};  ///< Row by row, to [-1,1] each way.
    double width = 0;                 ///< Pixels.
    double height = 0;

    [[nodiscard]] std::array<double, 2> apply(const vec3& at) const;
  };

  camera();
  ~camera();

  /// The view's size in pixels.
  void set_size(double width, double height);
  /// What rays begin before and end behind: x low, x high, y low, ...
  void set_box(const std::array<double, 6>& box);

  /// For a renderer.
  [[nodiscard]] vtkSmartPointer<vtkCamera> copy() const;

  void set_turning(turning how) noexcept { turning_ = how; }
  [[nodiscard]] turning turns() const noexcept { return turning_; }
  /// By parts of the view's height: a full height turns by 180 degrees. To the right and down.
  void rotate(double dx, double dy);
  /// By pixels, to the right and up.
  void pan(double dx, double dy);
  /// Above 1 nearer; the point at the pixel stays where it is.
  void zoom(double factor, double x, double y);
  void look_from(direction from);
  void fit(const std::array<double, 6>& bounds);
  /// Keeps a part of the view's width at its left free when something is made to fit; turning still
  /// goes about the middle of what is seen. In [0, 0.4].
  void set_left_margin(double share);
  /// The same of its height, at the lower edge.
  void set_lower_margin(double share);
  /// The same at the right and at the top: two ways to leave the upper right corner free.
  void set_corner_margins(double right, double upper);
  /// Moves the focus to a place and keeps direction and distance.
  void focus_on(const vec3& place);
  void set_parallel(bool on);
  [[nodiscard]] bool is_parallel() const;

  [[nodiscard]] pose get() const;
  void set(const pose& wanted);

  /// The ray through a pixel, from before the box to behind it.
  [[nodiscard]] std::array<vec3, 2> ray(double x, double y) const;
  /// The pixel of a point.
  [[nodiscard]] std::array<double, 2> to_pixel(const vec3& at) const;

  [[nodiscard]] projection to_pixels() const;
  /// How long a pixel is at the focus, m; everywhere with parallel rays.
  [[nodiscard]] double metres_per_pixel() const;

  /// Whether the viewer stands in a box: x low, x high, y low, ...; never with parallel rays.
  [[nodiscard]] bool is_within(const std::array<double, 6>& box) const;

private:
  void turn(double dx, double dy);
  void move_middle();
  void adjust_depth();
  [[nodiscard]] std::array<double, 16> matrix() const;

  vtkNew<vtkCamera> camera_;
  std::array<double, 6> box_{-1, 1, -1, 1, -1, 1};
  double width_ = 1;
  double height_ = 1;
  double left_margin_ = 0;
  double lower_margin_ = 0;
  double right_margin_ = 0;
  double upper_margin_ = 0;
  turning turning_ = turning::turntable;
};

}  // namespace tedit::desktop
