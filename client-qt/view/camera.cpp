// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/camera.hpp"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tedit::desktop {

namespace {

constexpr double border = 1.12;  // Of what is seen, when it is made to fit.

double bounded(double share) {
  return std::clamp(share, 0.0, 0.4);
}

vec3 to_vec3(const double* p) {
  return {p[0], p[1], p[2]};
}

}  // namespace

camera::camera() {
  look_from(direction::isometric);
}

camera::~camera() = default;

void camera::set_size(double width, double height) {
  width_ = std::max(1.0, width);
  height_ = std::max(1.0, height);
}

void camera::set_box(const std::array<double, 6>& box) {
  box_ = box;
  adjust_depth();
}

vtkSmartPointer<vtkCamera> camera::copy() const {
  auto result = vtkSmartPointer<vtkCamera>::New();
  result->DeepCopy(camera_);
  return result;
}

void camera::rotate(double dx, double dy) {
  if (turning_ == turning::turntable)
    return turn(dx, dy);
  camera_->Azimuth(-180 * dx);
  camera_->Elevation(180 * dy);
  camera_->OrthogonalizeViewUp();
  adjust_depth();
}

/// By angles around and above the horizon, which no drag tilts; a pose that is tilted, as an orbit
/// leaves one, is set upright.
void camera::turn(double dx, double dy) {
  auto now = get();
  const vec3 away = now.position - now.focus;
  const double distance = std::sqrt(dot(away, away));
  const vec3 back = unit_or_up(away);
  vec3 right = cross(now.up, back);
  right.z = 0;
  // Head over heels what is right on the screen is left of who stands upright.
  right = dot(right, right) > 1e-18 ? unit_or_up(now.up.z < 0 ? -right : right) : vec3{1, 0, 0};
  const double around = -std::numbers::pi * dx;
  right = {std::cos(around) * right.x - std::sin(around) * right.y,
           std::sin(around) * right.x + std::cos(around) * right.y, 0};
  const double pole = std::numbers::pi / 2;
  const double above =
    std::clamp(std::asin(std::clamp(back.z, -1.0, 1.0)) + std::numbers::pi * dy, -pole, pole);
  const vec3 ahead = cross(vec3{0, 0, 1}, right);
  const vec3 to_eye = std::sin(above) * vec3{0, 0, 1} - std::cos(above) * ahead;
  now.position = now.focus + distance * to_eye;
  now.up = cross(to_eye, right);
  set(now);
}

/// The focus stays in its plane.
void camera::pan(double dx, double dy) {
  const auto now = get();
  const auto pixel = to_pixel(now.focus);
  const auto [from, to] = ray(pixel[0] - dx, pixel[1] - dy);
  const vec3 ahead = unit_or_up(now.focus - now.position);
  const double along = dot(to - from, ahead);
  if (along == 0)
    return;
  const vec3 hit = from + dot(now.focus - from, ahead) / along * (to - from);
  const vec3 moved = hit - now.focus;
  set({now.position + moved, now.focus + moved, now.up, now.parallel_scale});
}

void camera::zoom(double factor, double x, double y) {
  const auto middle = to_pixel(get().focus);
  const double dx = x - middle[0];
  const double dy = y - middle[1];
  pan(-dx, -dy);
  if (camera_->GetParallelProjection())
    camera_->SetParallelScale(camera_->GetParallelScale() / factor);
  else
    camera_->Dolly(factor);
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
  auto now = get();
  const vec3 back = unit_or_up(now.position - now.focus);
  const vec3 right = unit_or_up(cross(now.up, back));
  const vec3 up = cross(back, right);
  const double free_height = 1 - lower_margin_ - upper_margin_;
  const double aspect = (1 - left_margin_ - right_margin_) * width_ / (free_height * height_);
  const double slope = free_height * std::tan(camera_->GetViewAngle() * std::numbers::pi / 360);
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
  now.parallel_scale = border * half_height / free_height;
  set(now);
}

void camera::set_left_margin(double share) {
  left_margin_ = bounded(share);
  move_middle();
}

void camera::set_lower_margin(double share) {
  lower_margin_ = bounded(share);
  move_middle();
}

void camera::set_corner_margins(double right, double upper) {
  right_margin_ = bounded(right);
  upper_margin_ = bounded(upper);
  move_middle();
}

