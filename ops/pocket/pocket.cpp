// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/pocket/pocket.hpp"

#include "ops/shapes/outlines/svg_outlines.hpp"

namespace tedit::ops {

expected<edit_result> cut_pocket(const version_ptr& mesh, const selection& picked,
                                 const parameters& values, context& ctx) {
  const auto where =
    placement_of(*mesh, picked, values, "direction", std::get<double>(values.at("size")));
  if (!where)
    return fail(where.error());
  const double size = profile_size(*where, values);
  const auto shape = profile_or_file(values, size);
  if (!shape)
    return fail(shape.error());
  const double height = std::get<double>(values.at("height"));
  const double depth =
    height > 0 ? height
               : depth_through(*mesh, where->at, where->outward, radius_of(*shape)) + where->size;
  const double above =
    clearance(*mesh, where->at, where->outward, radius_of(*shape)) + 0.5 * where->size;
  if (auto ok = check_fineness(*where, size, depth + above + 2 * radius_of(*shape)); !ok)
    return fail(ok.error());
  const auto tool =
    extrude(profile_frame(*where, values), *shape, -depth, above, size, "pocket", *ctx.host);
  if (!tool)
    return fail(tool.error());
  return apply_tool(mesh, *tool, boolean_mode::cut, where->size, as_set(picked), ctx);
}

}  // namespace tedit::ops
