// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/surface_map.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>

#include "mesh/changes.hpp"
#include "mesh/facet_pages.hpp"

namespace tedit {

namespace {

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

/// Does a page of facets have corners in pages of positions that differ?
bool has_corners_in(const facet_page& page, const std::vector<std::size_t>& dirty) {
  return std::ranges::any_of(
    page.positions, [&](const auto& row) { return std::ranges::binary_search(dirty, row.first); });
}

/// Surfaces with a facet that differs between the versions, in slots of dirty pages, or with a
/// vertex that moved.
std::set<surface_id> touched_surfaces(const mesh_version& before, const mesh_version& after) {
  std::set<surface_id> result;
  for_each_dirty_slot(before.data().facets, after.data().facets, [&](facet_id i) {
    const auto* was = i < before.facet_slots() ? &before.facet(i) : nullptr;
    const auto* is = i < after.facet_slots() ? &after.facet(i) : nullptr;
    if (was && is && was->v == is->v && was->surface == is->surface)
      return;
    if (was && was->tet != no_id)
      result.insert(was->surface);
    if (is && is->tet != no_id)
      result.insert(is->surface);
  });
  add_touched_interfaces(before, after, result);
  const auto moved = dirty_pages(before.data().positions, after.data().positions);
  const auto pages =
    std::min(before.data().facets.pages().size(), after.data().facets.pages().size());
  for (std::size_t p = 0; p < pages; ++p) {
    if (!has_corners_in(*facet_page_of(after, p), moved))
      continue;
    const auto was = before.data().facets.page_items(p);
    const auto is = after.data().facets.page_items(p);
    for (std::size_t i = 0; i < std::min(was.size(), is.size()); ++i) {
      if (was[i].tet == no_id || is[i].tet == no_id)
        continue;
      for (const auto v : is[i].v)
        if (v < before.vertex_slots() && before.position(v) != after.position(v))
          result.insert(is[i].surface);
    }
  }
  return result;
}

/// For surfaces that came or went: the surface on the other side that holds most of the area of
/// facets with the same corners.
std::map<surface_id, std::map<surface_id, double>> overlaps(const mesh_version& from,
                                                            const mesh_version& to,
                                                            const std::set<surface_id>& surfaces) {
  std::map<surface_id, std::map<surface_id, double>> result;
  if (surfaces.empty())
    return result;
  const auto slots = std::min(from.facet_slots(), to.facet_slots());
  for_each_dirty_slot(from.data().facets, to.data().facets, [&](facet_id f) {
    if (f >= slots)
      return;
    const auto& here = from.facet(f);
    const auto& there = to.facet(f);
    if (from.is_live_facet(f) && to.is_live_facet(f) && here.surface != there.surface &&
        here.v == there.v && surfaces.contains(here.surface))
      result[here.surface][there.surface] += norm(area_vector(from, here));
  });
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
  const auto touched = touched_surfaces(before, after);
  if (touched.empty())
    return {};
  const auto areas_before = surface_areas(before);
  const auto areas_after = surface_areas(after);
  const auto area_in = [](const std::map<surface_id, double>& areas, surface_id id) {
    const auto found = areas.find(id);
    return found == areas.end() ? 0 : found->second;
  };
  std::set<surface_id> gone;
  std::set<surface_id> come;
  for (const auto id : touched) {
    if (!after.find_surface(id))
      gone.insert(id);
    if (!before.find_surface(id))
      come.insert(id);
  }
  const auto merged = overlaps(before, after, gone);
  const auto split = overlaps(after, before, come);
  std::vector<surface_change> changes;
  for (const auto id : touched) {
    surface_change change{id, surface_fate::changed,     0,
                          {}, area_in(areas_before, id), area_in(areas_after, id)};
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
