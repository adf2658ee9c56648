// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/thicken/thicken.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/level_set_tidy.hpp"
#include "mesh/pieces.hpp"
#include "mesh/shift_patch.hpp"
#include "ops/shapes/most_that_works.hpp"
#include "ops/shapes/move_by_tool.hpp"
#include "ops/shapes/move_by_vertices.hpp"
#include "ops/thicken/slab_shell.hpp"

namespace tedit::ops {

namespace {

class slab_merger {
public:
  slab_merger(mesh_builder& mesh, const surface_patch& patch) : mesh_(mesh), patch_(patch) {}

  expected<void> merge(const slab_shell& shell, const tet_filling& filling) {
    auto vertices = shell.vertices;
    vertices.resize(filling.points.size(), no_id);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (vertices[i] == no_id)
        vertices[i] = mesh_.add_vertex(filling.points[i]);
    cavity_change change;
    const auto region = mesh_.region_of(mesh_.facet(shell.covered.front()).tet);
    for (const auto& t : filling.tets)
      change.added.push_back(
        {{{vertices[t[0]], vertices[t[1]], vertices[t[2]], vertices[t[3]]}}, region});
    change.glued = shell.covered;
    const auto& triangles = shell.surface.triangles;
    for (std::size_t i = shell.covered.size(); i < triangles.size(); ++i) {
      const auto& t = triangles[i];
      const bool cap = i >= shell.cap_first;
      const auto surface = cap ? patch_.surface
                               : side_surface(shell.neighbour[i - shell.covered.size()],
                                              normalized(area_vector(shell.surface.points[t[0]],
                                                                     shell.surface.points[t[1]],
                                                                     shell.surface.points[t[2]])));
      change.facets.push_back({{vertices[t[0]], vertices[t[1]], vertices[t[2]]}, surface});
    }
    if (const auto done = mesh_.apply(change); !done)
      return fail(done.error());
    return {};
  }

private:
  surface_id side_surface(facet_id beside, vec3 normal) {
    const auto& facet = mesh_.facet(beside);
    const auto& v = facet.v;
    const vec3 n =
      normalized(area_vector(mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2])));
    if (dot(n, normal) > 1 - 1e-9)
      return facet.surface;
    const auto [row, fresh] = sides_.try_emplace(facet.surface, 0);
    if (fresh)
      row->second = mesh_.add_surface("side above " + std::to_string(facet.surface));
    return row->second;
  }

  mesh_builder& mesh_;
  const surface_patch& patch_;
  std::map<surface_id, surface_id> sides_;
};

/// How a flat surface rises: a small height needs no slab.
enum class rising { by_vertices, as_slab };

expected<surface_patch> raise(mesh_builder& mesh, surface_id surface, double height, rising how,
                              context& ctx) {
  auto patch = find_patch(mesh, surface);
  if (!patch)
    return fail(patch.error());
  constexpr double least_quality = 0.1;
  if (shift_patch(mesh, *patch, height, least_quality))
    return patch;
  if (how == rising::by_vertices)
    return fail(ec::mesher_failed, "the surface finds no way by its own vertices");
  const auto region = [&](facet_id f) { return mesh.region_of(mesh.facet(f).tet); };
  if (std::ranges::any_of(patch->facets,
                          [&](facet_id f) { return region(f) != region(patch->facets.front()); }))
    return fail(ec::mesher_failed, "a slab would be of one of the surface's regions alone");
  if (auto ok = split_rising_neighbours(mesh, *patch, height, ctx.run); !ok)
    return fail(ok.error());
  patch = find_patch(mesh, surface);
  if (!patch)
    return fail(patch.error());
  const auto shell = make_slab_shell(mesh, *patch, height, *ctx.host);
  if (!shell)
    return fail(shell.error());
  if (auto ok = check_free(mesh, *shell); !ok)
    return fail(ok.error());
  const auto filling = ctx.host->tetrahedralise(shell->surface, ctx.run);
  if (!filling)
    return fail(filling.error());
  if (auto ok = slab_merger(mesh, *patch).merge(*shell, *filling); !ok)
    return fail(ok.error());
  return patch;
}

