// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/handle_drag.hpp"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace tedit::desktop {

namespace {

using kind = handle::kind;

struct handle_drag_phrases {
  Q_DECLARE_TR_FUNCTIONS(handles)
};

constexpr double lock_angle = 0.105;  // 6 degrees.
constexpr double lock_pixels = 8;
constexpr double finest = 1e-6;  // m, and of a direction's numbers.

double rounded(double value, double step) {
  return step * std::round(value / step);
}

double within(const handle& one, double value) {
  return std::clamp(value, one.min.value_or(-INFINITY),
                    std::max(one.max.value_or(INFINITY), one.min.value_or(-INFINITY)));
}

constexpr std::array<vec3, 6> part_axes{vec3{1, 0, 0},  vec3{-1, 0, 0}, vec3{0, 1, 0},
                                        vec3{0, -1, 0}, vec3{0, 0, 1},  vec3{0, 0, -1}};

QString axis_words(std::size_t number) {
  static const std::array names{"x", "y", "z"};
  return handle_drag_phrases::tr("along %1").arg(names[number / 2]);
}

/// The number of the part's axis that a direction is within 6 degrees of.
std::optional<std::size_t> axis_near(const vec3& direction) {
  for (std::size_t i = 0; i < part_axes.size(); ++i)
    if (dot(direction, part_axes[i]) > std::cos(lock_angle))
      return i;
  return std::nullopt;
}

/// How far the pointer has moved the end of an arrow along it, m. Where the arrow looks at the
/// viewer, up is more.
double moved_along(const handle_drag& d, QPointF to) {
  const auto before = along_axis(d.by.ray(d.pressed), d.from.root, d.from.along);
  const auto now = along_axis(d.by.ray(to), d.from.root, d.from.along);
  if (before && now)
    return *now - *before;
  return (d.pressed.y() - to.y()) * d.by.metres_per_pixel(d.from.root);
}

/// The same of a ring: by how far the pointer is from its middle.
double moved_outward(const handle_drag& d, QPointF to) {
  const vec3& z = d.pose.frame.z;
  const auto before = on_plane(d.by.ray(d.pressed), d.from.root, z);
  const auto now = on_plane(d.by.ray(to), d.from.root, z);
  if (before && now)
    return norm(*now - d.from.root) - norm(*before - d.from.root);
  return moved_along(d, to);
}

dragged_value drag_number(const handle_drag& d, QPointF to, bool free) {
  const auto& one = *d.from.of;
  const bool is_round = one.what == kind::ring || d.from.line.size() > 2;
  const double moved = is_round ? moved_outward(d, to) : moved_along(d, to);
  const double step = drag_step(d.by.metres_per_pixel(d.from.root) / one.half);
  const double value = d.from.value + moved / one.half;
  return {within(one, free ? rounded(value, finest) : rounded(value, step)), {}};
}

dragged_value drag_direction(const handle_drag& d, QPointF to, bool free) {
  const vec3 knob = d.from.root + d.from.radius * d.from.along;
  const auto pressed = d.by.ray(d.pressed);
  // A knob behind the place stays behind it.
  const vec3 ahead = normalized(pressed[1] - pressed[0]);
  const bool near = dot(knob - d.from.root, ahead) <= 0;
  const vec3 direction =
    normalized(on_sphere(d.by.ray(to), d.from.root, d.from.radius, near) - d.from.root);
  if (free)
    return {vector_text(direction, finest), {}};
  if (dot(direction, d.pose.wall_normal) > std::cos(lock_angle))
    return {std::string(), handle_drag_phrases::tr("across the wall")};
  if (const auto axis = axis_near(direction))
    return {vector_text(part_axes[*axis], finest), axis_words(*axis)};
  return {vector_text(direction, 1e-3), {}};
}

dragged_value drag_turn(const handle_drag& d, QPointF to, bool free) {
  const vec3& z = d.pose.frame.z;
  auto at = on_plane(d.by.ray(to), d.from.root, z);
  if (!at)
    at = on_sphere(d.by.ray(to), d.from.root, d.from.radius, true);
  const vec3 way = *at - d.from.root;
  const vec3 direction = normalized(way - dot(way, z) * z);
  if (norm(direction) < 0.5)
    return {vector_text(d.from.along, finest), {}};
  if (free)
    return {vector_text(direction, finest), {}};
  // An axis as it lies in the wall.
  for (std::size_t i = 0; i < part_axes.size(); ++i) {
    const vec3 flat = part_axes[i] - dot(part_axes[i], z) * z;
    if (norm(flat) > 0.3 && dot(direction, normalized(flat)) > std::cos(lock_angle))
      return {vector_text(normalized(flat), finest), axis_words(i)};
  }
  return {vector_text(direction, 1e-3), {}};
}

dragged_value drag_way(const handle_drag& d, QPointF to, bool free) {
  const vec3 end = d.from.root + d.from.along;
  vec3 across = cross(d.by.up, d.by.right);  // In the plane of the screen,
  if (d.pose.axis && on_plane(d.by.ray(d.pressed), end, *d.pose.axis))
    across = *d.pose.axis;  // or over the wall that a bore is in.
  const auto before = on_plane(d.by.ray(d.pressed), end, across);
  const auto now = on_plane(d.by.ray(to), end, across);
  if (!before || !now)
    return {vector_text(d.from.along, finest), {}};
  const vec3 way = d.from.along + (*now - *before);
  if (free)
    return {vector_text(way, finest), {}};
  const double pixel = d.by.metres_per_pixel(end);
  const double step = drag_step(pixel);
  for (std::size_t i = 0; i < part_axes.size(); i += 2) {
    // The arrow's end beside the axis on the screen, and the axis is to be seen at all.
    const auto on_axis =
      along_axis(d.by.ray(to - d.pressed + d.by.to_screen(end)), d.from.root, part_axes[i]);
    if (!on_axis)
      continue;
    const vec3 there = *on_axis * part_axes[i];
    const QPointF beside = d.by.to_screen(d.from.root + there);
    if (std::abs(*on_axis) > pixel &&
        pixels_between(beside, d.by.to_screen(d.from.root + way)) < lock_pixels)
      return {vector_text(rounded(*on_axis, step) * part_axes[i], step), axis_words(i)};
  }
  return {vector_text(way, step), {}};
}

}  // namespace

std::string vector_text(const vec3& v, double step) {
  QStringList numbers;
  for (const double x : {v.x, v.y, v.z})
    numbers << QString::number(rounded(x, step) + 0.0, 'g', 12);
  return numbers.join(", ").toStdString();
}

dragged_value drag_to(const handle_drag& drag, QPointF pointer, bool free) {
  switch (drag.from.of->what) {
    case kind::direction:
      return drag_direction(drag, pointer, free);
    case kind::turn:
      return drag_turn(drag, pointer, free);
    case kind::way:
      return drag_way(drag, pointer, free);
    default:
      return drag_number(drag, pointer, free);
  }
}

}  // namespace tedit::desktop
