// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/tools/hole.hpp"

#include <algorithm>
#include <cmath>

#include "base/metric_threads.hpp"

namespace tedit::ops {

namespace {

/// How deep the widened mouth reaches, m.
double mouth_of(const drill_shape& s) {
  if (s.counterbore_diameter > 0)
    return s.counterbore_depth;
  return s.countersink_diameter > 0
           ? 0.5 * (s.countersink_diameter - s.diameter) / std::tan(s.countersink_angle / 2)
           : 0;
}

expected<void> check(const drill_shape& s) {
  const auto wrong = [](const std::string& why, const std::string& remedy) {
    return fail(ec::invalid_parameter, why, remedy);
  };
  if (s.counterbore_diameter > 0 && s.countersink_diameter > 0)
    return wrong("a hole has a counterbore or a countersink, not both", "Set one of them to 0");
  if (s.counterbore_diameter > 0 && s.counterbore_diameter <= s.diameter)
    return wrong("the counterbore is no wider than the hole", "Make it wider, or 0");
  if (s.counterbore_diameter > 0 && s.counterbore_depth <= 0)
    return wrong("the counterbore has no depth", "Give counterbore_depth");
  if (s.countersink_diameter > 0 && s.countersink_diameter <= s.diameter)
    return wrong("the countersink is no wider than the hole", "Make it wider, or 0");
  if (s.depth > 0 && s.countersink_diameter > 0 && s.depth <= mouth_of(s))
    return wrong("the hole is no deeper than its countersink", "Make it deeper; 0 is through");
  if (s.tip_angle > 0 && s.tip_angle < 0.5)
    return wrong("a tip of less than 29 degrees is a needle", "Give 0 or a wider tip");
  if (s.depth > 0 && s.counterbore_diameter > 0 && s.depth <= s.counterbore_depth)
    return wrong("the hole is no deeper than its counterbore", "Make it deeper; 0 is through");
  return {};
}

/// Which way: into the material, as it points where that is on both sides or on none.
vec3 way_in(const mesh_version& mesh, const placement& where) {
  const vec3 step = 1e-3 * where.size * where.outward;
  const bool ahead = in_material(mesh, where.at + step);
  const bool behind = in_material(mesh, where.at - step);
  return ahead && !behind ? where.outward : -where.outward;
}

/// From the top, at `above` over the place, down.
std::vector<section_point> section_of(const drill_shape& s, double above, double depth) {
  const double r = s.diameter / 2;
  std::vector<section_point> section{{0, above, ""}};
  if (s.counterbore_diameter > 0) {
    const double wide = s.counterbore_diameter / 2;
    section.push_back({wide, above, "top"});
    section.push_back({wide, -s.counterbore_depth, "counterbore"});
    section.push_back({r, -s.counterbore_depth, "counterbore floor"});
  } else if (s.countersink_diameter > 0) {
    // The cone goes on above the place, where the wall may be higher.
    const double slope = std::tan(s.countersink_angle / 2);
    const double wide = s.countersink_diameter / 2;
    section.push_back({wide + above * slope, above, "top"});
    section.push_back({r, -(wide - r) / slope, "countersink"});
  } else {
    section.push_back({r, above, "top"});
  }
  section.push_back({r, -depth, "bore"});
  const double tip = s.tip_angle > 0 ? r / std::tan(s.tip_angle / 2) : 0;
  section.push_back({0, -depth - tip, "bore bottom"});
  return section;
}

}  // namespace

std::optional<double> thread_core(const std::string& thread) {
  return metric_thread_core(thread);
}

std::vector<std::string> threads() {
  std::vector<std::string> result{"none"};
  for (const auto& thread : metric_threads)
    result.emplace_back(thread.name);
  return result;
}

drill_shape drill_shape_from(const parameters& values) {
  const auto number = [&](const char* id) { return std::get<double>(values.at(id)); };
  drill_shape shape{number("diameter"),          number("depth"),
                    number("tip_angle"),         number("counterbore_diameter"),
                    number("counterbore_depth"), number("countersink_diameter"),
                    number("countersink_angle")};
  if (const auto core = thread_core(std::get<std::string>(values.at("thread"))))
    shape.diameter = *core;
  return shape;
}

expected<drilled_hole> drilled_hole_of(const mesh_version& mesh, const placement& where,
                                       const drill_shape& given) {
  if (auto ok = check(given); !ok)
    return fail(ok.error());
  auto shape = given;
  const bool through = shape.depth == 0;
  const vec3 in = way_in(mesh, where);
  const double depth =
    through ? std::max(depth_through(mesh, where.at, -in, shape.diameter / 2), mouth_of(shape)) +
                where.size
            : shape.depth;
  if (through)
    shape.tip_angle = 0;
  const double widest =
    std::max({shape.diameter, shape.counterbore_diameter, shape.countersink_diameter}) / 2;
  const double above = clearance(mesh, where.at, -in, widest) + 0.5 * where.size;
  return drilled_hole{make_frame(where.at, -in), section_of(shape, above, depth), above + depth};
}

}  // namespace tedit::ops
