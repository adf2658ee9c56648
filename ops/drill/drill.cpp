// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/drill/drill.hpp"

#include <algorithm>
#include <numbers>

namespace tedit::ops {

expected<edit_result> drill(const version_ptr& mesh, const placement& where,
                            const drill_shape& shape, const std::vector<surface_id>& picked,
                            context& ctx) {
  const auto hole = drilled_hole_of(*mesh, where, shape);
  if (!hole)
    return fail(hole.error());
  // A round wall of 24 edges is within 1.2 % of the cylinder's volume.
  const int segments = std::max(24, segments_of(shape.diameter, where.size));
  const double size = std::min(where.size, 1.5 * std::numbers::pi * shape.diameter / segments);
  if (auto ok = check_fineness(where, size, hole->length, 1000); !ok)
    return fail(ok.error());
  return apply_tool(mesh, revolve(hole->place, hole->section, segments, size), boolean_mode::cut,
                    where.size, picked, ctx);
}

}  // namespace tedit::ops
