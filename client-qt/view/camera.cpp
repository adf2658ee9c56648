// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/camera.hpp"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tedit::desktop {

namespace {

constexpr double border = 1.12;  // Of what is seen, when it is made to fit.

vec3 unit(const vec3& v) {
  const double size = std::sqrt(dot(v, v));
  return size > 0 ? v / size : vec3{0, 0, 1};
}

vec3 to_vec3(const double* p) {
  return {p[0], p[1], p[2]};
}

}  // namespace

camera::camera(vtkRenderer* renderer) : renderer_(renderer) {
  look_from(direction::isometric);
}

void camera::rotate(double dx, double dy) {
  auto* c = renderer_->GetActiveCamera();
  c->Azimuth(-180 * dx);
  c->Elevation(180 * dy);
  c->OrthogonalizeViewUp();
  adjust_depth();
}

void camera::pan(double dx, double dy) {
  auto* c = renderer_->GetActiveCamera();
  const auto now = get();
  const auto pixel = to_pixel(now.focus);
  renderer_->SetDisplayPoint(pixel.x - dx, pixel.y - dy, pixel.z);
  renderer_->DisplayToWorld();
  std::array<double, 4> w{};
  renderer_->GetWorldPoint(w.data());
  if (w[3] == 0)
    return;
  const vec3 moved = vec3{w[0] / w[3], w[1] / w[3], w[2] / w[3]} - now.focus;
  const vec3 focus = now.focus + moved;
  const vec3 position = now.position + moved;
  c->SetFocalPoint(focus.x, focus.y, focus.z);
  c->SetPosition(position.x, position.y, position.z);
  adjust_depth();
}

void camera::zoom(double factor, double x, double y) {
  auto* c = renderer_->GetActiveCamera();
  const vec3 middle = to_pixel(get().focus);
  const double dx = x - middle.x;
  const double dy = y - middle.y;
  pan(-dx, -dy);
  if (c->GetParallelProjection())
    c->SetParallelScale(c->GetParallelScale() / factor);
  else
    c->Dolly(factor);
  adjust_depth();
  pan(dx, dy);
}

void camera::look_from(direction from) {
  vec3 at{-0.55, -1, 0.75};
  vec3 up{0, 0, 1};
  switch (from) {
    case direction::front:
      at = {0, -1, 0};
      break;
    case direction::back:
      at = {0, 1, 0};
      break;
    case direction::left:
      at = {-1, 0, 0};
      break;
    case direction::right:
      at = {1, 0, 0};
      break;
    case direction::top:
      at = {0, 0, 1};
      up = {0, 1, 0};
      break;
    case direction::bottom:
      at = {0, 0, -1};
      up = {0, 1, 0};
      break;
    case direction::isometric:
      break;
  }
  const auto now = get();
  const vec3 away = now.position - now.focus;
  const double distance = std::sqrt(dot(away, away)) / std::sqrt(dot(at, at));
  set({now.focus + distance * at, now.focus, up, now.parallel_scale});
}

/// VTK fits the sphere around, which leaves flat parts small: here the box's corners fit.
void camera::fit(const std::array<double, 6>& bounds) {
  if (bounds[0] > bounds[1])
    return;
  auto* c = renderer_->GetActiveCamera();
  auto now = get();
  const vec3 back = unit(now.position - now.focus);
  const vec3 right = unit(cross(now.up, back));
  const vec3 up = cross(back, right);
  const int* size = renderer_->GetSize();
  const double aspect =
    (1 - left_margin_) * (size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 1);
  const double slope = std::tan(c->GetViewAngle() * std::numbers::pi / 360);
  now.focus = {(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2,
               (bounds[4] + bounds[5]) / 2};
  double half_height = 0;
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const vec3 p =
      vec3{bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2 & 1)]} -
      now.focus;
    const double reach = std::max(std::abs(dot(p, up)), std::abs(dot(p, right)) / aspect);
    half_height = std::max(half_height, reach);
    distance = std::max(distance, dot(p, back) + border * reach / slope);
  }
  now.position = now.focus + std::max(distance, 1e-12) * back;
  now.up = up;
  now.parallel_scale = border * half_height;
  set(now);
}

void camera::set_left_margin(double share) {
  left_margin_ = std::clamp(share, 0.0, 0.4);
  // The picture's middle moves, the focus stays.
  renderer_->GetActiveCamera()->SetWindowCenter(-left_margin_, 0);
}

void camera::focus_on(const vec3& place) {
  auto now = get();
  now.position = now.position + (place - now.focus);
  now.focus = place;
  set(now);
}

void camera::set_parallel(bool on) {
  renderer_->GetActiveCamera()->SetParallelProjection(on);
  adjust_depth();
}

bool camera::is_parallel() const {
  return renderer_->GetActiveCamera()->GetParallelProjection() != 0;
}

bool camera::is_within(const std::array<double, 6>& box) const {
  const vec3 at = get().position;
  return !is_parallel() && at.x >= box[0] && at.x <= box[1] && at.y >= box[2] && at.y <= box[3] &&
         at.z >= box[4] && at.z <= box[5];
}

camera::pose camera::get() const {
  auto* c = renderer_->GetActiveCamera();
  return {to_vec3(c->GetPosition()), to_vec3(c->GetFocalPoint()), to_vec3(c->GetViewUp()),
          c->GetParallelScale()};
}

void camera::set(const pose& wanted) {
  auto* c = renderer_->GetActiveCamera();
  c->SetPosition(wanted.position.x, wanted.position.y, wanted.position.z);
  c->SetFocalPoint(wanted.focus.x, wanted.focus.y, wanted.focus.z);
  c->SetViewUp(wanted.up.x, wanted.up.y, wanted.up.z);
  c->SetParallelScale(wanted.parallel_scale);
  adjust_depth();
}

std::array<vec3, 2> camera::ray(double x, double y) const {
  std::array<vec3, 2> ends{};
  for (int i = 0; i < 2; ++i) {
    renderer_->SetDisplayPoint(x, y, i);
    renderer_->DisplayToWorld();
    std::array<double, 4> w{};
    renderer_->GetWorldPoint(w.data());
    const double scale = w[3] == 0 ? 1 : 1 / w[3];
    ends[i] = {w[0] * scale, w[1] * scale, w[2] * scale};
  }
  return ends;
}

vec3 camera::to_pixel(const vec3& at) const {
  renderer_->SetWorldPoint(at.x, at.y, at.z, 1);
  renderer_->WorldToDisplay();
  return to_vec3(renderer_->GetDisplayPoint());
}

camera::projection camera::to_pixels() const {
  projection result;
  const int* size = renderer_->GetSize();
  result.width = size[0];
  result.height = size[1];
  const double aspect = result.width / std::max(1.0, result.height);
  auto* matrix = renderer_->GetActiveCamera()->GetCompositeProjectionTransformMatrix(aspect, 0, 1);
  std::copy_n(matrix->GetData(), result.matrix.size(), result.matrix.begin());
  return result;
}

std::array<double, 2> camera::projection::apply(const vec3& at) const {
  const auto row = [&](std::size_t r) {
    const double* m = &matrix[4 * r];
    return m[0] * at.x + m[1] * at.y + m[2] * at.z + m[3];
  };
  const double w = row(3);
  return {(row(0) / w + 1) / 2 * width, (row(1) / w + 1) / 2 * height};
}

void camera::adjust_depth() {
  renderer_->ResetCameraClippingRange();
}

}  // namespace tedit::desktop
