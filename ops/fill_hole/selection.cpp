// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/fill_hole/selection.hpp"

#include <algorithm>
#include <set>

namespace tedit::ops {

namespace {

/// Surfaces reached further from the axis than this many rim radii are not part of the hole.
constexpr double reach = 1.1;
/// The same for the entry (countersink, counterbore) around a hole.
constexpr double entry_reach = 3.0;

bool near_axis(const mesh_version& mesh, const rim& r, surface_id surface, double radii) {
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f) || mesh.facet(f).surface != surface)
      continue;
    for (const auto v : mesh.facet(f).v) {
      const vec3 d = mesh.position(v) - r.centre;
      if (norm(d - dot(d, r.normal) * r.normal) > radii * r.radius)
        return false;
    }
  }
  return true;
}

std::set<surface_id> surfaces_across(const mesh_version& mesh, const rim& r) {
  std::set<surface_id> result;
  for (const auto f : r.outer)
    result.insert(mesh.facet(f).surface);
  return result;
}

/// Surfaces of a narrower hole that goes on behind a cap and ends inside the part: capping it would
/// leave a closed void. They are those boundary pieces that the selection cuts off from the rest
/// and that lie within reach of the rim's axis.
std::set<surface_id> cut_off_surfaces(const mesh_version& mesh, const boundary_edges& edges,
                                      const std::vector<shell>& shells) {
  std::vector<int> piece(mesh.facet_slots(), -1);
  for (const auto& part : shells)
    for (const auto f : part.facets)
      piece[f] = 0;
  std::vector<std::vector<facet_id>> pieces;
  for (const auto& part : shells) {
    for (const auto& r : part.rims) {
      if (piece[r.outer.front()] != -1)
        continue;
      const int number = static_cast<int>(pieces.size()) + 1;
      std::vector<facet_id> facets{r.outer.front()};
      piece[facets.front()] = number;
      for (std::size_t next = 0; next < facets.size(); ++next) {
        const auto v = mesh.facet(facets[next]).v;
        for (int i = 0; i < 3; ++i) {
          const auto across = edges.left_of(v[(i + 1) % 3], v[i]);
          if (across != no_id && piece[across] == -1) {
            piece[across] = number;
            facets.push_back(across);
          }
        }
      }
      pieces.push_back(std::move(facets));
    }
  }
  std::set<surface_id> result;
  if (pieces.size() < 2)
    return result;
  for (const auto& part : shells)
    for (const auto& r : part.rims) {
      std::set<surface_id> inside;
      for (const auto f : pieces[static_cast<std::size_t>(piece[r.outer.front()]) - 1])
        inside.insert(mesh.facet(f).surface);
      if (std::ranges::all_of(inside, [&](surface_id id) { return near_axis(mesh, r, id, reach); }))
        result.insert(inside.begin(), inside.end());
    }
  return result;
}

tl::unexpected<error> refuse_mixed(const rim& r, const std::string& why) {
  return fail(ec::mixed_rim, r.name() + " " + why,
              "Select all surfaces of the hole, or only those up to a clean edge", r.name());
}

}  // namespace

expected<completed_selection> complete_selection(const mesh_version& mesh,
                                                 const boundary_edges& edges,
                                                 const std::vector<surface_id>& surfaces,
                                                 const completion_settings& settings) {
  std::set<surface_id> chosen(surfaces.begin(), surfaces.end());
  completed_selection result;
  while (true) {
    const std::vector<surface_id> list(chosen.begin(), chosen.end());
    const auto facets = facets_of(mesh, list);
    if (facets.empty())
      return fail(ec::empty_selection,
                  "the selected surfaces have no outer side: they lie between two regions",
                  "Select the walls of a hole");
    auto shells = find_shells(mesh, edges, facets);
    if (!shells)
      return fail(shells.error());
    std::set<surface_id> more;
    for (const auto& part : *shells) {
      for (const auto& r : part.rims) {
        const bool concave = r.concave_share >= 0.5;
        if (settings.exact || (r.concave_share == 0 && !settings.include_entry))
          continue;
        if (!concave && r.concave_share > 0)
          return refuse_mixed(r, "is part open edge, part inner corner: no flat cap closes it");
        for (const auto id : surfaces_across(mesh, r)) {
          if (near_axis(mesh, r, id, concave ? reach : entry_reach))
            more.insert(id);
          else if (concave)
            return refuse_mixed(
              r, "runs into surface " + std::to_string(id) + ", which reaches beyond the hole");
        }
      }
    }
    if (more.empty() && !settings.exact)
      more = cut_off_surfaces(mesh, edges, *shells);
    if (more.empty()) {
      result.shells = std::move(*shells);
      result.surfaces = list;
      return result;
    }
    for (const auto id : more)
      if (chosen.insert(id).second)
        result.added.push_back(id);
  }
}

}  // namespace tedit::ops