/// Distance of the raised surfaces from where they were.
void measure(const mesh_builder& mesh, const std::vector<surface_patch>& before, double height,
             edit_result& result) {
  double area = 0;
  double mean = 0;
  double worst = height;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    const auto& facet = mesh.facet(f);
    const auto old = std::ranges::find(before, facet.surface, &surface_patch::surface);
    if (old == before.end())
      continue;
    const double share = norm(
      area_vector(mesh.position(facet.v[0]), mesh.position(facet.v[1]), mesh.position(facet.v[2])));
    area += share;
    for (const auto v : facet.v) {
      const double rise = -old->depth(mesh.position(v));
      mean += share * rise / 3;
      if (std::abs(rise - height) > std::abs(worst - height))
        worst = rise;
    }
  }
  if (area == 0)
    return;
  result.figures.push_back({"thickness_change_mm", 1e3 * mean / area, "mm", "thickness put on"});
  result.figures.push_back(
    {"thickness_change_worst_mm", 1e3 * worst, "mm", "put on at the least exact place"});
}

/// Flat surfaces, one after the other.
expected<void> raise_planes(mesh_builder& mesh, const std::vector<surface_id>& surfaces,
                            double height, rising how, context& ctx, edit_result& result) {
  std::vector<surface_patch> before;
  for (const auto surface : surfaces) {
    ctx.run.report(
      0.1 + 0.7 * static_cast<double>(before.size()) / static_cast<double>(surfaces.size()),
      "growing the slab");
    auto raised = raise(mesh, surface, height, how, ctx);
    if (!raised)
      return fail(raised.error());
    before.push_back(std::move(*raised));
  }
  if (const auto tidied = tidy_cut(mesh, mesh.touched(), {}, ctx.run); !tidied)
    return fail(tidied.error());
  measure(mesh, before, height, result);
  return {};
}

expected<edit_result> raised_flat(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                                  double height, rising how, context& ctx) {
  mesh_builder builder(mesh);
  edit_result result;
  if (auto ok = raise_planes(builder, surfaces, height, how, ctx, result); !ok)
    return fail(ok.error());
  result.candidate = builder.freeze();
  result.touched = builder.touched();
  result.volume_change = boundary_volume_change(*mesh, *result.candidate);
  result.surfaces_used = surfaces;
  // The triangles that the slab stands on were made for another height.
  result.quality_floor = 0.1;
  return result;
}

/// Flat surfaces at round ones move by their vertices, with the fillets around them; else they get
/// a slab. Others move by their own vertices, and flat ones whose height is far below the edge
/// length; else what lies above is added.
expected<edit_result> raised(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                             bool flat, double height, context& ctx) {
  wall_ways all{surfaces, height, flat, {}};
  const auto by_vertices = [&](shift_patience patience) {
    return move_by_vertices(mesh, surfaces, height, patience, ctx.run);
  };
  if (flat && move_better_by_vertices(mesh, surfaces, height))
    all.round = {[&] { return raised_flat(mesh, surfaces, height, rising::by_vertices, ctx); },
                 [&] { return by_vertices(shift_patience::little); }};
  if (flat)
    all.ways.emplace_back(
      [&] { return raised_flat(mesh, surfaces, height, rising::as_slab, ctx); });
  all.ways.emplace_back([&] { return by_vertices(shift_patience::all); });
  all.ways.emplace_back([&] { return move_by_tool(mesh, surfaces, height, ctx); });
  return first_that_passes(mesh, all, ctx.run);
}

}  // namespace

expected<edit_result> thicken(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                              double height, context& ctx) {
  if (surfaces.empty())
    return fail(ec::empty_selection, "no surface was selected", "Select what to put material on");
  if (ctx.run.cancel.cancelled())
    return fail(ec::cancelled, "the edit was cancelled");
  const auto flat = all_flat(mesh_builder(mesh), surfaces);
  if (!flat)
    return fail(flat.error());
  auto result = at_most(
    mesh, {"depth", "thickness", height},
    [&](double value, context& trial) { return raised(mesh, surfaces, *flat, value, trial); }, ctx);
  if (result)
    ctx.run.report(1, "thickened");
  return result;
}

}  // namespace tedit::ops
