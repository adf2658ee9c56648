// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/move_by_tool.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/number_range.hpp"
#include "base/text.hpp"
#include "mesh/box_tree.hpp"
#include "mesh/distances.hpp"
#include "ops/shapes/most_that_works.hpp"
#include "ops/shapes/walls/wall_space.hpp"
#include "ops/shapes/walls/wall_tool.hpp"
#include "ops/tools/placement.hpp"

namespace tedit::ops {

namespace {

/// A wall that lies off its place by more than this share of the depth, in the mean, has not moved.
constexpr double mean_tolerance = 0.1;

std::vector<std::array<vec3, 3>> triangles_of(const mesh_version& mesh,
                                              const std::vector<surface_id>& surfaces) {
  std::vector<std::array<vec3, 3>> result;
  for (const auto f : facets_of(mesh, surfaces)) {
    const auto& v = mesh.facet(f).v;
    result.push_back({mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])});
  }
  return result;
}

std::set<region_id> regions_of(const mesh_version& mesh, const std::vector<surface_id>& surfaces) {
  std::set<region_id> regions;
  for (const auto f : facets_of(mesh, surfaces))
    regions.insert(mesh.region_of(mesh.facet(f).tet));
  return regions;
}

/// How far walls are from where they should be, m.
struct measured {
  double mean = 0;
  double worst = 0;
};

measured measure(const mesh_version& after, const std::vector<surface_id>& surfaces,
                 const std::vector<vec3>& places, double depth) {
  const auto walls = triangles_of(after, surfaces);
  std::vector<box> boxes;
  for (const auto& t : walls)
    boxes.push_back(box_of(t));
  const box_tree tree(boxes);
  measured off;
  for (const auto& p : places) {
    double least = depth;
    (void)tree.any_meeting(box_of(std::array{p}).grown(least), [&](std::size_t i) {
      least = std::min(least, point_to_triangle(p, walls[i][0], walls[i][1], walls[i][2]));
      return false;
    });
    off.mean += least / static_cast<double>(places.size());
    off.worst = std::max(off.worst, least);
  }
  return off;
}

bool is_of_mesher(const error& e) {
  return e.code == ec::mesher_failed || e.code == ec::timeout || e.code == ec::not_a_hole ||
         e.code == ec::degenerate_tet;
}

void add_figures(const measured& off, double depth, bool taken, edit_result& result) {
  const std::array figures{
    figure{"thickness_change_mm", 1e3 * (depth - off.mean), "mm",
           taken ? "thickness taken off" : "thickness put on"},
    figure{"thickness_change_worst_mm", 1e3 * (depth - off.worst), "mm",
           taken ? "taken off at the least exact place" : "put on at the least exact place"}};
  result.figures.insert(result.figures.begin(), figures.begin(), figures.end());
}

}  // namespace

expected<edit_result> move_by_tool(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                                   double distance, context& ctx) {
  const auto walls = fit_walls(*mesh, surfaces);
  if (!walls)
    return fail(walls.error());
  if (auto ok = check_room(*walls, distance); !ok)
    return fail(ok.error());
  if (distance > 0 && regions_of(*mesh, surfaces).size() > 1)
    return fail(ec::invalid_argument,
                "what is put on surface " + list_of(surfaces) + " would be of one region alone",
                "Select the walls of one region at a time");
  const auto made = make_wall_tool(*mesh, *walls, distance);
  if (!made)
    return fail(made.error());
  const auto combined = ctx.host->boolean_onto(
    mesh, made->tool, made->continues,
    {distance < 0 ? boolean_mode::cut : boolean_mode::add, deviation_share * made->edge}, ctx.run);
  if (!combined)
    return fail(combined.error());
  auto result = as_edit(*mesh, *combined, made->tool, surfaces);
  if (!result)
    return result;
  for (const auto id : surfaces)
    if (facets_of(*result->candidate, std::vector{id}).empty())
      return fail(ec::invalid_argument,
                  "nothing of surface " + std::to_string(id) + " would be left");
  const double depth = std::abs(distance);
  const auto off = measure(*result->candidate, surfaces, made->places, depth);
  if (off.mean > mean_tolerance * depth)
    return fail(ec::mesher_failed, "the wall would come to lie " + number_text(1e3 * off.mean) +
                                     " mm off where it should");
  if (!made->places.empty())
    add_figures(off, depth, distance < 0, *result);
  if (!made->smooth.empty())
    result->notices.push_back("a step is left where the wall runs on smoothly, beside surface " +
                              list_of(made->smooth) + "; select it, too, to move both");
  // A step that ends in a corner of the part may leave material that touches itself there.
  if (auto ok = passes(mesh, *result, ctx.run); !ok)
    return fail(ok.error());
  return result;
}

expected<edit_result> first_that_passes(const version_ptr& mesh, const wall_ways& all,
                                        const execution& run) {
  std::vector<edit_result> poor;
  std::optional<error> told;
  for (const auto& way : all.round)
    if (auto made = way(); made && passes_if_doubtful(mesh, *made, run))
      return made;
  for (const auto& way : all.ways) {
    auto made = way();
    const auto sound = made ? passes_if_doubtful(mesh, *made, run) : fail(made.error());
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the edit was cancelled");
    if (sound)
      return made;
    if (made)
      poor.push_back(std::move(*made));
    const bool is_limit =
      sound.error().code == ec::invalid_argument || sound.error().code == ec::empty_selection;
    if (&way == &all.ways.front()) {
      if (auto room = check_space(*mesh, all.surfaces, all.distance); !room) {
        // What a slab would run into has a code of its own.
        if (sound.error().code == ec::cap_intersects)
          room.error().code = ec::cap_intersects;
        return fail(room.error());
      }
      if (all.flat && is_limit)
        return fail(sound.error());
    }
    const bool is_last = &way == &all.ways.back();
    if (!told || (!all.flat && is_limit && is_last) ||
        (is_of_mesher(*told) && !is_of_mesher(sound.error())))
      told = sound.error();
  }
  for (auto& made : poor) {
    made.quality_floor = std::min(made.quality_floor, lowest_boolean_quality);
    if (passes(mesh, made, run))
      return std::move(made);
  }
  return fail(*told);
}

}  // namespace tedit::ops
