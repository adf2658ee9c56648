// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/surface_map.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>

namespace tedit {

namespace {

/// What is known of one surface on both sides.
struct tally {
  double before = 0;
  double after = 0;
  bool touched = false;
};

double facet_area(const mesh_version& mesh, const boundary_facet& f) {
  return norm(area_vector(mesh, f));
}

double facet_area(const mesh_version& mesh, const interface_facet& f) {
  const vec3 a = mesh.position(f.v[0]);
  return norm(cross(mesh.position(f.v[1]) - a, mesh.position(f.v[2]) - a)) / 2;
}

/// Facets between regions by surface and corners, ascending.
std::vector<std::tuple<surface_id, std::array<vertex_id, 3>>> sorted_interfaces(
  const mesh_version& mesh) {
  std::vector<std::tuple<surface_id, std::array<vertex_id, 3>>> result;
  const auto& all = mesh.data().interfaces;
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto corners = all[i].v;
    std::ranges::sort(corners);
    result.emplace_back(all[i].surface, corners);
  }
  std::ranges::sort(result);
  return result;
}

/// Surfaces with a facet between regions that only one of the versions has.
void add_touched_interfaces(const mesh_version& before, const mesh_version& after,
                            std::set<surface_id>& result) {
  const auto was = sorted_interfaces(before);
  const auto is = sorted_interfaces(after);
  std::vector<std::tuple<surface_id, std::array<vertex_id, 3>>> differing;
  std::ranges::set_symmetric_difference(was, is, std::back_inserter(differing));
  for (const auto& facet : differing)
    result.insert(std::get<0>(facet));
}

/// Surfaces with a facet that differs between the versions, in slots of dirty pages, or with a
/// vertex that moved.
std::set<surface_id> touched_surfaces(const mesh_version& before, const mesh_version& after) {
  std::set<surface_id> result;
  constexpr std::size_t facet_row = 5;
  constexpr auto per_page = paged_array<boundary_facet>::items_per_page;
  for (const auto p :
       dirty_pages(before.pages().arrays[facet_row], after.pages().arrays[facet_row])) {
    for (std::size_t i = p * per_page; i < (p + 1) * per_page; ++i) {
      const auto* old_facet = i < before.facet_slots() ? &before.data().facets[i] : nullptr;
      const auto* new_facet = i < after.facet_slots() ? &after.data().facets[i] : nullptr;
      if (old_facet && new_facet && old_facet->v == new_facet->v &&
          old_facet->surface == new_facet->surface)
        continue;
      if (old_facet && old_facet->tet != no_id)
        result.insert(old_facet->surface);
      if (new_facet && new_facet->tet != no_id)
        result.insert(new_facet->surface);
    }
  }
  add_touched_interfaces(before, after, result);
  if (dirty_pages(before.pages().arrays[0], after.pages().arrays[0]).empty())
    return result;
  for (facet_id f = 0; f < std::min(before.facet_slots(), after.facet_slots()); ++f) {
    if (!before.is_live_facet(f) || !after.is_live_facet(f))
      continue;
    for (const auto v : after.facet(f).v)
      if (v < before.vertex_slots() && before.position(v) != after.position(v))
        result.insert(after.facet(f).surface);
  }
  return result;
}

void add_areas(const mesh_version& mesh, std::map<surface_id, tally>& tallies,
               double tally::*side) {
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    const auto found = tallies.find(mesh.facet(f).surface);
    if (found != tallies.end())
      found->second.*side += facet_area(mesh, mesh.facet(f));
  }
  const auto& between = mesh.data().interfaces;
  for (std::size_t i = 0; i < between.size(); ++i)
    if (const auto found = tallies.find(between[i].surface); found != tallies.end())
      found->second.*side += facet_area(mesh, between[i]);
}

/// For surfaces that came or went: the surface on the other side that holds most of the area of
/// facets with the same corners.
std::map<surface_id, std::map<surface_id, double>> overlaps(const mesh_version& from,
                                                            const mesh_version& to,
                                                            const std::set<surface_id>& surfaces) {
  std::map<surface_id, std::map<surface_id, double>> result;
  for (facet_id f = 0; f < std::min(from.facet_slots(), to.facet_slots()); ++f) {
    if (!from.is_live_facet(f) || !to.is_live_facet(f))
      continue;
    const auto& here = from.facet(f);
    const auto& there = to.facet(f);
    if (here.surface != there.surface && here.v == there.v && surfaces.contains(here.surface))
      result[here.surface][there.surface] += facet_area(from, here);
  }
  return result;
}

}  // namespace

std::string_view fate_name(surface_fate fate) noexcept {
  switch (fate) {
    case surface_fate::kept:
      return "kept";
    case surface_fate::changed:
      return "changed";
    case surface_fate::added:
      return "added";
    case surface_fate::removed:
      return "removed";
    case surface_fate::merged_into:
      return "merged_into";
    case surface_fate::split_from:
      return "split_from";
  }
  return "kept";
}

std::vector<surface_change> compare_surfaces(const mesh_version& before,
                                             const mesh_version& after) {
  std::map<surface_id, tally> tallies;
  for (const auto id : touched_surfaces(before, after))
    tallies[id].touched = true;
  if (tallies.empty())
    return {};
  add_areas(before, tallies, &tally::before);
  add_areas(after, tallies, &tally::after);
  std::set<surface_id> gone;
  std::set<surface_id> come;
  for (const auto& [id, row] : tallies) {
    if (!after.find_surface(id))
      gone.insert(id);
    if (!before.find_surface(id))
      come.insert(id);
  }
  const auto merged = overlaps(before, after, gone);
  const auto split = overlaps(after, before, come);
  std::vector<surface_change> changes;
  for (const auto& [id, row] : tallies) {
    surface_change change{id, surface_fate::changed, 0, {}, row.before, row.after};
    const auto* table_row = after.find_surface(id);
    if (!table_row)
      table_row = before.find_surface(id);
    change.name = table_row ? table_row->name : std::string{};
    const auto most_of = [&](const auto& candidates) {
      surface_id best = 0;
      double area = -1;
      for (const auto& [other, shared] : candidates)
        if (shared > area)
          std::tie(best, area) = std::tuple(other, shared);
      return best;
    };
    if (gone.contains(id)) {
      const auto into = merged.find(id);
      change.fate = into == merged.end() ? surface_fate::removed : surface_fate::merged_into;
      change.other = into == merged.end() ? 0 : most_of(into->second);
    } else if (come.contains(id)) {
      const auto from = split.find(id);
      change.fate = from == split.end() ? surface_fate::added : surface_fate::split_from;
      change.other = from == split.end() ? 0 : most_of(from->second);
    }
    changes.push_back(std::move(change));
  }
  return changes;
}

}  // namespace tedit
