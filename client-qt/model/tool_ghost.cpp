// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/tool_ghost.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/metric_threads.hpp"

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

/// A line of text about as long as its letters are, in a font of usual width: which font it will be
/// the server knows. Nothing where a file stands in for it.
outline text_box(const ops::parameters& values) {
  constexpr double advance = 0.86;  // Of a letter, as a share of the height of capitals.
  const double size = number_in(values, "size");
  const auto letters = QString::fromStdString(text_in(values, "text")).trimmed().size();
  if (letters == 0 || !text_in(values, "file").empty())
    return {};
  const double along = advance * size * static_cast<double>(letters) / 2;
  return {{-along, -size / 2}, {along, -size / 2}, {along, size / 2}, {-along, size / 2}};
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

/// What one diameter of a tool that turns about its axis takes: from the wall to `end`, m, against
/// or along the outward direction.
struct turned {
  double radius = 0;   ///< m, at the wall;
  double narrows = 0;  ///< m less of it a metre.
  double end = 0;

  [[nodiscard]] double radius_at(double z) const { return radius - narrows * std::abs(z); }
};

/// Of a diameter; the core of a thread stands in for the first.
double radius_in(const handle_plan& plan, const handle& ring, const ops::parameters& values) {
  const bool is_core = !plan.thread.empty() && plan.find(kind::ring) == &ring;
  const auto core = is_core ? metric_thread_core(text_in(values, plan.thread)) : std::nullopt;
  return ring.half * core.value_or(number_in(values, ring.parameter));
}

/// "hole_" of "hole_diameter".
std::string before_diameter(const std::string& id) {
  constexpr std::string_view diameter = "diameter";
  return id.substr(0, id.size() - diameter.size());
}

bool is_diameter(const handle& one) {
  return one.what == kind::ring && one.parameter.ends_with("diameter");
}

/// A cylinder: "counterbore_diameter" with "counterbore_depth".
std::optional<turned> cylinder_of(const handle_plan& plan, const handle& ring,
                                  const ops::parameters& values, const handle_pose& pose) {
  const auto prefix = before_diameter(ring.parameter);
  const auto* length = plan.find(prefix + "depth");
  if (!length)
    length = plan.find(prefix + "height");
  const double radius = radius_in(plan, ring, values);
  const auto end = end_of(length, values, pose);
  if (!(radius > 0) || !end || *end == 0)
    return std::nullopt;
  return turned{radius, 0, *end};
}

/// A cone: "countersink_diameter" with "countersink_angle", down to the bore.
std::optional<turned> cone_of(const handle_plan& plan, const handle& ring, double bore,
                              const ops::parameters& values) {
  const auto id = before_diameter(ring.parameter) + "angle";
  const double radius = radius_in(plan, ring, values);
  const double narrows = std::tan(number_in(values, id) / 2);
  if (std::ranges::find(plan.angles, id) == plan.angles.end() || !(radius > bore) || !(narrows > 0))
    return std::nullopt;
  return turned{radius, narrows, (bore - radius) / narrows};
}

/// Does the other take all of it?
bool is_within(const turned& one, const turned& other) {
  return std::abs(other.end) > std::abs(one.end) && other.radius >= one.radius &&
         other.radius_at(one.end) >= one.radius_at(one.end);
}

/// One below the other, by where they end: what ends first is the widest there.
void stack(std::vector<turned> parts, const handle_pose& pose, std::vector<ghost_body>& to) {
  std::ranges::sort(parts, {}, [](const turned& t) { return std::abs(t.end); });
  double begins = 0;
  for (const auto& part : parts) {
    if (std::abs(part.end) <= std::abs(begins) ||
        std::ranges::any_of(parts, [&](const auto& other) { return is_within(part, other); }))
      continue;
    ghost_body body;
    for (const auto& [u, v] : round(1)) {
      const double wide = part.radius_at(begins);
      const double narrow = part.radius_at(part.end);
      body.bottom.push_back(pose.frame.point(wide * u, wide * v, begins));
      body.top.push_back(pose.frame.point(narrow * u, narrow * v, part.end));
    }
    to.push_back(std::move(body));
    begins = part.end;
  }
}

/// All that turns about the tool's axis.
void add_turned(const handle_plan& plan, const ops::parameters& values, const handle_pose& pose,
                std::vector<ghost_body>& to) {
  std::array<std::vector<turned>, 2> sides;  // Outward and inward.
  std::optional<turned> bore;
  for (const auto& ring : plan.all)
    if (is_diameter(ring))
      if (const auto part = cylinder_of(plan, ring, values, pose)) {
        sides[part->end < 0].push_back(*part);
        if (part->end < 0 && (!bore || part->end < bore->end))
          bore = part;
      }
  for (const auto& ring : plan.all)
    if (is_diameter(ring) && bore)
      if (const auto cone = cone_of(plan, ring, bore->radius, values))
        sides[1].push_back(*cone);
  for (auto& parts : sides)
    stack(std::move(parts), pose, to);
  const auto* depth = plan.find(kind::length);
  const auto tip_id =
    std::ranges::find_if(plan.angles, [](const auto& id) { return id.ends_with("tip_angle"); });
  const double tip = tip_id == plan.angles.end() ? 0 : number_in(values, *tip_id);
  if (!bore || !depth || !(tip > 0) || number_in(values, depth->parameter) == 0)
    return;
  auto end = body_of(round(bore->radius), bore->end, pose, false);
  end.bottom = std::move(end.top);
  end.top = {pose.frame.point(0, 0, bore->end - bore->radius / std::tan(tip / 2))};
  to.push_back(std::move(end));
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
  if (plan.has_text) {
    const auto shape = text_box(values);
    const auto end = end_of(plan.find(kind::length), values, pose);
    if (!shape.empty() && end && *end != 0)
      result.push_back(body_of(shape, *end, pose, true));
    return result;
  }
  add_turned(plan, values, pose, result);
  return result;
}

}  // namespace tedit::desktop
