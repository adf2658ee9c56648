// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>

#include "base/number_range.hpp"
#include "cad/step_makers.hpp"
#include "ops/combine/combine.hpp"
#include "ops/emboss/emboss.hpp"
#include "ops/rib/rib.hpp"
#include "ops/services/host_services.hpp"
#include "ops/shapes/outlines/placed_profile.hpp"
#include "ops/sweep/sweep_along.hpp"
#include "ops/tools/hole.hpp"
#include "ops/tools/profiles.hpp"
#include "ops/tools/several_places.hpp"

namespace tedit::cad {

namespace {

std::array<double, 3> in_mm(vec3 p) {
  return {mm_of_metre * p.x, mm_of_metre * p.y, mm_of_metre * p.z};
}

void place_tool(exact_tool& tool, const ops::frame& place) {
  const auto row = [](vec3 v, double scale) {
    return std::array{scale * v.x, scale * v.y, scale * v.z};
  };
  tool.frame = {row(place.origin, mm_of_metre), row(place.x, 1), row(place.y, 1), row(place.z, 1)};
}

std::vector<outline_corner> straight_outline(const std::vector<std::array<double, 2>>& points) {
  std::vector<outline_corner> corners;
  for (const auto& p : points)
    corners.push_back({mm_of_metre * p[0], mm_of_metre * p[1], 0});
  return corners;
}

std::vector<std::vector<outline_corner>> straight_outlines(const std::vector<ops::outline>& from) {
  std::vector<std::vector<outline_corner>> outlines;
  for (const auto& one : from)
    outlines.push_back(straight_outline(one.points));
  return outlines;
}

}  // namespace

namespace {

/// A step with a tool for each place of the edit, as `make` makes it of the values there.
template <class Make>
step_or_reason at_places(const edit_made& edit, step_kind kind, const Make& make) {
  const auto places = ops::at_each_place(edit.values);
  if (!places)
    return because(places.error().message);
  cad_step step;
  step.kind = kind;
  for (std::size_t i = 0; i < places->size(); ++i) {
    expected<exact_tool> tool = make((*places)[i]);
    if (!tool)
      return because(tool.error().message);
    (i == 0 ? step.tool : step.more.emplace_back()) = std::move(*tool);
  }
  return step;
}

}  // namespace

step_or_reason drilling(const edit_made& edit) {
  const auto shape = ops::drill_shape_from(edit.values);
  const auto make = [&](const ops::parameters& here) -> expected<exact_tool> {
    const auto where =
      ops::placement_of(edit.before, {edit.wanted.surfaces}, here, "direction", 2 * shape.diameter);
    if (!where)
      return fail(where.error());
    const auto hole = ops::drilled_hole_of(edit.before, *where, shape);
    if (!hole)
      return fail(hole.error());
    exact_tool tool;
    place_tool(tool, hole->place);
    for (const auto& point : hole->section)
      tool.section.push_back({mm_of_metre * point.radius, mm_of_metre * point.height});
    return tool;
  };
  return at_places(edit, step_kind::cut, make);
}

namespace {

std::vector<outline_corner> circle(double radius) {
  return {{radius, 0, 1}, {-radius, 0, 1}};
}

std::vector<outline_corner> slot(double length, double width) {
  const double r = width / 2;
  const double x = length / 2 - r;
  return {{-x, -r, 0}, {x, -r, 1}, {x, r, 0}, {-x, r, 1}};
}

/// The exact profile, mm: as `ops::profile_from`, with arcs instead of edges.
std::vector<std::vector<outline_corner>> outlines_of(const edit_made& edit,
                                                     const ops::profile& shape) {
  const double size = mm_of_metre * edit.number("size");
  const double width = mm_of_metre * edit.number("width");
  if (edit.text("profile") == "circle")
    return {circle(size / 2)};
  if (edit.text("profile") == "slot")
    return {slot(size, width > 0 ? width : size / 2)};
  return straight_outlines(shape.outlines);
}

/// The two that extrude a profile.
template <step_kind Kind>
step_or_reason extrusion(const edit_made& edit) {
  const double height = edit.number("height");
  const auto make = [&](const ops::parameters& here) -> expected<exact_tool> {
    const auto what = ops::placed_profile_of(edit.before, {edit.wanted.surfaces}, here,
                                             Kind == step_kind::add ? 3 * height : largest_number);
    if (!what)
      return fail(what.error());
    const double radius = ops::radius_of(what->shape);
    const auto span = Kind == step_kind::add
                        ? ops::boss_span(edit.before, what->where, height, radius)
                        : ops::pocket_span(edit.before, what->where, height, radius);
    exact_tool tool;
    place_tool(tool, what->place);
    tool.outlines = outlines_of(edit, what->shape);
    tool.from = mm_of_metre * span.from;
    tool.to = mm_of_metre * span.to;
    return tool;
  };
  return at_places(edit, Kind, make);
}

}  // namespace

step_or_reason boss_extrusion(const edit_made& edit) {
  return extrusion<step_kind::add>(edit);
}

step_or_reason pocket_extrusion(const edit_made& edit) {
  return extrusion<step_kind::cut>(edit);
}

step_or_reason plane_cut(const edit_made& edit) {
  const auto where =
    ops::placement_of(edit.before, {edit.wanted.surfaces}, edit.values, "normal", 0);
  if (!where)
    return because(where.error().message);
  const vec3 at = where->at - edit.number("offset") * where->outward;
  const vec3 out = edit.text("keep") == "above" ? -where->outward : where->outward;
  const auto extent = ops::extent_of(edit.before);
  const double reach = 2 * mm_of_metre * (norm(extent.high - extent.low) + norm(extent.low - at));
  cad_step step;
  step.kind = edit.text("keep") == "both" ? step_kind::split : step_kind::cut;
  place_tool(step.tool, ops::make_frame(at, out));
  step.tool.outlines = {
    {{-reach, -reach, 0}, {reach, -reach, 0}, {reach, reach, 0}, {-reach, reach, 0}}};
  step.tool.to = reach;
  return step;
}

step_or_reason embossing(const edit_made& edit) {
  const auto order = ops::emboss_order_of(edit.before, {edit.wanted.surfaces}, edit.values);
  if (!order)
    return because(order.error().message);
  const auto shape = ops::emboss_shape_of(edit.before, order->where, order->what,
                                          ops::as_set({edit.wanted.surfaces}));
  if (!shape)
    return because(shape.error().message);
  if (shape->round)
    return because(
      "letters around a round wall stand on the facets of the mesh, not on the cylinder");
  cad_step step;
  step.kind = order->what.height > 0 ? step_kind::add : step_kind::cut;
  place_tool(step.tool, shape->place);
  // As the mesh has them: curves in the same edges.
  step.tool.outlines = straight_outlines(shape->outlines.outlines);
  step.tool.from = mm_of_metre * shape->from;
  step.tool.to = mm_of_metre * shape->to;
  return step;
}

step_or_reason ribbing(const edit_made& edit) {
  const auto rib = ops::rib_prism_of(edit.before, ops::as_set({edit.wanted.surfaces}),
                                     ops::rib_shape_of(edit.values));
  if (!rib)
    return because(rib.error().message);
  cad_step step;
  step.kind = step_kind::add;
  place_tool(step.tool, rib->place);
  step.tool.outlines = {straight_outline(rib->points)};
  step.tool.to = mm_of_metre * rib->thickness / 2;
  step.tool.from = -step.tool.to;
  return step;
}

namespace {

/// A closed surface, a face for each triangle. `what`: whose they are, for the reason why not.
step_or_reason faceted(const std::string& what, const std::vector<vec3>& points,
                       const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (triangles.size() > most_facets)
    return because(what + " has " + std::to_string(triangles.size()) +
                   " triangles, each would be a face of the CAD model; " +
                   std::to_string(most_facets) + " are the most");
  cad_step step;
  for (const auto& p : points)
    step.tool.points.push_back(in_mm(p));
  for (const auto& t : triangles)
    step.tool.triangles.push_back(
      {static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2])});
  return step;
}

}  // namespace

