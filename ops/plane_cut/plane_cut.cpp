// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/plane_cut/plane_cut.hpp"

namespace tedit::ops {

expected<edit_result> plane_cut(const version_ptr& mesh, vec3 at, vec3 normal, bool keep_below,
                                const std::vector<surface_id>& picked, context& ctx) {
  const auto extent = extent_of(*mesh);
  const double size = local_size(*mesh, extent);
  const vec3 away = keep_below ? -normal : normal;
  // What the plane's normal points away from goes.
  const auto tool = half_space(extent, at, away, size, "cut", *ctx.host);
  if (!tool)
    return fail(tool.error());
  auto result = apply_tool(mesh, *tool, boolean_mode::cut, size, picked, ctx);
  if (!result && result.error().code == ec::empty_selection)
    return fail(ec::empty_selection, "the plane leaves the part as it is, or nothing of it",
                "Move the plane into the part, or keep its other side");
  return result;
}

}  // namespace tedit::ops
