// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/pocket/pocket.hpp"

#include "base/number_range.hpp"
#include "ops/shapes/outlines/placed_profile.hpp"

namespace tedit::ops {

expected<edit_result> cut_pocket(const version_ptr& mesh, const selection& picked,
                                 const parameters& values, context& ctx) {
  const auto what = placed_profile_of(*mesh, picked, values, largest_number);
  if (!what)
    return fail(what.error());
  const double radius = radius_of(what->shape);
  const auto span = pocket_span(*mesh, what->where, std::get<double>(values.at("height")), radius);
  if (auto ok = check_fineness(what->where, what->size, span.to - span.from + 2 * radius); !ok)
    return fail(ok.error());
  const auto tool =
    extrude(what->place, what->shape, span.from, span.to, what->size, "pocket", *ctx.host);
  if (!tool)
    return fail(tool.error());
  return with_notices(
    apply_tool(mesh, *tool, boolean_mode::cut, what->where.size, as_set(picked), ctx),
    what->notices);
}

}  // namespace tedit::ops
