// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/resize_bore/resize_bore.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/number_range.hpp"
#include "mesh/features/surface_shape.hpp"
#include "mesh/pieces.hpp"
#include "ops/shapes/improved.hpp"
#include "ops/shapes/most_that_works.hpp"
#include "ops/shapes/move_by_tool.hpp"
#include "ops/shapes/move_by_vertices.hpp"
#include "ops/shapes/walls/moving_walls.hpp"
#include "ops/tools/placement.hpp"

namespace tedit::ops {

namespace {

/// Halves of one bore differ by less than this share of the radius.
constexpr double same = 1e-3;

std::optional<wall_shape> cylinder_of(const mesh_version& mesh, surface_id id) {
  const auto shape = fit_wall(mesh, facets_of(mesh, std::array{id}), round_enough);
  return shape && shape->type == wall_shape::kind::cylinder ? shape : std::nullopt;
}

bool is_same_cylinder(const wall_shape& a, const wall_shape& b) {
  const vec3 between = b.point - a.point;
  return a.side == b.side && std::abs(a.radius - b.radius) <= same * a.radius &&
         norm(cross(a.axis, b.axis)) <= same &&
         norm(between - dot(between, a.axis) * a.axis) <= same * a.radius;
}

std::string diameter_text(double diameter) {
  return number_text(1e3 * diameter) + " mm";
}

/// What a refusal says of the change of the diameter, said of the diameter.
error about_diameter(error refused, double now, double sign) {
  if (!refused.most)
    return refused;
  refused.most->value = now + sign * refused.most->value;
  const bool is_limit = refused.remedy.find("the most that works") != std::string::npos;
  refused.remedy = "Take a diameter of " + diameter_text(refused.most->value) +
                   (!is_limit  ? ", which works here"
                    : sign > 0 ? ": the largest that works here"
                               : ": the smallest that works here");
  return refused;
}

/// A wider bore as a tool that goes on in its walls' surfaces.
struct wider_bore {
  tool_surface tool;
  std::vector<std::optional<surface_id>> continues;
  double size = 0;  ///< m: the part's mean edge there.
};

/// How far the tool goes from the bore's middle along `way`, which has the end of the bore at
/// `end`, m: out of the part, or to where the wall ends where material is behind.
double reach_of(const mesh_version& mesh, const round_wall& wall, vec3 way, double end,
                double radius, double size) {
  const vec3 foot = wall.shape.point + end * way;
  const frame f = make_frame(foot, way);
  constexpr int around = 8;
  const double between = 0.5 * (wall.shape.radius + radius);
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * i / around;
    if (in_material(mesh, f.at(between * std::cos(angle), between * std::sin(angle), 0.01 * size)))
      return end;
  }
  return end + clearance(mesh, foot, way, radius) + 0.5 * size;
}

/// Each triangle of the tool's wall goes on in the surface of the nearest corner of the bore.
void name_wall(const mesh_version& mesh, const round_wall& wall, std::uint32_t face,
               wider_bore& made) {
  std::vector<std::pair<vec3, surface_id>> corners;
  for (const auto f : facets_of(mesh, wall.surfaces)) {
    const auto& v = mesh.facet(f).v;
    corners.emplace_back((mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2])) / 3,
                         mesh.facet(f).surface);
  }
  const auto first = static_cast<std::uint32_t>(made.tool.names.size());
  for (const auto id : wall.surfaces) {
    made.tool.names.push_back("bore " + std::to_string(id));
    made.continues.resize(made.tool.names.size());
    made.continues.back() = id;
  }
  for (std::size_t i = 0; i < made.tool.triangles.size(); ++i) {
    if (made.tool.faces[i] != face)
      continue;
    const auto& t = made.tool.triangles[i];
    const vec3 at = (made.tool.points[t[0]] + made.tool.points[t[1]] + made.tool.points[t[2]]) / 3;
    const auto nearest =
      std::ranges::min_element(corners, {}, [&](const auto& c) { return norm(c.first - at); });
    const auto place = std::ranges::find(wall.surfaces, nearest->second) - wall.surfaces.begin();
    made.tool.faces[i] = first + static_cast<std::uint32_t>(place);
  }
}

wider_bore widen(const mesh_version& mesh, const round_wall& wall, double diameter) {
  double low = 1e300;
  double high = -1e300;
  box extent;
  for (const auto f : facets_of(mesh, wall.surfaces))
    for (const auto v : mesh.facet(f).v) {
      const double z = dot(mesh.position(v) - wall.shape.point, wall.shape.axis);
      low = std::min(low, z);
      high = std::max(high, z);
      extent.add(mesh.position(v));
    }
  const double r = diameter / 2;
  wider_bore made;
  made.size = local_size(mesh, extent.grown(r - wall.shape.radius));
  const int segments = std::max(24, segments_of(diameter, made.size));
  const double edge = std::min(made.size, 1.5 * std::numbers::pi * diameter / segments);
  const double top = reach_of(mesh, wall, wall.shape.axis, high, r, made.size);
  const double bottom = reach_of(mesh, wall, -wall.shape.axis, -low, r, made.size);
  made.tool = revolve(make_frame(wall.shape.point, wall.shape.axis),
                      {{0, top, ""}, {r, top, "top"}, {r, -bottom, "bore"}, {0, -bottom, "bottom"}},
                      segments, edge);
  made.continues.resize(made.tool.names.size());
  const auto face = std::ranges::find(made.tool.names, "bore") - made.tool.names.begin();
  name_wall(mesh, wall, static_cast<std::uint32_t>(face), made);
  return made;
}

