// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/tool_ghost.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tedit::desktop {

namespace {

using kind = handle::kind;
using outline = std::vector<std::array<double, 2>>;

constexpr int segments = 48;
constexpr double pi = std::numbers::pi;

void add_arc(outline& to, double x, double radius, double from, double turn, int count) {
  for (int i = 0; i < count; ++i) {
    const double angle = from + turn * i / count;
    to.push_back({x + radius * std::cos(angle), radius * std::sin(angle)});
  }
}

outline round(double radius, int corners = segments) {
  outline result;
  add_arc(result, 0, radius, 0, 2 * pi, corners);
  return result;
}

outline outline_of(const ops::parameters& values) {
  const auto profile = text_in(values, "profile");
  const auto [a, b] = profile_extents(values);
  if (profile == "rectangle")
    return {{-a, -b}, {a, -b}, {a, b}, {-a, b}};
  if (profile == "circle")
    return round(a);
  if (profile == "slot" && b <= a) {
    outline result;
    add_arc(result, a - b, b, -pi / 2, pi, segments / 2);
    add_arc(result, b - a, b, pi / 2, pi, segments / 2);
    return result;
  }
  const auto found = values.find("corners");
  const auto* corners = found == values.end() ? nullptr : std::get_if<std::int64_t>(&found->second);
  if (profile == "polygon" && corners)
    return round(a, static_cast<int>(std::clamp<std::int64_t>(*corners, 3, 64)));
  return {};
}

/// How far the part reaches below the place, m: what "through all there is" goes.
double depth_of_part(const handle_pose& pose) {
  double deepest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const vec3 p{pose.bounds[corner & 1], pose.bounds[2 + (corner >> 1 & 1)],
                 pose.bounds[4 + (corner >> 2 & 1)]};
    deepest = std::max(deepest, dot(pose.frame.at - p, pose.frame.z));
  }
  return deepest;
}

/// From the wall to where a length ends, along the outward direction, m.
std::optional<double> end_of(const handle* length, const ops::parameters& values,
                             const handle_pose& pose) {
  if (!length)
    return std::nullopt;
  const double value = number_in(values, length->parameter);
  if (value == 0 && length->first && length->inward && length->min == 0.0)
    return -depth_of_part(pose);
  return length->inward ? -value : value;
}

ghost_body body_of(const outline& shape, double to, const handle_pose& pose, bool has_edges) {
  ghost_body body{{}, {}, has_edges};
  for (const auto& [u, v] : shape) {
    body.bottom.push_back(pose.frame.point(u, v, 0));
    body.top.push_back(pose.frame.point(u, v, to));
  }
  return body;
}

ghost_body plane_body(const handle_plan& plan, const ops::parameters& values,
                      const handle_pose& pose) {
  const auto* offset = plan.find(kind::length);
  const double moved = offset ? end_of(offset, values, pose).value_or(0) : 0;
  const auto& b = pose.bounds;
  const vec3 middle{(b[0] + b[1]) / 2, (b[2] + b[3]) / 2, (b[4] + b[5]) / 2};
  const double reach = 0.6 * std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
  const auto& f = pose.frame;
  tool_frame on = f;
  on.at = middle - dot(middle - f.at, f.z) * f.z + moved * f.z;
  ghost_body body;
  for (const auto& [u, v] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
    body.bottom.push_back(on.point(reach * u, reach * v, 0));
  return body;
}

/// A counterbore: "counterbore_diameter" with "counterbore_depth".
void add_cylinders(const handle_plan& plan, const ops::parameters& values, const handle_pose& pose,
                   std::vector<ghost_body>& to) {
  constexpr std::string_view diameter = "diameter";
  for (const auto& ring : plan.all) {
    if (ring.what != kind::ring || !ring.parameter.ends_with(diameter))
      continue;
    const auto prefix = ring.parameter.substr(0, ring.parameter.size() - diameter.size());
    const auto* length = plan.find(prefix + "depth");
    if (!length)
      length = plan.find(prefix + "height");
    const double radius = ring.half * number_in(values, ring.parameter);
    const auto end = end_of(length, values, pose);
    if (radius > 0 && end && *end != 0)
      to.push_back(body_of(round(radius), *end, pose, false));
  }
}

}  // namespace

std::vector<ghost_body> ghost_of(const handle_plan& plan, const ops::parameters& values,
                                 const handle_pose& pose) {
  if (plan.is_plane)
    return {plane_body(plan, values, pose)};
  std::vector<ghost_body> result;
  if (!plan.find(kind::place))
    return result;
  if (plan.has_profile) {
    const auto shape = outline_of(values);
    const auto end = end_of(plan.find(kind::length), values, pose);
    const auto profile = text_in(values, "profile");
    if (!shape.empty() && end && *end != 0)
      result.push_back(body_of(shape, *end, pose, profile == "rectangle" || profile == "polygon"));
    return result;
  }
  add_cylinders(plan, values, pose, result);
  return result;
}

}  // namespace tedit::desktop
