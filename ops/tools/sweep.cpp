// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/tools/sweep.hpp"

#include <algorithm>
#include <cmath>

#include "ops/tools/extruder.hpp"

namespace tedit::ops {

namespace {

/// Cosine of half the sharpest turn: 150 degrees.
constexpr double sharpest_corner = 0.2588;

/// One straight part of the path.
struct leg {
  vec3 from;
  vec3 to;
  frame across;  ///< z goes along it.

  [[nodiscard]] double length() const { return norm(to - from); }
};

/// Turned by the least that takes its z to another direction (unit).
frame turned_to(const frame& f, vec3 origin, vec3 z) {
  const vec3 axis = cross(f.z, z);
  const double c = dot(f.z, z);
  const auto turn = [&](vec3 v) {
    return c * v + cross(axis, v) + dot(axis, v) / (1 + c) * axis;  // Rodrigues' formula.
  };
  const vec3 x = normalized(turn(f.x) - dot(turn(f.x), z) * z);
  return {origin, x, cross(z, x), z};
}

tl::unexpected<error> wrong_corner(std::size_t point, const std::string& why,
                                   const std::string& remedy) {
  return fail(ec::invalid_parameter,
              "at its point " + std::to_string(point + 1) + " the path " + why, remedy);
}

expected<std::vector<leg>> legs_of(const std::vector<vec3>& path, vec3 up) {
  std::vector<leg> legs;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const vec3 way = path[i + 1] - path[i];
    if (norm(way) == 0)
      return wrong_corner(i + 1, "stands still", "Give each point once");
    const vec3 z = normalized(way);
    if (i > 0 && norm(legs.back().across.z + z) / 2 < sharpest_corner)
      return wrong_corner(i, "turns back", "Let it turn by less than 150 degrees at a point");
    legs.push_back(
      {path[i], path[i + 1],
       i == 0 ? make_frame(path[i], z, up) : turned_to(legs.back().across, path[i], z)});
  }
  return legs;
}

/// By how much the frame is turned about the path once round, rad.
double turned_round(const std::vector<leg>& legs) {
  const auto& first = legs.front().across;
  const frame back = turned_to(legs.back().across, first.origin, first.z);
  return std::atan2(dot(cross(first.x, back.x), first.z), dot(first.x, back.x));
}

/// Takes that back, shared out by length, so that the last fits the first.
void share_out(std::vector<leg>& legs, double angle) {
  double length = 0;
  for (const auto& one : legs)
    length += one.length();
  double gone = 0;
  for (auto& one : legs) {
    const double turn = -angle * gone / length;
    const auto [x, y] = std::pair{one.across.x, one.across.y};
    one.across.x = std::cos(turn) * x + std::sin(turn) * y;
    one.across.y = cross(one.across.z, one.across.x);
    gone += one.length();
  }
}

/// A point of the profile on the plane that halves the corner before a leg, or across its end.
vec3 mitred(const leg& on, vec3 corner, vec3 normal, const std::array<double, 2>& p) {
  const vec3 off = p[0] * on.across.x + p[1] * on.across.y;
  return corner + off - dot(off, normal) / dot(on.across.z, normal) * on.across.z;
}

/// Where the outlines' points are at each point of the path.
class rings {
public:
  rings(const std::vector<leg>& legs, bool closed, std::vector<std::array<double, 2>> points)
      : legs_(legs), closed_(closed), points_(std::move(points)) {}

  /// At the beginning of a leg, or at the end of the last of an open path.
  [[nodiscard]] std::vector<vec3> at(std::size_t i) const {
    const std::size_t n = legs_.size();
    const auto& on = legs_[i < n ? i : closed_ ? 0 : n - 1];
    const vec3 corner = i < n || closed_ ? on.from : on.to;
    const bool inner = closed_ || (i > 0 && i < n);
    const auto& before = legs_[(i + n - 1) % n];
    const vec3 normal = inner ? normalized(before.across.z + on.across.z) : on.across.z;
    std::vector<vec3> result;
    for (const auto& p : points_)
      result.push_back(mitred(on, corner, normal, p));
    return result;
  }

private:
  const std::vector<leg>& legs_;
  bool closed_;
  std::vector<std::array<double, 2>> points_;
};

/// Layers along one leg, without the last.
expected<int> add_leg(const rings& all, const std::vector<leg>& legs, std::size_t i, double size,
                      tool_surface& tool) {
  const auto from = all.at(i);
  const auto to = all.at(i + 1);
  for (std::size_t k = 0; k < from.size(); ++k)
    if (dot(to[k] - from[k], legs[i].across.z) <= 1e-6 * legs[i].length())
      return fail(ec::invalid_parameter,
                  "between its points " + std::to_string(i + 1) + " and " + std::to_string(i + 2) +
                    " the path bends too narrowly for what is carried along it",
                  "Make the profile smaller, or the bend wider");
  const int layers = parts_of(legs[i].length(), size);
  for (int layer = 0; layer < layers; ++layer)
    for (std::size_t k = 0; k < from.size(); ++k)
      tool.points.push_back(from[k] + static_cast<double>(layer) / layers * (to[k] - from[k]));
  return layers;
}

std::vector<std::array<double, 2>> all_points(const std::vector<outline>& outlines) {
  std::vector<std::array<double, 2>> points;
  for (const auto& o : outlines)
    points.insert(points.end(), o.points.begin(), o.points.end());
  return points;
}

}  // namespace

expected<tool_surface> sweep(const std::vector<vec3>& path, const profile& what, vec3 up,
                             double size, const std::string& name, services& host) {
  if (path.size() < 2)
    return fail(ec::invalid_parameter, "a path has two points or more", "Give its points");
  auto legs = legs_of(path, up);
  if (!legs)
    return fail(legs.error());
  const bool closed = path.size() > 3 && path.front() == path.back();
  if (closed && norm(legs->back().across.z + legs->front().across.z) / 2 < sharpest_corner)
    return wrong_corner(0, "turns back", "Let it turn by less than 150 degrees at a point");
  if (closed)
    share_out(*legs, turned_round(*legs));
  const auto outlines = divided_outlines(what, size);
  const auto filling = fill_outlines(outlines, size, host);
  if (!filling)
    return fail(filling.error());
  const auto points = all_points(outlines);
  const auto rim = static_cast<std::uint32_t>(points.size());
  const rings all(*legs, closed, points);
  extruder made;
  int layers = 0;
  for (std::size_t i = 0; i < legs->size(); ++i) {
    const auto added = add_leg(all, *legs, i, size, made.tool);
    if (!added)
      return fail(added.error());
    layers += *added;
  }
  if (!closed)
    for (const auto& p : all.at(legs->size()))
      made.tool.points.push_back(p);
  made.add_walls(outlines, rim, layers, closed);
  const auto on = [](const leg& one, vec3 at) {
    return [&one, at](const std::array<double, 2>& p) {
      return at + p[0] * one.across.x + p[1] * one.across.y;
    };
  };
  if (!closed)
    made.add_ends(*filling, rim, layers, on(legs->front(), path.front()),
                  on(legs->back(), path.back()));
  made.tool.names = {name + " start", name + " end"};
  for (const auto& side : what.sides)
    made.tool.names.push_back(name + " " + side);
  return std::move(made.tool);
}

}  // namespace tedit::ops
