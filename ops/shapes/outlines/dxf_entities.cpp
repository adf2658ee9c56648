// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/outlines/dxf_entities.hpp"

#include <algorithm>
#include <numbers>

namespace tedit::ops {

namespace {

constexpr double whole_turn = 2 * std::numbers::pi;
constexpr double degrees = std::numbers::pi / 180;
constexpr int most_degree = 25;

std::string place_in_file(const dxf_item& item) {
  return "line " + std::to_string(item.line);
}

tl::unexpected<error> no_curve(const dxf_item& item, const std::string& why) {
  return fail(ec::bad_input, "a " + std::string(item.kind) + " of the drawing " + why,
              "Draw it again, or put it on a layer that is frozen or off", place_in_file(item));
}

point2 point_at(dxf_values& values, int code) {
  return {values.number(code, 0), values.number(code + 10, 0)};
}

/// From angle to angle counter-clockwise, a whole turn where they are the same.
arc_curve arc_from(point2 centre, point2 u, point2 v, double from, double to) {
  double turn = std::fmod(to - from, whole_turn);
  if (turn <= 1e-9)
    turn += whole_turn;
  from = std::fmod(from, whole_turn);
  return {centre, u, v, from, from + turn};
}

/// Of a polyline's edge: the tangent of a quarter of the arc's angle, positive counter-clockwise.
plane_curve bulged(point2 from, point2 to, double bulge) {
  if (std::abs(bulge) < 1e-9)
    return line_curve{from, to};
  const double away = (1 - bulge * bulge) / (4 * bulge);
  const point2 centre{0.5 * (from[0] + to[0]) - away * (to[1] - from[1]),
                      0.5 * (from[1] + to[1]) + away * (to[0] - from[0])};
  const double radius = gap_of(from, centre);
  const double first = std::atan2(from[1] - centre[1], from[0] - centre[0]);
  return arc_curve{centre, {radius, 0}, {0, radius}, first, first + 4 * std::atan(bulge)};
}

struct polyline_corner {
  point2 at{};
  double bulge = 0;
};

void join_corners(const std::vector<polyline_corner>& corners, plane_path& path) {
  const std::size_t edges = corners.size() - (path.closed || corners.empty() ? 0 : 1);
  for (std::size_t i = 0; i < edges; ++i) {
    const auto& from = corners[i];
    const auto& to = corners[(i + 1) % corners.size()];
    if (from.at != to.at)
      path.curves.push_back(bulged(from.at, to.at, from.bulge));
  }
}

void read_light_polyline(const dxf_item& item, dxf_values& values, plane_path& path) {
  path.closed = (values.whole(70, 0) & 1) != 0;
  std::vector<polyline_corner> corners;
  for (const auto& group : item.groups) {
    if (group.code == 10)
      corners.push_back({{values.number_in(group), 0}, 0});
    else if (group.code == 20 && !corners.empty())
      corners.back().at[1] = values.number_in(group);
    else if (group.code == 42 && !corners.empty())
      corners.back().bulge = std::clamp(values.number_in(group), -1e6, 1e6);
  }
  join_corners(corners, path);
}

expected<void> read_polyline(const dxf_item& item, std::span<const dxf_item> vertices,
                             dxf_values& values, plane_path& path) {
  constexpr int surface = 16 | 64;
  constexpr int frame_of_spline = 16;
  const int flags = values.whole(70, 0);
  if ((flags & surface) != 0)
    return no_curve(item, "is a surface");
  path.closed = (flags & 1) != 0;
  std::vector<polyline_corner> corners;
  for (const auto& vertex : vertices) {
    dxf_values of_vertex(vertex);
    if ((of_vertex.whole(70, 0) & frame_of_spline) == 0)
      corners.push_back({point_at(of_vertex, 10), std::clamp(of_vertex.number(42, 0), -1e6, 1e6)});
    if (of_vertex.fault())
      return fail(*of_vertex.fault());
  }
  join_corners(corners, path);
  return {};
}

expected<void> read_ellipse(const dxf_item& item, dxf_values& values, plane_path& path) {
  const point2 u = point_at(values, 11);
  const double ratio = values.number(40, 1);
  if (!(gap_of(u, {}) > 0) || !(std::abs(ratio) > 1e-6) || !(std::abs(ratio) <= 1e3))
    return no_curve(item, "has no width");
  // Its minor axis lies a quarter of a turn ahead, seen from where its axis comes.
  const double side = values.number(230, 1) < 0 ? -ratio : ratio;
  const point2 v{-side * u[1], side * u[0]};
  path.curves.push_back(
    arc_from(point_at(values, 10), u, v, values.number(41, 0), values.number(42, whole_turn)));
  return {};
}

/// Errors: where it is none, for how it is written.
expected<void> check_spline(const dxf_item& item, const spline_curve& s) {
  const auto degree = static_cast<std::size_t>(s.degree);
  if (s.poles.empty())
    return fail(ec::bad_input, "a SPLINE of the drawing has no control points",
                "Convert it to a polyline", place_in_file(item));
  if (s.degree < 1 || s.degree > most_degree || s.poles.size() <= degree ||
      s.knots.size() != s.poles.size() + degree + 1)
    return no_curve(item, "has " + std::to_string(s.knots.size()) + " knots for " +
                            std::to_string(s.poles.size()) + " control points and degree " +
                            std::to_string(s.degree));
  // A knot that is there oftener than the degree says would tear the curve.
  bool torn = !(s.knots[degree] < s.knots[s.poles.size()]);
  for (std::size_t i = 1; i + degree + 1 < s.knots.size(); ++i)
    torn = torn || !(s.knots[i] < s.knots[i + degree]);
  if (torn || !std::ranges::is_sorted(s.knots))
    return no_curve(item, "has knots in no order");
  return {};
}

expected<void> read_spline(const dxf_item& item, dxf_values& values, plane_path& path) {
  spline_curve spline;
  spline.degree = values.whole(71, 3);
  std::size_t weights = 0;
  for (const auto& group : item.groups) {
    if (group.code == 40)
      spline.knots.push_back(values.number_in(group));
    else if (group.code == 10)
      spline.poles.push_back({values.number_in(group), 0, 1});
    else if (group.code == 20 && !spline.poles.empty())
      spline.poles.back()[1] = values.number_in(group);
    else if (group.code == 41)
      ++weights;
  }
  if (auto ok = check_spline(item, spline); !ok)
    return ok;
  if (weights != 0 && weights != spline.poles.size())
    return no_curve(item, "has not one weight for each control point");
  std::size_t next = 0;
  for (const auto& group : item.groups)
    if (group.code == 41) {
      const double w = values.number_in(group);
      if (!(w >= 1e-6) || !(w <= 1e6))
        return no_curve(item, "has weights that make no curve");
      auto& pole = spline.poles[next++];
      pole = {pole[0] * w, pole[1] * w, w};
    }
  path.curves.push_back(std::move(spline));
  return {};
}

expected<void> read_round(const dxf_item& item, dxf_values& values, plane_path& path) {
  const double radius = values.number(40, 0);
  if (!(radius > 0))
    return no_curve(item, "has no radius");
  const bool part = item.kind == "ARC";
  path.curves.push_back(arc_from(point_at(values, 10), {radius, 0}, {0, radius},
                                 part ? degrees * values.number(50, 0) : 0,
                                 part ? degrees * values.number(51, 360) : whole_turn));
  return {};
}

expected<void> read_curves(const dxf_item& item, std::span<const dxf_item> more, dxf_values& values,
                           plane_path& path) {
  if (item.kind == "LINE") {
    const line_curve line{point_at(values, 10), point_at(values, 11)};
    if (line.from != line.to)
      path.curves.push_back(line);
    return {};
  }
  if (item.kind == "LWPOLYLINE") {
    read_light_polyline(item, values, path);
    return {};
  }
  if (item.kind == "POLYLINE")
    return read_polyline(item, more, values, path);
  if (item.kind == "ELLIPSE")
    return read_ellipse(item, values, path);
  if (item.kind == "SPLINE")
    return read_spline(item, values, path);
  return read_round(item, values, path);
}

}  // namespace

bool is_outline_entity(std::string_view kind) {
  return kind == "LINE" || kind == "LWPOLYLINE" || kind == "POLYLINE" || kind == "CIRCLE" ||
         kind == "ARC" || kind == "ELLIPSE" || kind == "SPLINE";
}

expected<affine> axes_of_entity(const dxf_item& item) {
  dxf_values values(item);
  const point2 across{values.number(210, 0), values.number(220, 0)};
  const double up = values.number(230, 1);
  if (values.fault())
    return fail(*values.fault());
  if (gap_of(across, {}) > 1e-6 * std::abs(up))
    return no_curve(item, "does not lie in the plane of the drawing");
  return up < 0 ? affine{-1, 0, 0, 1, 0, 0} : affine{};
}

expected<plane_path> path_of_entity(const dxf_item& item, std::span<const dxf_item> more) {
  dxf_values values(item);
  plane_path path;
  path.line = item.line;
  if (auto ok = read_curves(item, more, values, path); !ok)
    return fail(ok.error());
  if (values.fault())
    return fail(*values.fault());
  // By points in the drawing's axes, whatever it says of its own.
  if (item.kind == "LINE" || item.kind == "SPLINE")
    return path;
  const auto axes = axes_of_entity(item);
  if (!axes)
    return fail(axes.error());
  if (item.kind != "ELLIPSE")
    for (auto& curve : path.curves)
      curve = moved(curve, *axes);
  return path;
}

}  // namespace tedit::ops
