// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/erode/depth.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/level_set_tidy.hpp"
#include "mesh/shift_patch.hpp"
#include "ops/erode/slab.hpp"

namespace tedit::ops {

namespace {

/// A surface whose tets would come out worse (q = 3 r_in/R_circ) is cut instead of moved.
constexpr double least_quality = 0.1;

/// Names the faces that one slab lays bare.
class slab_surfaces {
public:
  slab_surfaces(mesh_builder& mesh, const slab& cut, erosion_sum& sum)
      : mesh_(mesh), cut_(cut), sum_(sum) {}

  surface_id name(const std::array<vertex_id, 3>& face) {
    const auto* wall = cut_.on_floor(face) ? nullptr : cut_.wall_of(face);
    // The lowered surface is still the one that was picked: what acts on it goes with it.
    if (!wall)
      return cut_.patch().surface;
    const auto [row, fresh] = walls_.try_emplace(wall, 0);
    if (fresh)
      row->second = id_of(*wall);
    return row->second;
  }

private:
  /// The neighbour that a wall continues: it stands in the wall's plane and faces the slab.
  surface_id id_of(const patch_wall& wall) {
    const auto& outer = mesh_.facet(wall.outer);
    const bool live = mesh_.is_live_facet(wall.outer);
    if (live) {
      const auto& v = outer.v;
      const vec3 n =
        normalized(area_vector(mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2])));
      if (dot(n, wall.outward) < -1 + 1e-9)
        return outer.surface;
    }
    const auto neighbour = live ? outer.surface : cut_.patch().surface;
    const auto [row, fresh] = beside_.try_emplace(neighbour, 0);
    if (fresh) {
      row->second = mesh_.add_surface("wall below " + std::to_string(neighbour));
      sum_.fresh.push_back(row->second);
    }
    return row->second;
  }

  mesh_builder& mesh_;
  const slab& cut_;
  erosion_sum& sum_;
  std::map<const patch_wall*, surface_id> walls_;
  std::map<surface_id, surface_id> beside_;
};

expected<void> cut_off(mesh_builder& mesh, const surface_patch& patch, double depth, context& ctx,
                       erosion_sum& sum) {
  const auto region = mesh.region_of(mesh.facet(patch.facets.front()).tet);
  slab below(mesh, patch, depth);
  if (auto ok = below.cut(ctx.run); !ok)
    return fail(ok.error());
  auto removed = below.tets();
  if (!removed)
    return fail(removed.error());
  // What lies below a wall may belong to another region: planes do not end there.
  if (std::ranges::any_of(*removed, [&](tet_id t) { return mesh.region_of(t) != region; }))
    return fail(ec::mesher_failed, "below the wall lies another region");
  const auto settled = settle_removal(mesh, *removed, sum.policy);
  if (!settled)
    return fail(settled.error());
  sum.add(*settled);
  slab_surfaces names(mesh, below, sum);
  const auto taken = take_off(mesh, *removed, [&](const auto& face) { return names.name(face); });
  if (!taken)
    return fail(taken.error());
  return {};
}

/// Distance of the new surfaces from the old planes, as the mesh now has it.
void measure(const mesh_builder& mesh, const std::vector<surface_patch>& done, double depth,
             erosion_sum& sum) {
  double area = 0;
  double mean = 0;
  double worst = depth;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    const auto& facet = mesh.facet(f);
    const auto before = std::ranges::find(done, facet.surface, &surface_patch::surface);
    if (before == done.end())
      continue;
    std::array<double, 3> depths;
    for (int i = 0; i < 3; ++i) {
      depths[i] = before->depth(mesh.position(facet.v[i]));
      if (std::abs(depths[i] - depth) > std::abs(worst - depth))
        worst = depths[i];
    }
    const double share = norm(
      area_vector(mesh.position(facet.v[0]), mesh.position(facet.v[1]), mesh.position(facet.v[2])));
    area += share;
    mean += share * (depths[0] + depths[1] + depths[2]) / 3;
  }
  if (area == 0)
    return;
  sum.figures.push_back({"thickness_change_mm", 1e3 * mean / area, "mm", "thickness taken off"});
  sum.figures.push_back(
    {"thickness_change_worst_mm", 1e3 * worst, "mm", "taken off at the least exact place"});
}

}  // namespace

expected<void> erode_depth(mesh_builder& mesh, const std::vector<surface_id>& surfaces,
                           double depth, lowering how, context& ctx, erosion_sum& sum) {
  std::vector<surface_patch> done;
  bool cut = false;
  for (const auto surface : surfaces) {
    ctx.run.report(
      0.1 + 0.7 * static_cast<double>(done.size()) / static_cast<double>(surfaces.size()),
      "cutting");
    auto patch = find_patch(mesh, surface);
    if (!patch)
      return fail(patch.error());
    if (!shift_patch(mesh, *patch, -depth, least_quality)) {
      if (how == lowering::by_vertices)
        return fail(ec::mesher_failed, "the surface finds no way by its own vertices");
      cut = true;
      if (auto ok = cut_off(mesh, *patch, depth, ctx, sum); !ok)
        return fail(ok.error());
    }
    done.push_back(std::move(*patch));
  }
  if (cut) {
    ctx.run.report(0.85, "mending the cut");
    const auto tidied = tidy_cut(mesh, mesh.touched(), {}, ctx.run);
    if (!tidied)
      return fail(tidied.error());
  }
  measure(mesh, done, depth, sum);
  return {};
}

}  // namespace tedit::ops