/// The picture's middle moves, the focus stays.
void camera::move_middle() {
  camera_->SetWindowCenter(right_margin_ - left_margin_, upper_margin_ - lower_margin_);
}

void camera::focus_on(const vec3& place) {
  auto now = get();
  now.position = now.position + (place - now.focus);
  now.focus = place;
  set(now);
}

void camera::set_parallel(bool on) {
  camera_->SetParallelProjection(on);
  adjust_depth();
}

bool camera::is_parallel() const {
  return camera_->GetParallelProjection() != 0;
}

bool camera::is_within(const std::array<double, 6>& box) const {
  const vec3 at = get().position;
  return !is_parallel() && at.x >= box[0] && at.x <= box[1] && at.y >= box[2] && at.y <= box[3] &&
         at.z >= box[4] && at.z <= box[5];
}

camera::pose camera::get() const {
  return {to_vec3(camera_->GetPosition()), to_vec3(camera_->GetFocalPoint()),
          to_vec3(camera_->GetViewUp()), camera_->GetParallelScale()};
}

void camera::set(const pose& wanted) {
  camera_->SetPosition(wanted.position.x, wanted.position.y, wanted.position.z);
  camera_->SetFocalPoint(wanted.focus.x, wanted.focus.y, wanted.focus.z);
  camera_->SetViewUp(wanted.up.x, wanted.up.y, wanted.up.z);
  camera_->SetParallelScale(wanted.parallel_scale);
  adjust_depth();
}

/// Row by row, to [-1,1] across and up and to [0,1] in depth.
std::array<double, 16> camera::matrix() const {
  std::array<double, 16> result{};
  auto* by = camera_->GetCompositeProjectionTransformMatrix(width_ / height_, 0, 1);
  std::copy_n(by->GetData(), result.size(), result.begin());
  return result;
}

std::array<vec3, 2> camera::ray(double x, double y) const {
  const auto forth = matrix();
  std::array<double, 16> back{};
  vtkMatrix4x4::Invert(forth.data(), back.data());
  std::array<vec3, 2> ends{};
  for (int i = 0; i < 2; ++i) {
    const std::array<double, 4> at{2 * x / width_ - 1, 2 * y / height_ - 1, static_cast<double>(i),
                                   1};
    std::array<double, 4> w{};
    vtkMatrix4x4::MultiplyPoint(back.data(), at.data(), w.data());
    const double scale = w[3] == 0 ? 1 : 1 / w[3];
    ends[i] = {w[0] * scale, w[1] * scale, w[2] * scale};
  }
  return ends;
}

std::array<double, 2> camera::to_pixel(const vec3& at) const {
  return to_pixels().apply(at);
}

camera::projection camera::to_pixels() const {
  return {matrix(), width_, height_};
}

double camera::metres_per_pixel() const {
  const auto now = get();
  const vec3 away = now.position - now.focus;
  const double slope = std::tan(camera_->GetViewAngle() * std::numbers::pi / 360);
  return 2 * (is_parallel() ? now.parallel_scale : slope * std::sqrt(dot(away, away))) / height_;
}

std::array<double, 2> camera::projection::apply(const vec3& at) const {
  const auto row = [&](std::size_t r) {
    const double* m = &matrix[4 * r];
    return m[0] * at.x + m[1] * at.y + m[2] * at.z + m[3];
  };
  const double w = row(3);
  return {(row(0) / w + 1) / 2 * width, (row(1) / w + 1) / 2 * height};
}

/// Around the box with some room; VTK fits the planes anew to what it draws.
void camera::adjust_depth() {
  const auto now = get();
  const vec3 ahead = unit_or_up(now.focus - now.position);
  double near = std::numeric_limits<double>::max();
  double far = std::numeric_limits<double>::lowest();
  for (int corner = 0; corner < 8; ++corner) {
    const vec3 p{box_[corner & 1], box_[2 + (corner >> 1 & 1)], box_[4 + (corner >> 2 & 1)]};
    const double depth = dot(p - now.position, ahead);
    near = std::min(near, depth);
    far = std::max(far, depth);
  }
  const double room = std::max(0.1 * (far - near), 1e-9);
  near -= room;
  far += room;
  if (!is_parallel()) {  // What lies behind the viewer is not seen.
    far = std::max(far, room);
    near = std::max(near, 1e-4 * far);
  }
  camera_->SetClippingRange(near, far);
}

}  // namespace tedit::desktop
