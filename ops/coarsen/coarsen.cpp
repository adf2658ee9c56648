// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/coarsen/coarsen.hpp"

#include "mesh/adapt/collapse_edges.hpp"
#include "mesh/pieces.hpp"
#include "ops/shapes/mesh_pick.hpp"

namespace tedit::ops {

namespace {

constexpr double floor_quality = 0.1;
constexpr double depth_share = 3;
constexpr double tolerance_share = 0.02;

collapse_settings completed(const mesh_version& mesh, const mesh_pick& pick,
                            const coarsen_settings& given) {
  collapse_settings result;
  result.pick = pick;
  result.size = given.size > 0 ? given.size : 2 * mean_size(mesh, pick);
  result.depth = given.depth > 0 ? given.depth : depth_share * result.size;
  result.tolerance = given.tolerance > 0 ? given.tolerance : tolerance_share * result.size;
  return result;
}

}  // namespace

expected<edit_result> coarsen(const version_ptr& mesh, const mesh_pick& pick,
                              const coarsen_settings& given, context& ctx) {
  if (auto ok = check_pick(*mesh, pick); !ok)
    return fail(ok.error());
  if (ctx.run.cancel.cancelled())
    return fail(ec::cancelled, "the edit was cancelled");
  const auto settings = completed(*mesh, pick, given);
  ctx.run.report(0.1, "contracting edges");
  adapt_mesh work(*mesh);
  const auto made = collapse_edges(*mesh, work, settings, ctx.run);
  if (!made)
    return fail(made.error());
  if (made->vertices == 0)
    return fail(ec::invalid_parameter,
                "no edge there can go: those shorter than " + size_text(settings.size) +
                  " are needed for the part's shape or for good tets",
                "Take a larger size, or a larger tolerance");
  ctx.run.report(0.8, "putting the new tets in");
  mesh_builder builder(mesh);
  if (auto written = work.write(builder); !written)
    return fail(written.error().code, written.error().message,
                "Improve the mesh first: improve_mesh");
  edit_result result;
  result.touched = builder.touched();
  result.candidate = builder.freeze();
  result.volume_change = boundary_volume_change(*mesh, *result.candidate);
  result.surfaces_used = pick.surfaces;
  result.quality_floor = floor_quality;
  result.figures = {
    {"vertices_gone", static_cast<double>(made->vertices), "", "vertices that went"},
    {"tets_gone", static_cast<double>(mesh->tet_count()) - work.tet_count(), "", "tets fewer"},
    {"deviation_mm", 1e3 * made->deviation, "mm",
     "furthest that the boundary is from where it was"}};
  ctx.run.report(1, "coarsened");
  return result;
}

}  // namespace tedit::ops
