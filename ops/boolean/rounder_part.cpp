// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/rounder_part.hpp"

#include <algorithm>

#include "mesh/adapt/split_edges.hpp"
#include "mesh/quality.hpp"
#include "ops/tools/local_size.hpp"

namespace tedit::ops {

namespace {

/// Of the tool's least extent and the local size: how far chords may be off their walls, and how
/// far around the tool.
constexpr double chord_share = 0.02;
constexpr double around_share = 0.5;
/// Larger parts are not copied for it: their chords are short.
constexpr std::uint32_t most_tets = 400'000;
/// More tets than these are not made for an edit's sake: the tool is not small then.
constexpr std::size_t most_more_tets = 4'000;
/// That a vertex on its wall may leave, and what is made anew.
constexpr double least_quality = 0.005;
constexpr double flat = 0.2;

/// Has a round wall edges near whose middles are further off it than that?
bool has_chords(const mesh_version& part, const std::vector<facet_id>& facets, round_walls& walls,
                const box& near, double most_off) {
  return std::ranges::any_of(facets, [&](facet_id f) {
    const auto& facet = part.facet(f);
    const std::array corners{part.position(facet.v[0]), part.position(facet.v[1]),
                             part.position(facet.v[2])};
    return walls.is_round(facet.surface) && walls.has_chord(facet.surface, corners, near, most_off);
  });
}

/// m
double least_of(const box& extent, double size) {
  const vec3 wide = extent.high - extent.low;
  return std::min({wide.x, wide.y, wide.z, size});
}

}  // namespace

double most_off_walls(const tool_surface& tool, double size) {
  return chord_share * least_of(extent_of(tool), size);
}

expected<rounder_part> with_shorter_chords(const version_ptr& part, const tool_surface& tool,
                                           const std::vector<facet_id>& near, round_walls& walls,
                                           double size, const execution& run) {
  rounder_part result;
  if (part->tet_count() > most_tets)
    return result;
  box extent = extent_of(tool);
  const double least = least_of(extent, size);
  extent = extent.grown(around_share * least);
  if (!has_chords(*part, near, walls, extent, chord_share * least))
    return result;
  adapt_mesh work(*part);
  const auto made =
    split_chords(*part, work,
                 {extent, [&](surface_id id) { return walls.is_round(id); }, chord_share * least,
                  least_quality, work.tet_count() + most_more_tets},
                 run);
  if (!made)
    return fail(made.error());
  if (made->vertices == 0)
    return result;
  mesh_builder builder(part);
  if (auto ok = work.write(builder); !ok)
    return fail(ok.error());
  for (const auto t : builder.touched())
    if (radius_ratio(builder.corners(t)) < flat)
      result.flat.push_back(t);
  result.mesh = builder.freeze();
  result.is_known = walls.are_known(near);
  return result;
}

}  // namespace tedit::ops
