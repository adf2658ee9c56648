// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/part_framing.hpp"

#include <QPolygonF>

#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tedit::desktop {

void part_framing::set_part(std::shared_ptr<const part_geometry> part) {
  part_ = std::move(part);
  eye_.set_box(part_->bounds);
  if (!fitted_)
    fit();
}

void part_framing::expect_another() {
  fitted_ = false;
  keeps_fitted_ = true;
}

void part_framing::fit(const std::vector<surface_id>& around) {
  if (!part_)
    return;
  auto bounds = part_->bounds;
  if (!around.empty()) {
    const auto some = extract(*part_, around);
    if (some->GetNumberOfCells() > 0)
      some->GetCellsBounds(bounds.data());
  }
  fitted_ = true;
  fitted_left_ = left_margin_;
  eye_.set_left_margin(static_cast<double>(left_margin_) / std::max(1, size_.width()));
  eye_.set_lower_margin(static_cast<double>(lower_margin_) / std::max(1, size_.height()));
  fit_beside_corner(bounds);
  whole_ = around.empty() ? std::optional(eye_.get()) : std::nullopt;
  emit moved();
}

/// Whether what covers the corner lies over a side of a box, as it would be drawn.
bool part_framing::covers(const box& bounds) const {
  std::array<QPointF, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto [x, y] =
      eye_.to_pixel({bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2 & 1)]});
    corners[i] = {x, size_.height() - y};
  }
  constexpr std::array<std::array<std::size_t, 4>, 6> sides{
    {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
  return std::ranges::any_of(sides, [&](const auto& side) {
    QPolygonF shape;
    for (const auto i : side)
      shape << corners[i];
    return shape.intersects(QPolygonF(QRectF(corner_)));
  });
}

/// Of the two ways around the corner, to the left of it and below it, the one that leaves the part
/// larger, and of that no more than is needed.
void part_framing::fit_beside_corner(const box& bounds) {
  eye_.set_corner_margins(0, 0);
  eye_.fit(bounds);
  if (corner_.isEmpty() || size_.isEmpty() || !covers(bounds))
    return;
  const auto size_of = [&] { return 1 / eye_.metres_per_pixel(); };
  const auto fit_with = [&](double right, double upper) {
    eye_.set_corner_margins(right, upper);
    eye_.fit(bounds);
    return !covers(bounds);
  };
  const double widest = static_cast<double>(size_.width() - corner_.left()) / size_.width();
  const double highest = static_cast<double>(corner_.bottom() + 1) / size_.height();
  const auto least = [&](double right, double upper) {
    constexpr int halvings = 7;  // To a pixel.
    double low = 0;
    double high = 1;
    for (int i = 0; i < halvings; ++i) {
      const double middle = (low + high) / 2;
      (fit_with(middle * right, middle * upper) ? high : low) = middle;
    }
    return fit_with(high * right, high * upper) ? std::pair(size_of(), high) : std::pair(0.0, 1.0);
  };
  const auto [beside, right] = least(widest, 0);
  const auto [below, upper] = least(0, highest);
  if (beside > below)
    fit_with(right * widest, 0);
  else
    fit_with(0, upper * highest);
}

void part_framing::set_corner(const QRect& covered) {
  if (std::exchange(corner_, covered) != covered)
    fit_again();
}

void part_framing::set_left_margin(int pixels) {
  if (std::exchange(left_margin_, pixels) != pixels)
    fit_again();
}

void part_framing::set_lower_margin(int pixels) {
  if (std::exchange(lower_margin_, pixels) != pixels)
    fit_again();
}

double part_framing::free_aspect(const QSize& size) const {
  const double width =
    std::max(0.6 * size.width(), static_cast<double>(size.width() - left_margin_));
  return width / std::max(1, size.height() - lower_margin_);
}

void part_framing::set_size(const QSize& size) {
  size_ = size;
  eye_.set_left_margin(static_cast<double>(fitted_left_) / std::max(1, size_.width()));
  fit_again();
}

/// Nor while the part that is drawn is about to be another one.
void part_framing::fit_again() {
  if (fitted_ && keeps_fitted_ && whole_ == eye_.get())
    fit();
}

void part_framing::look_from(camera::direction from) {
  eye_.look_from(from);
  fit();
}

void part_framing::fly_to(const vec3& place) {
  eye_.focus_on(place);
  emit moved();
}

}  // namespace tedit::desktop
