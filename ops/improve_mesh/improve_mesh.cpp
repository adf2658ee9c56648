// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/improve_mesh/improve_mesh.hpp"

#include <algorithm>
#include <cstdio>

#include "mesh/facet_pages.hpp"
#include "ops/improve_mesh/flat_tets.hpp"

namespace tedit::ops {

namespace {

/// Rings of tets around a picked surface: inside them the wall, which must stay, does not count.
constexpr int rings = 3;

expected<std::vector<tet_id>> near_surfaces(const mesh_version& mesh,
                                            const std::vector<surface_id>& surfaces, context& ctx) {
  std::vector<vertex_id> front;
  for (const auto f : facets_of(mesh, surfaces))
    front.insert(front.end(), mesh.facet(f).v.begin(), mesh.facet(f).v.end());
  std::vector<tet_id> result;
  for (int ring = 0; ring < rings; ++ring) {
    if (ctx.run.cancel.cancelled())
      return fail(ec::cancelled, "the edit was cancelled");
    std::ranges::sort(front);
    const auto repeated = std::ranges::unique(front);
    front.erase(repeated.begin(), repeated.end());
    result = tets_around(mesh, front);
    for (const auto t : result)
      front.insert(front.end(), mesh.tet_at(t).v.begin(), mesh.tet_at(t).v.end());
  }
  return result;
}

/// Of the part's size. A boundary that may move further is no longer that of this part.
constexpr double largest_tolerance = 0.01;

/// Errors: `invalid_parameter`.
expected<void> check_tolerance(const mesh_version& mesh, double tolerance) {
  if (tolerance == 0)
    return {};
  box extent;
  for (std::size_t p = 0; p < mesh.data().facets.pages().size(); ++p)
    extent.add(facet_page_of(mesh, p)->extent);
  const double most = largest_tolerance * norm(extent.high - extent.low);
  if (tolerance <= most)
    return {};
  char numbers[160];
  std::snprintf(numbers, sizeof(numbers),
                "It takes 0 to %.4g mm here, a hundredth of the part's diagonal", 1e3 * most);
  return fail(ec::invalid_parameter,
              "parameter surface_tolerance: the boundary of this part may not move so far",
              numbers);
}

/// All tets, or those around what is picked.
expected<std::vector<tet_id>> region_of(const mesh_version& mesh, const selection& picked,
                                        context& ctx) {
  if (!picked.surfaces.empty())
    return near_surfaces(mesh, picked.surfaces, ctx);
  std::vector<tet_id> all;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t))
      all.push_back(t);
  return all;
}

void tell(const flat_mending& flat, edit_result& result) {
  if (flat.found == 0)
    return;
  result.figures.push_back(
    {"flat_tets_mended", static_cast<double>(flat.mended), "", "tets without volume meshed anew"});
  if (flat.mended < flat.found)
    result.notices.push_back(std::to_string(flat.found - flat.mended) +
                             " tets without volume are left: no mesh without them was found");
}

}  // namespace

expected<edit_result> improve_mesh(const version_ptr& mesh, const selection& picked,
                                   const thorough_settings& settings, context& ctx) {
  if (ctx.run.cancel.cancelled())
    return fail(ec::cancelled, "the edit was cancelled");
  if (auto ok = check_tolerance(*mesh, settings.tolerance.absolute); !ok)
    return fail(ok.error());
  ctx.run.report(0.1, "finding the region");
  auto region = region_of(*mesh, picked, ctx);
  if (!region)
    return fail(region.error());
  mesh_builder builder(mesh);
  const auto flat = mend_flat_tets(builder, *region, ctx);
  if (!flat)
    return fail(flat.error());
  edit_result result;
  result.candidate = builder.freeze();
  if (flat->mended > 0) {
    region = region_of(*result.candidate, picked, ctx);
    if (!region)
      return fail(region.error());
  }
  result.touched = std::move(*region);
  tell(*flat, result);
  result.surfaces_used = picked.surfaces;
  result.improve = improvement::thorough;
  result.thorough = settings;
  ctx.run.report(1, "found");
  return result;
}

}  // namespace tedit::ops
