// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/erode/erode.hpp"

#include "ops/erode/depth.hpp"

namespace tedit::ops {

expected<edit_result> erode(const mesh_version& mesh, const std::vector<surface_id>& surfaces,
                            const erode_settings& settings, context& ctx) {
  ctx.run.report(0.05, "looking at the surfaces");
  // The version outlives the call; the builder only needs a handle without ownership.
  mesh_builder builder(version_ptr(version_ptr{}, &mesh));
  erosion_sum sum;
  const auto done = erode_depth(builder, surfaces, settings.depth, ctx, sum);
  if (!done)
    return fail(done.error());
  edit_result result;
  result.candidate = builder.freeze();
  result.touched = builder.touched();
  result.volume_change = boundary_volume_change(mesh, *result.candidate);
  result.surfaces_used = surfaces;
  result.notices = sum.notices;
  ctx.run.report(1, "eroded");
  return result;
}

}  // namespace tedit::ops
