// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/part_framing.hpp"

#include <vtkPolyData.h>

#include <algorithm>
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
  eye_.set_lower_margin(static_cast<double>(lower_margin_) / std::max(1, size_.height()));
  eye_.fit(bounds);
  whole_ = around.empty() ? std::optional(eye_.get()) : std::nullopt;
  emit moved();
}

void part_framing::set_left_margin(int pixels) {
  left_margin_ = pixels;
  eye_.set_left_margin(static_cast<double>(pixels) / std::max(1, size_.width()));
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
  set_left_margin(left_margin_);
  fit_again();
}

void part_framing::fit_again() {
  if (keeps_fitted_ && whole_ == eye_.get())
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
