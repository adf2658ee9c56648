// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/combine/combine.hpp"

#include <cmath>

#include "base/number_range.hpp"
#include "ops/tools/placement.hpp"

namespace tedit::ops {

namespace {

/// The file's axes where they come to lie: unturned where its z axis stays.
frame frame_of(const combine_settings& s) {
  const vec3 z = normalized(s.direction);
  // Across the shortest way from the z axis to z.
  const vec3 axis = cross({0, 0, 1}, z);
  frame f{s.at, {1, 0, 0}, {0, 1, 0}, z};
  if (const double sine = norm(axis); sine > 1e-12) {
    const vec3 a = axis / sine;
    const auto turned = [&](vec3 v) {
      return z.z * v + sine * cross(a, v) + (1 - z.z) * dot(a, v) * a;
    };
    f.x = turned({1, 0, 0});
    f.y = turned({0, 1, 0});
  } else if (z.z < 0) {
    f.y = {0, -1, 0};
  }
  const vec3 x = std::cos(s.turn) * f.x + std::sin(s.turn) * f.y;
  f.y = cross(z, x);
  f.x = x;
  return f;
}

/// "12 x 30 x 5 mm".
std::string size_text(const box& b) {
  const vec3 d = 1e3 * (b.high - b.low);
  return number_text(d.x) + " x " + number_text(d.y) + " x " + number_text(d.z) + " mm";
}

}  // namespace

expected<edit_result> combine(const version_ptr& mesh, tool_surface surface,
                              const combine_settings& settings,
                              const std::vector<surface_id>& picked, context& ctx) {
  const auto place = frame_of(settings);
  const double scale = settings.unit * settings.scale;
  for (auto& p : surface.points)
    p = place.at(scale * p.x, scale * p.y, scale * p.z);
  const double size = local_size(*mesh, surface);
  auto result = apply_tool(mesh, surface, settings.mode, size, picked, ctx);
  if (!result && result.error().code == ec::empty_selection) {
    box extent;
    for (const auto& p : surface.points)
      extent.add(p);
    const auto part = extent_of(*mesh);
    if (!extent.meets(part))
      return fail(ec::empty_selection,
                  "the file's surface lies beside the part: it measures " + size_text(extent) +
                    ", the part " + size_text(part),
                  "Check its unit, its scale and its place");
  }
  return result;
}

}  // namespace tedit::ops
