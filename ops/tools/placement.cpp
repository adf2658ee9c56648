// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/tools/placement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/number_range.hpp"
#include "mesh/checks.hpp"

namespace tedit::ops {

namespace {

constexpr int rim_points = 16;

/// The most that `measure` makes of the hits of rays from a rim and its middle; those without any
/// hit are passed over.
template <class Measure>
double most_at_rim(const mesh_version& mesh, vec3 middle, vec3 out, double radius, vec3 along,
                   const Measure& measure) {
  const frame f = make_frame(middle, out);
  double most = 0;
  for (int i = 0; i <= rim_points; ++i) {
    const double angle = 2 * std::numbers::pi * i / rim_points;
    const double r = i < rim_points ? radius : 0;
    const auto hits = ray_hits(mesh, f.at(r * std::cos(angle), r * std::sin(angle), 0), along);
    if (!hits.empty())
      most = std::max(most, measure(hits));
  }
  return most;
}

box around(vec3 p, double reach) {
  box result;
  result.add(p);
  return result.grown(reach);
}

}  // namespace

parameter_description at_parameter(const std::string& name, const std::string& help) {
  parameter_description p;
  p.id = "at";
  p.name = name;
  p.help = help;
  p.type = parameter_type::point;
  p.unit = "m";
  p.default_value = std::string();
  return p;
}

parameter_description direction_parameter(const std::string& id, const std::string& name,
                                          const std::string& help) {
  parameter_description p;
  p.id = id;
  p.name = name;
  p.help = help;
  p.type = parameter_type::direction;
  p.default_value = std::string();
  return p;
}

expected<placement> placement_of(const mesh_version& mesh, const selection& picked,
                                 const parameters& values, const std::string& direction,
                                 double reach) {
  placement result;
  const auto at = vector_of(values, "at");
  const auto plane = values.contains("plane") ? axis_of(values, "plane") : std::nullopt;
  if (plane && (at || vector_of(values, direction)))
    return fail(ec::invalid_parameter, "a plane is given, and a place or a direction beside it",
                "Give the plane alone, or the place and the direction");
  if (plane)
    return placement{plane->point, plane->direction, local_size(mesh, around(plane->point, reach))};
  if (!at && picked.surfaces.empty())
    return fail(ec::empty_selection, "neither a place nor a wall was given",
                "Select the wall, or give the place: at_mm=10,20,5");
  if (!picked.surfaces.empty()) {
    const auto middle = middle_of(mesh, picked.surfaces.front());
    if (!middle)
      return fail(middle.error());
    result.at = middle->point;
    result.outward = middle->normal;
  }
  if (at) {
    result.at = *at;
    result.outward = outward_at(mesh, *at, picked.surfaces);
  }
  if (const auto given = vector_of(values, direction))
    result.outward = normalized(*given);
  result.size = local_size(mesh, around(result.at, reach));
  return result;
}

expected<wall_middle> wall_near(const mesh_version& mesh, vec3 place, double within) {
  const vec3 outward = outward_at(mesh, place);
  const vec3 above = place + within * outward;
  for (const auto& hit : ray_hits(mesh, above, -outward))
    if (!hit.leaves && hit.distance <= 2 * within)
      return wall_middle{above - hit.distance * outward, outward};
  return fail(ec::invalid_parameter,
              "there is no wall within " + number_text(1e3 * within) + " mm of it",
              "Give a place on a wall");
}

bool in_material(const mesh_version& mesh, vec3 point) {
  // A direction that hardly any edge of a part lies along.
  const auto hits = ray_hits(mesh, point, normalized({0.5377, 0.2713, 0.7982}));
  return !hits.empty() && hits.front().leaves;
}

double clearance(const mesh_version& mesh, vec3 at, vec3 out, double radius) {
  return most_at_rim(mesh, at, out, radius, out, [](const auto& hits) {
    return hits.front().leaves ? hits.front().distance : 0;
  });
}

double depth_through(const mesh_version& mesh, vec3 at, vec3 out, double radius) {
  return most_at_rim(mesh, at, out, radius, -out,
                     [](const auto& hits) { return hits.back().distance; });
}

double gap_below(const mesh_version& mesh, vec3 at, vec3 out, double radius) {
  return most_at_rim(mesh, at, out, radius, -out, [&](const auto& hits) {
    const auto& first = hits.front();
    return !first.leaves && first.distance < 4 * radius ? first.distance : 0;
  });
}

expected<void> check_fineness(const placement& where, double edge, double length, int most_edges) {
  constexpr double finest = 1.0 / 200;
  if (edge < finest * where.size)
    return fail(
      ec::invalid_parameter,
      "what is asked for is too small for the mesh there: its edges would measure " +
        number_text(1e3 * edge) + " mm",
      "Make it about " + number_text(std::ceil(finest * where.size / edge)) + " times as large");
  if (length > most_edges * edge)
    return fail(ec::invalid_parameter,
                "what is asked for is too thin for its size: it would take more than " +
                  std::to_string(most_edges) + " edges of " + number_text(1e3 * edge) +
                  " mm along it",
                "Make it thicker or shorter");
  return {};
}

expected<edit_result> as_edit(const mesh_version& mesh, const boolean_result& made,
                              const tool_surface& tool, const std::vector<surface_id>& used) {
  if (boundary_components(*made.candidate) > boundary_components(mesh))
    return fail(ec::invalid_argument,
                made.volume_change > 0 ? "something of what is added would not touch the part"
                                       : "the part would fall into pieces, or have a closed void",
                "Move it, or make it larger or smaller");
  edit_result result;
  result.candidate = made.candidate;
  result.touched = made.touched;
  result.volume_change = made.volume_change;
  result.improve = improvement::none;  // The boolean has done it.
  result.quality_floor = lowest_boolean_quality;
  result.surfaces_used = used;
  std::string names;
  for (std::size_t i = 0; i < made.surfaces.size(); ++i)
    if (made.surfaces[i] && !mesh.find_surface(*made.surfaces[i]))
      names += (names.empty() ? "" : ", ") + std::to_string(*made.surfaces[i]) + " (" +
               tool.names[i] + ")";
  if (!names.empty())
    result.notices.push_back("new surfaces: " + names);
  result.figures.push_back(
    {"deviation_mm", 1e3 * made.deviation, "mm", "furthest off what was asked for"});
  return result;
}

expected<edit_result> apply_tool(const version_ptr& mesh, const tool_surface& tool,
                                 boolean_mode mode, double size,
                                 const std::vector<surface_id>& used, context& ctx) {
  const auto made = ctx.host->boolean(mesh, tool, {mode, deviation_share * size}, ctx.run);
  if (!made)
    return fail(made.error());
  ctx.run.report(1, "combined");
  return as_edit(*mesh, *made, tool, used);
}

}  // namespace tedit::ops