/// With the edges around that the mesh has, and none between the corners of the path.
step_or_reason sweeping(const edit_made& edit) {
  const auto order = ops::sweep_order_of(edit.before, {edit.wanted.surfaces}, edit.values);
  if (!order)
    return because(order.error().message);
  const auto host = ops::make_host_services();
  const auto tool = ops::sweep(order->path, order->shape, order->up,
                               2 * (order->length + order->reach), "sweep", *host);
  if (!tool)
    return because(tool.error().message);
  auto step = faceted("the swept profile", tool->points, tool->triangles);
  if (step)
    step->kind = order->mode == ops::boolean_mode::add ? step_kind::add : step_kind::cut;
  return step;
}

step_or_reason combining(const edit_made& edit) {
  const auto order = ops::combine_order_of(edit.values);
  if (!order)
    return because(order.error().message);
  auto step = faceted("the file", ops::placed_points(order->surface, order->settings),
                      order->surface.triangles);
  if (!step)
    return step;
  step->kind = order->settings.mode == ops::boolean_mode::add   ? step_kind::add
               : order->settings.mode == ops::boolean_mode::cut ? step_kind::cut
                                                                : step_kind::keep;
  return step;
}

step_or_reason hollowing(const edit_made& edit) {
  if (edit.before.regions().size() > 1)
    return because("one region of several became hollow");
  const double thickness = edit.number("thickness");
  const double r = edit.number("drain_diameter") / 2;
  auto step = on_surfaces(step_kind::hollow, edit, thickness);
  if (r <= 0)
    return step;
  step.surfaces.clear();
  const auto drain_at = [&](const ops::wall_middle& wall) {
    const double above = ops::clearance(edit.before, wall.point, wall.normal, r);
    auto& drain = step.more.emplace_back();
    place_tool(drain, ops::make_frame(wall.point, wall.normal));
    const double top = mm_of_metre * (above + 0.5 * thickness);
    const double bottom = -1.5 * mm_of_metre * thickness;
    drain.section = {{0, top}, {mm_of_metre * r, top}, {mm_of_metre * r, bottom}, {0, bottom}};
  };
  for (const auto wall : ops::as_set({edit.wanted.surfaces})) {
    const auto middle = ops::middle_of(edit.before, wall);
    if (!middle)
      return because(middle.error().message);
    drain_at(*middle);
  }
  for (const auto& place : ops::points_of(edit.values, "drain_points")) {
    const auto wall = ops::wall_near(edit.before, place, thickness / 2);
    if (!wall)
      return because(wall.error().message);
    drain_at(*wall);
  }
  return step;
}

}  // namespace tedit::cad