/// Drilled wider: what the walls' own vertices cannot do beside a coarse mesh.
expected<edit_result> drilled(const version_ptr& mesh, const round_wall& wall, double diameter,
                              context& ctx) {
  const auto made = widen(*mesh, wall, diameter);
  const auto cut = ctx.host->boolean_onto(
    mesh, made.tool, made.continues, {boolean_mode::cut, deviation_share * made.size}, ctx.run);
  if (!cut)
    return fail(cut.error());
  return as_edit(*mesh, *cut, made.tool, wall.surfaces);
}

expected<edit_result> resized(const version_ptr& mesh, const round_wall& wall, double diameter,
                              context& ctx) {
  const double now = 2 * wall.shape.radius;
  const double sign = diameter > now ? 1 : -1;
  auto result = at_most(
    mesh, {"diameter", "change of the diameter", std::abs(diameter - now)},
    [&](double change, context& trial) {
      // A pin grows outward, a bore into the material.
      const double distance = wall.shape.side * sign * change / 2;
      wall_ways ways{wall.surfaces, distance, false, {}};
      ways.ways.emplace_back([&] {
        return move_by_vertices(mesh, wall.surfaces, distance, shift_patience::all, trial.run);
      });
      if (wall.shape.side < 0 && sign > 0)
        ways.ways.emplace_back([&] { return drilled(mesh, wall, now + change, trial); });
      ways.ways.emplace_back([&] { return move_by_tool(mesh, wall.surfaces, distance, trial); });
      return first_that_passes(mesh, ways, trial.run);
    },
    ctx);
  if (!result)
    return fail(about_diameter(result.error(), now, sign));
  return result;
}

/// Of all bores together, by what the last version has of them.
void measure(const mesh_version& after, const std::vector<round_wall>& walls, double diameter,
             edit_result& result) {
  double off = 0;
  for (const auto& wall : walls)
    for (const auto f : facets_of(after, wall.surfaces))
      for (const auto v : after.facet(f).v) {
        const vec3 d = after.position(v) - wall.shape.point;
        const double r = norm(d - dot(d, wall.shape.axis) * wall.shape.axis);
        off = std::max(off, std::abs(2 * r - diameter));
      }
  result.figures = {{"diameter_mm", 1e3 * diameter, "mm", "diameter now"},
                    {"diameter_off_mm", 1e3 * off, "mm", "furthest off it at any vertex"}};
}

}  // namespace

expected<round_wall> round_wall_of(const mesh_version& mesh, surface_id picked) {
  const auto shape = cylinder_of(mesh, picked);
  if (!shape)
    return fail(ec::invalid_argument, "surface " + std::to_string(picked) + " is no round cylinder",
                "Pick the wall of a round bore or pin; erode and thicken move walls of any form");
  std::set<surface_id> parts{picked};
  std::vector<surface_id> open{picked};
  while (!open.empty()) {
    const auto id = open.back();
    open.pop_back();
    for (const auto& [other, joint] : shape_of(mesh, id).joints) {
      if (parts.contains(other))
        continue;
      const auto beside = cylinder_of(mesh, other);
      if (beside && is_same_cylinder(*shape, *beside)) {
        parts.insert(other);
        open.push_back(other);
      }
    }
  }
  return round_wall{*shape, {parts.begin(), parts.end()}};
}

expected<edit_result> resize_bores(const version_ptr& mesh, const std::vector<surface_id>& picked,
                                   double diameter, context& ctx) {
  std::vector<round_wall> walls;
  std::set<surface_id> known;
  for (const auto id : picked) {
    if (known.contains(id))
      continue;
    auto wall = round_wall_of(*mesh, id);
    if (!wall)
      return fail(wall.error());
    if (std::abs(2 * wall->shape.radius - diameter) <= same * wall->shape.radius)
      return fail(ec::invalid_parameter,
                  "surface " + std::to_string(id) + " has a diameter of " +
                    diameter_text(2 * wall->shape.radius) + " already",
                  "Give another diameter");
    known.insert(wall->surfaces.begin(), wall->surfaces.end());
    walls.push_back(std::move(*wall));
  }
  std::optional<edit_result> result;
  for (const auto& wall : walls) {
    const auto start = result ? improved(*result, ctx.run) : expected<version_ptr>(mesh);
    if (!start)
      return fail(start.error());
    auto next = resized(*start, wall, diameter, ctx);
    if (!next)
      return next;
    if (result)
      next->quality_floor = std::min(next->quality_floor, result->quality_floor);
    result = std::move(*next);
  }
  if (walls.size() > 1) {
    result->touched = changed_tets(*mesh, *result->candidate);
    result->volume_change = boundary_volume_change(*mesh, *result->candidate);
  }
  result->surfaces_used.assign(known.begin(), known.end());
  measure(*result->candidate, walls, diameter, *result);
  return std::move(*result);
}

}  // namespace tedit::ops
