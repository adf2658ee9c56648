// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/emboss/emboss.hpp"

#include <algorithm>
#include <cmath>

#include "ops/tools/profiles.hpp"
#include "ops/tools/text/text_outlines.hpp"

namespace tedit::ops {

vec3 text_up(vec3 outward) {
  return std::abs(outward.z) < 0.9 ? vec3{0, 0, 1} : vec3{0, 1, 0};
}

namespace {

expected<profile> outlines_of(const emboss_text& what, double edge) {
  if (what.logo)
    return what.logo->outlines(what.letter_height, edge);
  if (what.text.find_first_not_of(" \t") == std::string::npos)
    return fail(ec::invalid_parameter, "there is no text to emboss", "Give text=...");
  const auto font = font_file(what.font);
  if (!font)
    return fail(font.error());
  return text_outlines(what.text, *font, what.letter_height, edge);
}

/// From where to where the letters reach, m, outward of the place.
struct letter_reach {
  double from = 0;
  double to = 0;
};

/// Letters straight through what the wall does below them.
expected<letter_reach> straight(const mesh_version& mesh, const placement& where,
                                const emboss_text& what, double radius, double edge) {
  if (what.height < 0)
    return letter_reach{what.height, clearance(mesh, where.at, where.outward, radius) + 0.5 * edge};
  const vec3 lifted = where.at + 1e-4 * where.size * where.outward;
  const double gap = gap_below(mesh, lifted, where.outward, radius);
  return letter_reach{gap > 1e-3 * where.size ? -gap - 0.2 * edge : 0, what.height};
}

/// The cylinder of the selected wall.
std::optional<wall_shape> round_wall(const mesh_version& mesh,
                                     const std::vector<surface_id>& picked) {
  if (picked.empty())
    return std::nullopt;
  constexpr fit_limits round_enough{3e-3, true, false};
  const auto shape = fit_wall(mesh, facets_of(mesh, std::array{picked.front()}), round_enough);
  return shape && shape->type == wall_shape::kind::cylinder ? shape : std::nullopt;
}

/// Letters that follow a cylinder: the wall's triangles lie off it by the height of their arcs.
/// Errors: `invalid_parameter` where they would reach the axis.
expected<letter_reach> around(const wall_shape& round, const placement& where,
                              const emboss_text& what, double edge) {
  const double arc = where.size * where.size / (8 * round.radius);
  const double below = 2 * arc + 0.2 * edge;
  const letter_reach reach = what.height > 0 ? letter_reach{-below, what.height}
                                             : letter_reach{what.height, below + 0.3 * edge};
  const double inward = round.side > 0 ? -reach.from : reach.to;
  if (inward > 0.8 * round.radius)
    return fail(ec::invalid_parameter,
                "letters of that height would reach the middle of the round wall",
                "Take a smaller height");
  return reach;
}

/// Bends what stands on the plane that touches the cylinder at the place around it.
void wrap(const wall_shape& round, const frame& place, tool_surface& tool) {
  const vec3 normal = round.normal(place.origin);
  const vec3 across = cross(round.axis, normal);
  const vec3 foot = place.origin - round.side * round.radius * normal;  // On the axis.
  for (auto& p : tool.points) {
    const vec3 d = p - place.origin;
    const double angle = round.side * dot(d, across) / round.radius;
    const double height = round.radius + round.side * dot(d, normal);
    p = foot + dot(d, round.axis) * round.axis +
        height * round.side * (std::cos(angle) * normal + std::sin(angle) * across);
  }
}

}  // namespace

expected<emboss_order> emboss_order_of(const mesh_version& mesh, const selection& picked,
                                       const parameters& values) {
  emboss_order order;
  auto& what = order.what;
  what.text = std::get<std::string>(values.at("text"));
  what.font = std::get<std::string>(values.at("font"));
  what.letter_height = std::get<double>(values.at("size"));
  what.height = std::get<double>(values.at("height"));
  what.wraps = std::get<bool>(values.at("wrap"));
  if (!std::get<std::string>(values.at("file")).empty()) {
    auto file = outline_file_of(values);
    if (!file)
      return fail(file.error());
    what.letter_height = file->longer_side(what.letter_height);
    what.logo = std::move(*file);
  }
  if (what.text.size() > 200)
    return fail(ec::invalid_parameter, "the text is longer than 200 bytes", "Give a shorter one");
  auto where = placement_of(mesh, picked, values, "direction", 2 * what.letter_height);
  if (!where)
    return fail(where.error());
  order.where = *where;
  what.up = vector_of(values, "up").value_or(text_up(where->outward));
  return order;
}

expected<emboss_shape> emboss_shape_of(const mesh_version& mesh, const placement& where,
                                       const emboss_text& what,
                                       const std::vector<surface_id>& picked) {
  if (what.height == 0)
    return fail(ec::invalid_parameter, "letters of no height are none",
                "Give a height; a negative one is sunk");
  emboss_shape shape;
  // Strokes are about an eighth of a capital wide.
  shape.edge = std::min(where.size, what.letter_height / (what.logo ? 24 : 8));
  if (auto ok = check_fineness(where, shape.edge, std::abs(what.height)); !ok)
    return fail(ok.error());
  auto outlines = outlines_of(what, shape.edge);
  if (!outlines)
    return fail(outlines.error());
  shape.outlines = std::move(*outlines);
  if (what.logo)
    if (auto ok = check_drawn_edges(*what.logo, shape.outlines, where); !ok)
      return fail(ok.error());
  shape.round = what.wraps ? round_wall(mesh, picked) : std::nullopt;
  placement on = where;
  if (shape.round) {
    on.at = shape.round->project(where.at);
    on.outward = shape.round->normal(where.at);
  }
  const auto reach = shape.round
                       ? around(*shape.round, where, what, shape.edge)
                       : straight(mesh, where, what, radius_of(shape.outlines), shape.edge);
  if (!reach)
    return fail(reach.error());
  shape.place = make_frame(on.at, on.outward, what.up);
  shape.from = reach->from;
  shape.to = reach->to;
  return shape;
}

expected<edit_result> emboss(const version_ptr& mesh, const placement& where,
                             const emboss_text& what, const std::vector<surface_id>& picked,
                             context& ctx) {
  const auto shape = emboss_shape_of(*mesh, where, what, picked);
  if (!shape)
    return fail(shape.error());
  auto tool = extrude(shape->place, shape->outlines, shape->from, shape->to, shape->edge,
                      what.logo ? "logo" : "text", *ctx.host);
  if (!tool)
    return fail(tool.error());
  if (shape->round)
    wrap(*shape->round, shape->place, *tool);
  auto made = apply_tool(mesh, *tool, what.height > 0 ? boolean_mode::add : boolean_mode::cut,
                         where.size, picked, ctx);
  return what.logo ? with_notices(std::move(made), what.logo->notices()) : made;
}

}  // namespace tedit::ops
