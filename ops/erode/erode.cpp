// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/erode/erode.hpp"

#include <functional>
#include <optional>

#include "ops/erode/depth.hpp"
#include "ops/erode/layers.hpp"
#include "ops/shapes/most_that_works.hpp"
#include "ops/shapes/move_by_tool.hpp"
#include "ops/shapes/move_by_vertices.hpp"

namespace tedit::ops {

namespace {

/// "2 loose crumbs of 3 mm3 together were dropped".
std::string gone(std::size_t count, const std::string& what, double volume) {
  char size[32];
  std::snprintf(size, sizeof(size), "%.4g mm3", 1e9 * volume);
  return count == 1
           ? "1 " + what + " of " + size + " was dropped"
           : std::to_string(count) + " " + what + "s of " + size + " together were dropped";
}

/// Nothing to say where no tet was taken off.
void add_counts(const erosion_sum& sum, edit_result& result) {
  const auto& removal = sum.removal;
  if (removal.pieces == 0)
    return;
  const auto bodies = removal.pieces - sum.bodies_added;
  result.figures.push_back(
    {"pieces", static_cast<double>(removal.pieces), "",
     bodies == 1 ? "pieces, of 1 body" : "pieces, of " + std::to_string(bodies) + " bodies"});
  result.figures.push_back(
    {"hinges_repaired", static_cast<double>(removal.hinges_mended), "", "hinges repaired"});
  if (sum.bodies_added > 0)
    result.notices.push_back("the part fell apart: " + std::to_string(sum.bodies_added) +
                             " pieces more than before");
  if (removal.dropped > 0)
    result.notices.push_back(gone(removal.dropped, "loose piece", removal.dropped_volume));
  if (removal.crumbs == 0)
    return;
  result.figures.push_back({"crumbs", static_cast<double>(removal.crumbs), "", "crumbs dropped"});
  result.notices.push_back(gone(removal.crumbs, "loose crumb", removal.crumb_volume));
}

/// From the boundary alone: that is quicker than over all tets. m^3. By cones from a vertex of the
/// part, which keeps the sum exact far from the origin. Cost: O(facet slots).
double enclosed_volume(const mesh_version& mesh) {
  double six_times = 0;
  std::optional<vec3> apex;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    const auto& v = mesh.facet(f).v;
    if (!apex)
      apex = mesh.position(v[0]);
    six_times += dot(mesh.position(v[0]) - *apex,
                     cross(mesh.position(v[1]) - *apex, mesh.position(v[2]) - *apex));
  }
  return six_times / 6;
}

/// One way to take material off.
using erosion = std::function<expected<void>(mesh_builder& mesh, erosion_sum& sum)>;

expected<edit_result> eroded_by(const erosion& way, const version_ptr& mesh,
                                const std::vector<surface_id>& surfaces, piece_policy policy) {
  mesh_builder builder(mesh);
  erosion_sum sum;
  sum.policy = policy;
  if (const auto done = way(builder, sum); !done)
    return fail(done.error());
  edit_result result;
  result.candidate = builder.freeze();
  result.touched = builder.touched();
  result.volume_change = boundary_volume_change(*mesh, *result.candidate);
  result.surfaces_used = surfaces;
  // The host does not move the new surface's vertices, so its worst tets stay as the cut left them.
  result.quality_floor = 0.1;
  result.figures = std::move(sum.figures);
  result.notices = std::move(sum.notices);
  result.bodies_added = sum.bodies_added;
  add_counts(sum, result);
  return result;
}

/// Flat surfaces at round ones go down by their vertices, with the fillets around them; else they
/// are cut free or lowered one by one. Others move by their own vertices, and flat ones that cannot
/// be cut; else what lies below is cut off.
expected<edit_result> lowered(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                              bool flat, double depth, piece_policy policy, context& ctx) {
  wall_ways all{surfaces, -depth, flat, {}};
  const auto by_vertices = [&](shift_patience patience) {
    return move_by_vertices(mesh, surfaces, -depth, patience, ctx.run);
  };
  const auto flat_by = [&](lowering how) {
    return eroded_by(
      [&, how](mesh_builder& to, erosion_sum& sum) {
        return erode_depth(to, surfaces, depth, how, ctx, sum);
      },
      mesh, surfaces, policy);
  };
  if (flat && move_better_by_vertices(mesh, surfaces, -depth))
    all.round = {[&] { return flat_by(lowering::by_vertices); },
                 [&] { return by_vertices(shift_patience::little); }};
  if (flat)
    all.ways.emplace_back([&] { return flat_by(lowering::with_cuts); });
  all.ways.emplace_back([&] { return by_vertices(shift_patience::all); });
  all.ways.emplace_back([&] { return move_by_tool(mesh, surfaces, -depth, ctx); });
  return first_that_passes(mesh, all, ctx.run);
}

}  // namespace

expected<edit_result> erode(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                            const erode_settings& settings, context& ctx) {
  if (surfaces.empty())
    return fail(ec::empty_selection, "no surface was selected", "Select what to take material off");
  if (settings.depth <= 0 && settings.layers <= 0)
    return fail(ec::invalid_parameter, "neither a depth nor layers of tets are given",
                "Give a depth above 0, or a number of layers");
  if (ctx.run.cancel.cancelled())
    return fail(ec::cancelled, "the edit was cancelled");
  ctx.run.report(0.05, "looking at the surfaces");
  const auto flat = all_flat(mesh_builder(mesh), surfaces);
  if (settings.depth > 0 && !flat)
    return fail(flat.error());
  auto result = settings.depth > 0
                  ? at_most(
                      mesh, {"depth", "depth", settings.depth},
                      [&](double depth, context& trial) {
                        return lowered(mesh, surfaces, *flat, depth, settings.pieces, trial);
                      },
                      ctx)
                  : eroded_by(
                      [&](mesh_builder& to, erosion_sum& sum) {
                        return erode_layers(to, surfaces, settings.layers, ctx, sum);
                      },
                      mesh, surfaces, settings.pieces);
  if (!result)
    return result;
  result->figures.push_back({"volume_change_percent",
                             100 * result->volume_change / enclosed_volume(*mesh), "%",
                             "of the part's volume"});
  if (settings.depth > 0 && settings.layers > 0)
    result->notices.push_back("the depth was taken off; layers count where the depth is 0");
  ctx.run.report(1, "eroded");
  return result;
}

}  // namespace tedit::ops
