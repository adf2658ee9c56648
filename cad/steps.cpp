// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/steps.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include "base/units.hpp"
#include "mesh/features/wall_shape.hpp"
#include "ops/loader/catalogue.hpp"
#include "ops/shapes/outlines/svg_outlines.hpp"
#include "ops/tools/hole.hpp"
#include "ops/tools/profiles.hpp"

namespace tedit::cad {

namespace {

struct edit_made {
  const mesh_version& before;
  const edit_request& wanted;
  const edit_report& report;
  ops::parameters values;  ///< Complete.

  [[nodiscard]] double number(const char* id) const { return std::get<double>(values.at(id)); }
  [[nodiscard]] const std::string& text(const char* id) const {
    return std::get<std::string>(values.at(id));
  }
  [[nodiscard]] const std::vector<surface_id>& surfaces() const {
    return report.surfaces_used.empty() ? wanted.surfaces : report.surfaces_used;
  }
};

using step_or_reason = tl::expected<cad_step, std::string>;

tl::unexpected<std::string> because(std::string reason) {
  return tl::unexpected(std::move(reason));
}

cad_step on_surfaces(step_kind kind, const edit_made& edit, double distance = 0) {
  cad_step step;
  step.kind = kind;
  step.surfaces.assign(edit.surfaces().begin(), edit.surfaces().end());
  step.distance_mm = distance * mm_of_metre;
  return step;
}

step_or_reason nothing(const edit_made& edit) {
  return on_surfaces(step_kind::none, edit);
}

step_or_reason removal(const edit_made& edit) {
  return on_surfaces(step_kind::remove, edit);
}

step_or_reason erosion(const edit_made& edit) {
  const double depth = edit.number("depth");
  if (depth <= 0)
    return because("layers of tets were taken off, which is no length");
  return on_surfaces(step_kind::shift, edit, -depth);
}

step_or_reason thickening(const edit_made& edit) {
  return on_surfaces(step_kind::shift, edit, edit.number("depth"));
}

step_or_reason resizing(const edit_made& edit) {
  const auto wall = fit_wall(
    edit.before, facets_of(edit.before, std::array{edit.surfaces().front()}), {1e-3, true, false});
  if (!wall || wall->type != wall_shape::kind::cylinder)
    return because("the wall is no cylinder in the mesh");
  return on_surfaces(step_kind::shift, edit,
                     wall->side * (edit.number("diameter") / 2 - wall->radius));
}

template <bool Convex>
step_or_reason rounding(const edit_made& edit) {
  auto step = on_surfaces(step_kind::round, edit, edit.number("radius"));
  step.convex = Convex;
  return step;
}

void place_tool(exact_tool& tool, const ops::frame& place) {
  const auto row = [](vec3 v, double scale) {
    return std::array{scale * v.x, scale * v.y, scale * v.z};
  };
  tool.frame = {row(place.origin, mm_of_metre), row(place.x, 1), row(place.y, 1), row(place.z, 1)};
}

step_or_reason drilling(const edit_made& edit) {
  const auto shape = ops::drill_shape_from(edit.values);
  const auto where = ops::placement_of(edit.before, {edit.wanted.surfaces}, edit.values,
                                       "direction", 2 * shape.diameter);
  if (!where)
    return because(where.error().message);
  const auto hole = ops::drilled_hole_of(edit.before, *where, shape);
  if (!hole)
    return because(hole.error().message);
  cad_step step;
  step.kind = step_kind::cut;
  place_tool(step.tool, hole->place);
  for (const auto& point : hole->section)
    step.tool.section.push_back({mm_of_metre * point.radius, mm_of_metre * point.height});
  return step;
}

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
  std::vector<std::vector<outline_corner>> outlines;
  for (const auto& one : shape.outlines) {
    auto& corners = outlines.emplace_back();
    for (const auto& p : one.points)
      corners.push_back({mm_of_metre * p[0], mm_of_metre * p[1], 0});
  }
  return outlines;
}

/// The two that extrude a profile.
template <step_kind Kind>
step_or_reason extrusion(const edit_made& edit) {
  const auto where = ops::placement_of(edit.before, {edit.wanted.surfaces}, edit.values,
                                       "direction", edit.number("size"));
  if (!where)
    return because(where.error().message);
  const double height = edit.number("height");
  auto size = ops::profile_size(*where, edit.values);
  if (Kind == step_kind::add)
    size = std::min(size, 3 * height);
  const auto shape = ops::profile_or_file(edit.values, size);
  if (!shape)
    return because(shape.error().message);
  const double radius = ops::radius_of(*shape);
  const auto span = Kind == step_kind::add ? ops::boss_span(edit.before, *where, height, radius)
                                           : ops::pocket_span(edit.before, *where, height, radius);
  cad_step step;
  step.kind = Kind;
  place_tool(step.tool, ops::profile_frame(*where, edit.values));
  step.tool.outlines = outlines_of(edit, *shape);
  step.tool.from = mm_of_metre * span.from;
  step.tool.to = mm_of_metre * span.to;
  return step;
}

step_or_reason plane_cut(const edit_made& edit) {
  if (edit.text("keep") == "both")
    return because("the part was cut in two bodies");
  const auto where =
    ops::placement_of(edit.before, {edit.wanted.surfaces}, edit.values, "normal", 0);
  if (!where)
    return because(where.error().message);
  const vec3 at = where->at - edit.number("offset") * where->outward;
  const vec3 out = edit.text("keep") == "below" ? where->outward : -where->outward;
  const auto extent = ops::extent_of(edit.before);
  const double reach = 2 * mm_of_metre * (norm(extent.high - extent.low) + norm(extent.low - at));
  cad_step step;
  step.kind = step_kind::cut;
  place_tool(step.tool, ops::make_frame(at, out));
  step.tool.outlines = {
    {{-reach, -reach, 0}, {reach, -reach, 0}, {reach, reach, 0}, {-reach, reach, 0}}};
  step.tool.to = reach;
  return step;
}

using maker = step_or_reason (*)(const edit_made&);

/// Operations of which it is known what they are on a B-rep.
const std::map<std::string, maker>& makers() {
  static const std::map<std::string, maker> all{
    {"boss", extrusion<step_kind::add>},
    {"close", rounding<false>},
    {"coarsen", nothing},
    {"drill", drilling},
    {"erode", erosion},
    {"fill_hole", removal},
    {"improve_mesh", nothing},
    {"open", rounding<true>},
    {"plane_cut", plane_cut},
    {"pocket", extrusion<step_kind::cut>},
    {"refine", nothing},
    {"remove_surfaces", removal},
    {"resize_bore", resizing},
    {"thicken", thickening},
  };
  return all;
}

}  // namespace

tl::expected<cad_step, std::string> step_of(const ops::operation_description& description,
                                            const mesh_version& before, const edit_request& wanted,
                                            const edit_report& report) {
  const auto made = makers().find(wanted.operation);
  if (made == makers().end())
    return because("the operation " + wanted.operation + " is not made on CAD models");
  auto values = ops::complete_parameters(description, wanted.parameters);
  if (!values)
    return because(values.error().message);
  const edit_made edit{before, wanted, report, std::move(*values)};
  if (edit.surfaces().empty() && wanted.surfaces.empty() && made->second == resizing)
    return because("no wall was given");
  return made->second(edit);
}

}  // namespace tedit::cad
