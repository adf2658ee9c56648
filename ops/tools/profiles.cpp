// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/tools/profiles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tedit::ops {

namespace {

double number(const parameters& values, const char* id) {
  return std::get<double>(values.at(id));
}

double width_of(const parameters& values) {
  const double width = number(values, "width");
  return width > 0 ? width : number(values, "size");
}

}  // namespace

expected<profile> profile_from(const parameters& values, double size) {
  const auto& kind = std::get<std::string>(values.at("profile"));
  const double length = number(values, "size");
  if (kind == "circle")
    return circle(length, std::max(24, segments_of(length, size)));
  if (kind == "rectangle")
    return rectangle(length, width_of(values));
  if (kind == "slot") {
    const double width = number(values, "width") > 0 ? number(values, "width") : length / 2;
    if (width >= length)
      return fail(ec::invalid_parameter, "the slot is wider than long",
                  "Give a width below its size");
    return slot(length, width, std::max(24, segments_of(width, size)));
  }
  const auto corners = std::get<std::int64_t>(values.at("corners"));
  std::vector<std::array<double, 2>> points;
  for (std::int64_t i = 0; i < corners; ++i) {
    const double angle =
      2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    points.push_back({length / 2 * std::cos(angle), length / 2 * std::sin(angle)});
  }
  return polygon(points);
}

double radius_of(const profile& p) {
  double most = 0;
  for (const auto& o : p.outlines)
    for (const auto& q : o.points)
      most = std::max(most, std::hypot(q[0], q[1]));
  return most;
}

frame profile_frame(const placement& where, const parameters& values) {
  frame f = make_frame(where.at, where.outward);
  if (const auto along = vector_of(values, "along")) {
    const vec3 x = *along - dot(*along, f.z) * f.z;
    if (norm(x) > 1e-6 * norm(*along)) {
      f.x = normalized(x);
      f.y = cross(f.z, f.x);
    }
  }
  return f;
}

namespace {

/// What the shape itself asks for.
double size_for_shape(const placement& where, const parameters& values) {
  const auto& kind = std::get<std::string>(values.at("profile"));
  const double length = number(values, "size");
  if (kind == "circle")
    return std::min(where.size, 1.5 * std::numbers::pi * length / 24);
  if (kind == "slot") {
    const double width = number(values, "width") > 0 ? number(values, "width") : length / 2;
    return std::min(where.size, 1.5 * std::numbers::pi * width / 24);
  }
  if (kind == "rectangle")
    return std::min({where.size, length / 2, width_of(values) / 2});
  return std::min(where.size, length / (kind == "polygon" ? 4 : 24));
}

}  // namespace

double profile_size(const placement& where, const parameters& values) {
  // What reaches far beyond the part needs no triangles like the part's there.
  return std::max(size_for_shape(where, values), number(values, "size") / 60);
}

tool_span pocket_span(const mesh_version& mesh, const placement& where, double depth,
                      double radius) {
  const double deep =
    depth > 0 ? depth : depth_through(mesh, where.at, where.outward, radius) + where.size;
  return {-deep, clearance(mesh, where.at, where.outward, radius) + 0.5 * where.size};
}

tool_span boss_span(const mesh_version& mesh, const placement& where, double height,
                    double radius) {
  const vec3 over = where.at + 1e-4 * where.size * where.outward;
  const double gap = gap_below(mesh, over, where.outward, radius);
  return {gap > 1e-3 * where.size ? -gap - 0.2 * where.size : 0, height};
}

}  // namespace tedit::ops
