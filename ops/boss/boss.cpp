// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boss/boss.hpp"

#include "ops/shapes/outlines/placed_profile.hpp"

namespace tedit::ops {

expected<edit_result> add_boss(const version_ptr& mesh, const selection& picked,
                               const parameters& values, context& ctx) {
  const double height = std::get<double>(values.at("height"));
  const auto what = placed_profile_of(*mesh, picked, values, 3 * height);
  if (!what)
    return fail(what.error());
  const double radius = radius_of(what->shape);
  const auto span = boss_span(*mesh, what->where, height, radius);
  if (auto ok = check_fineness(what->where, what->size, height - span.from + 2 * radius); !ok)
    return fail(ok.error());
  const auto tool =
    extrude(what->place, what->shape, span.from, span.to, what->size, "boss", *ctx.host);
  if (!tool)
    return fail(tool.error());
  return with_notices(
    apply_tool(mesh, *tool, boolean_mode::add, what->where.size, as_set(picked), ctx),
    what->notices);
}

}  // namespace tedit::ops
