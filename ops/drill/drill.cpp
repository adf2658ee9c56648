// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/drill/drill.hpp"

#include <algorithm>
#include <numbers>

namespace tedit::ops {

expected<placed_tool> drill_tool(const mesh_version& mesh, const placement& where,
                                 const drill_shape& shape) {
  const auto hole = drilled_hole_of(mesh, where, shape);
  if (!hole)
    return fail(hole.error());
  // A round wall of 24 edges is within 1.2 % of the cylinder's volume.
  const int segments = std::max(24, segments_of(shape.diameter, where.size));
  const double size = std::min(where.size, 1.5 * std::numbers::pi * shape.diameter / segments);
  if (auto ok = check_fineness(where, size, hole->length, 1000); !ok)
    return fail(ok.error());
  return placed_tool{revolve(hole->place, hole->section, segments, size), where.at, where.size};
}

expected<edit_result> drill(const version_ptr& mesh, const placement& where,
                            const drill_shape& shape, const std::vector<surface_id>& picked,
                            context& ctx) {
  auto tool = drill_tool(*mesh, where, shape);
  if (!tool)
    return fail(tool.error());
  return apply_tools(mesh, {std::move(*tool)}, boolean_mode::cut, picked, ctx);
}

expected<edit_result> drill_holes(const version_ptr& mesh, const selection& picked,
                                  const parameters& values, context& ctx) {
  const auto shape = drill_shape_from(values);
  auto tools = tools_at_places(values, [&](const parameters& here) -> expected<placed_tool> {
    const auto where = placement_of(*mesh, picked, here, "direction", 2 * shape.diameter);
    if (!where)
      return fail(where.error());
    return drill_tool(*mesh, *where, shape);
  });
  if (!tools)
    return fail(tools.error());
  return apply_tools(mesh, std::move(*tools), boolean_mode::cut, as_set(picked), ctx);
}

}  // namespace tedit::ops
