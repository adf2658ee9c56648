// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/erode/erode.hpp"

#include "ops/erode/depth.hpp"
#include "ops/erode/layers.hpp"

namespace tedit::ops {

namespace {

/// Nothing to say where no tet was taken off.
void add_counts(const removal_report& removal, edit_result& result) {
  if (removal.pieces == 0)
    return;
  result.figures.push_back(
    {"pieces", static_cast<double>(removal.pieces), "", "pieces of the body"});
  result.figures.push_back(
    {"hinges_repaired", static_cast<double>(removal.hinges_mended), "", "hinges repaired"});
  if (removal.crumbs == 0)
    return;
  result.figures.push_back({"crumbs", static_cast<double>(removal.crumbs), "", "crumbs dropped"});
  char text[96];
  std::snprintf(text, sizeof(text), "%zu loose crumbs of %.4g mm3 together were dropped",
                removal.crumbs, 1e9 * removal.crumb_volume);
  result.notices.emplace_back(text);
}

}  // namespace

expected<edit_result> erode(const mesh_version& mesh, const std::vector<surface_id>& surfaces,
                            const erode_settings& settings, context& ctx) {
  if (surfaces.empty())
    return fail(ec::empty_selection, "no surface was selected", "Select what to take material off");
  if (ctx.run.cancel.cancelled())
    return fail(ec::cancelled, "the edit was cancelled");
  ctx.run.report(0.05, "looking at the surfaces");
  // The version outlives the call; the builder only needs a handle without ownership.
  mesh_builder builder(version_ptr(version_ptr{}, &mesh));
  erosion_sum sum;
  const auto done = settings.depth > 0 ? erode_depth(builder, surfaces, settings.depth, ctx, sum)
                                       : erode_layers(builder, surfaces, settings.layers, ctx, sum);
  if (!done)
    return fail(done.error());
  edit_result result;
  result.candidate = builder.freeze();
  result.touched = builder.touched();
  result.volume_change = boundary_volume_change(mesh, *result.candidate);
  result.surfaces_used = surfaces;
  // The host does not move the new surface's vertices, so its worst tets stay as the cut left them.
  result.quality_floor = 0.1;
  result.figures = std::move(sum.figures);
  result.notices = std::move(sum.notices);
  add_counts(sum.removal, result);
  ctx.run.report(1, "eroded");
  return result;
}

}  // namespace tedit::ops
