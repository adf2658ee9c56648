// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boss/boss.hpp"

#include <algorithm>

#include "ops/shapes/outlines/svg_outlines.hpp"

namespace tedit::ops {

expected<edit_result> add_boss(const version_ptr& mesh, const selection& picked,
                               const parameters& values, context& ctx) {
  const auto where =
    placement_of(*mesh, picked, values, "direction", std::get<double>(values.at("size")));
  if (!where)
    return fail(where.error());
  const double height = std::get<double>(values.at("height"));
  const double size = std::min(profile_size(*where, values), 3 * height);
  const auto shape = profile_or_file(values, size);
  if (!shape)
    return fail(shape.error());
  const auto span = boss_span(*mesh, *where, height, radius_of(*shape));
  if (auto ok = check_fineness(*where, size, height - span.from + 2 * radius_of(*shape)); !ok)
    return fail(ok.error());
  const auto tool =
    extrude(profile_frame(*where, values), *shape, span.from, span.to, size, "boss", *ctx.host);
  if (!tool)
    return fail(tool.error());
  return apply_tool(mesh, *tool, boolean_mode::add, where->size, as_set(picked), ctx);
}

}  // namespace tedit::ops
