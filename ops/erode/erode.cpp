// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/erode/erode.hpp"

#include "ops/erode/depth.hpp"
#include "ops/erode/layers.hpp"

namespace tedit::ops {

namespace {

/// "2 loose crumbs of 3 mm3 together were dropped".
std::string gone(std::size_t count, const char* what, double volume) {
  char text[96];
  std::snprintf(text, sizeof(text), "%zu loose %s%s of %.4g mm3%s dropped", count, what,
                count == 1 ? "" : "s", 1e9 * volume, count == 1 ? " was" : " together were");
  return text;
}

/// Nothing to say where no tet was taken off.
void add_counts(const erosion_sum& sum, edit_result& result) {
  const auto& removal = sum.removal;
  if (removal.pieces == 0)
    return;
  result.figures.push_back({"pieces", static_cast<double>(removal.pieces), "",
                            "pieces, of " + std::to_string(removal.pieces - sum.bodies_added) +
                              (removal.pieces - sum.bodies_added == 1 ? " body" : " bodies")});
  result.figures.push_back(
    {"hinges_repaired", static_cast<double>(removal.hinges_mended), "", "hinges repaired"});
  if (sum.bodies_added > 0)
    result.notices.push_back("the part fell apart: " + std::to_string(sum.bodies_added) +
                             " pieces more than before");
  if (removal.dropped > 0)
    result.notices.push_back(gone(removal.dropped, "piece", removal.dropped_volume));
  if (removal.crumbs == 0)
    return;
  result.figures.push_back({"crumbs", static_cast<double>(removal.crumbs), "", "crumbs dropped"});
  result.notices.push_back(gone(removal.crumbs, "crumb", removal.crumb_volume));
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
  sum.policy = settings.pieces;
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
  result.bodies_added = sum.bodies_added;
  add_counts(sum, result);
  ctx.run.report(1, "eroded");
  return result;
}

}  // namespace tedit::ops
