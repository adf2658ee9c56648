// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/erode/layers.hpp"

#include <algorithm>
#include <set>

#include "base/text.hpp"
#include "mesh/optimize/smooth_surface.hpp"

namespace tedit::ops {

namespace {

/// The vertices all of whose facets lie on the surfaces: those at the border belong to a surface
/// that stays.
std::unordered_set<vertex_id> inner_vertices(const mesh_builder& mesh,
                                             const std::vector<surface_id>& surfaces) {
  std::unordered_set<vertex_id> inside;
  std::vector<facet_id> others;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    const auto& facet = mesh.facet(f);
    if (std::ranges::count(surfaces, facet.surface))
      inside.insert(facet.v.begin(), facet.v.end());
    else
      others.push_back(f);
  }
  for (const auto f : others)
    for (const auto v : mesh.facet(f).v)
      inside.erase(v);
  return inside;
}

std::set<region_id> regions_at(const mesh_builder& mesh, const std::vector<surface_id>& surfaces) {
  std::set<region_id> result;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f) && std::ranges::count(surfaces, mesh.facet(f).surface))
      result.insert(mesh.region_of(mesh.facet(f).tet));
  return result;
}

/// Of these regions alone: where another one begins the layers end.
std::unordered_set<tet_id> layer_below(const mesh_builder& mesh,
                                       const std::unordered_set<vertex_id>& inside,
                                       const std::set<region_id>& regions) {
  std::unordered_set<tet_id> layer;
  for (const auto v : inside)
    for (const auto t : mesh.star(v))
      if (regions.contains(mesh.region_of(t)))
        layer.insert(t);
  return layer;
}

tl::unexpected<error> nothing_to_take(const std::vector<surface_id>& surfaces, int layer) {
  const std::string what = (surfaces.size() == 1 ? "surface " : "surfaces ") + list_of(surfaces);
  if (layer > 1)
    return fail(ec::empty_selection,
                "there is no layer " + std::to_string(layer) + ": the surface that layer " +
                  std::to_string(layer - 1) + " laid bare has no vertex inside its border",
                "Take off fewer layers, or a length (parameter depth)");
  return fail(ec::empty_selection,
              what + " has no vertex inside its border, so no layer of tets lies below it alone",
              "Take off a length (parameter depth), or select the surfaces beside it, too");
}

}  // namespace

expected<void> erode_layers(mesh_builder& mesh, const std::vector<surface_id>& surfaces, int layers,
                            context& ctx, erosion_sum& sum) {
  const auto fresh = mesh.add_surface("eroded " + list_of(surfaces));
  sum.fresh.push_back(fresh);
  const auto regions = regions_at(mesh, surfaces);
  auto current = surfaces;
  for (int layer = 1; layer <= layers; ++layer) {
    if (ctx.run.cancel.cancelled())
      return fail(ec::cancelled, "the edit was cancelled");
    ctx.run.report(0.1 + 0.6 * (layer - 1) / layers, "taking off a layer");
    auto removed = layer_below(mesh, inner_vertices(mesh, current), regions);
    if (removed.empty())
      return nothing_to_take(surfaces, layer);
    const auto settled = settle_removal(mesh, removed, sum.policy);
    if (!settled)
      return fail(settled.error());
    sum.add(*settled);
    if (auto ok = take_off(mesh, removed, [&](const auto&) { return fresh; }); !ok)
      return fail(ok.error());
    current = surfaces;
    current.push_back(fresh);
  }
  ctx.run.report(0.8, "smoothing");
  smooth_settings settings;
  settings.quality_floor = 0.1;
  const auto smoothed = smooth_surface(mesh, {fresh}, settings, ctx.run);
  if (!smoothed)
    return fail(smoothed.error());
  return {};
}

}  // namespace tedit::ops
