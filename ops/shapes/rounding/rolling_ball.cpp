// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/rolling_ball.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tedit::ops {

namespace {

constexpr int newton_steps = 40;

struct equation {
  double value = 0;
  vec3 slope;
};

/// The point where three functions vanish, from `start`; it must stay within `reach` of it.
std::optional<vec3> solve(const std::function<std::array<equation, 3>(vec3)>& system, vec3 start,
                          double reach) {
  vec3 x = start;
  double last = 0;
  for (int step = 0; step < newton_steps; ++step) {
    const auto e = system(x);
    const vec3 c12 = cross(e[1].slope, e[2].slope);
    const double det = dot(e[0].slope, c12);
    if (!(std::abs(det) > 1e-6))
      return std::nullopt;
    const vec3 move = (e[0].value * c12 + e[1].value * cross(e[2].slope, e[0].slope) +
                       e[2].value * cross(e[0].slope, e[1].slope)) /
                      det;
    x = x - move;
    if (!is_finite(x) || norm(x - start) > reach)
      return std::nullopt;
    last = norm(move);
    if (last <= 1e-14 * reach)
      return x;
  }
  // What is left then is the rounding of the coordinates.
  return last <= 1e-9 * reach ? std::optional(x) : std::nullopt;
}

}  // namespace

vec3 rolling_ball::along(vec3 p) const {
  return normalized(cross(a_.normal(p), b_.normal(p)));
}

std::optional<vec3> rolling_ball::centre(vec3 p) const {
  const vec3 na = a_.normal(p);
  const vec3 nb = b_.normal(p);
  const vec3 t = along(p);
  const vec3 start = p + (side_ * radius_ / (1 + dot(na, nb))) * (na + nb);
  const double reach = 4 * norm(start - p) + radius_;
  const auto system = [&](vec3 c) {
    return std::array<equation, 3>{{{a_.distance(c) - side_ * radius_, a_.normal(c)},
                                    {b_.distance(c) - side_ * radius_, b_.normal(c)},
                                    {dot(t, c - p), t}}};
  };
  const auto found = solve(system, start, reach);
  // Beyond the axis of a cylinder the distance has another branch: the contacts tell.
  if (!found || dot(a_.normal(*found), na) < 0 || dot(b_.normal(*found), nb) < 0)
    return std::nullopt;
  return found;
}

std::optional<vec3> rolling_ball::centre_where(double share,
                                               const std::function<double(vec3)>& condition,
                                               vec3 start) const {
  return centre_at([&](vec3 c) { return condition(on_arc(c, share)); }, start, 10 * radius_);
}

/// The centre at which a function vanishes; its slope is taken by differences.
std::optional<vec3> rolling_ball::centre_at(const std::function<double(vec3)>& value, vec3 start,
                                            double reach) const {
  const double step = 1e-6 * radius_;
  const auto system = [&](vec3 c) {
    const auto slope = [&](vec3 d) { return (value(c + d) - value(c - d)) / (2 * step); };
    return std::array<equation, 3>{
      {{a_.distance(c) - side_ * radius_, a_.normal(c)},
       {b_.distance(c) - side_ * radius_, b_.normal(c)},
       {value(c), {slope({step, 0, 0}), slope({0, step, 0}), slope({0, 0, step})}}}};
  };
  return solve(system, start, reach);
}

double rolling_ball::arc(vec3 centre) const {
  const vec3 ea = a_.normal(centre);
  const vec3 eb = b_.normal(centre);
  return std::atan2(norm(cross(ea, eb)), dot(ea, eb));
}

vec3 rolling_ball::on_arc(vec3 centre, double share) const {
  const vec3 ea = -side_ * a_.normal(centre);
  const vec3 eb = -side_ * b_.normal(centre);
  const double angle = arc(centre);
  return centre + (radius_ / std::sin(angle)) *
                    (std::sin((1 - share) * angle) * ea + std::sin(share * angle) * eb);
}

std::optional<double> rolling_ball::distance(vec3 p, vec3 start) const {
  const auto c = centre_at([&](vec3 at) { return dot(along(at), at - p); }, start,
                           10 * radius_ + 2 * norm(p - start));
  if (!c)
    return std::nullopt;
  return norm(p - *c) - radius_;
}

std::optional<vec3> ball_in_corner(const exact_wall& a, const exact_wall& b, const exact_wall& c,
                                   double radius, double side, vec3 p) {
  const auto system = [&](vec3 x) {
    return std::array<equation, 3>{{{a.distance(x) - side * radius, a.normal(x)},
                                    {b.distance(x) - side * radius, b.normal(x)},
                                    {c.distance(x) - side * radius, c.normal(x)}}};
  };
  return solve(system, p, 20 * radius);
}

}  // namespace tedit::ops
