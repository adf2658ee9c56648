// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/hole.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <unordered_set>

namespace tedit {

namespace {

/// Surfaces reached further from the axis than this many rim radii are not part of the hole.
constexpr double reach = 1.1;
/// The same for the entry (countersink, counterbore) around a hole.
constexpr double entry_reach = 3.0;

bool near_axis(const mesh_version& mesh, const rim& r, const boundary_facet& f, double radii) {
  return std::ranges::all_of(f.v, [&](vertex_id v) {
    const vec3 d = mesh.position(v) - r.centre;
    return norm(d - dot(d, r.normal) * r.normal) <= radii * r.radius;
  });
}

bool near_axis(const mesh_version& mesh, const rim& r, surface_id surface, double radii) {
  const std::array list{surface};
  return std::ranges::all_of(facets_of(mesh, list),
                             [&](facet_id f) { return near_axis(mesh, r, mesh.facet(f), radii); });
}

std::set<surface_id> surfaces_across(const mesh_version& mesh, const rim& r) {
  std::set<surface_id> result;
  for (const auto f : r.outer)
    result.insert(mesh.facet(f).surface);
  return result;
}

/// The unselected facets that hang together with the rim's far side, or nothing as soon as they
/// leave the reach of the rim's axis.
std::set<facet_id> piece_within_reach(const mesh_version& mesh,
                                      const std::unordered_set<facet_id>& selected, const rim& r) {
  std::set<facet_id> piece{r.outer.front()};
  std::vector<facet_id> open{r.outer.front()};
  while (!open.empty()) {
    const auto f = open.back();
    open.pop_back();
    if (!near_axis(mesh, r, mesh.facet(f), reach))
      return {};
    for (int i = 0; i < 3; ++i) {
      const auto across = facet_across(mesh, f, i);
      if (!selected.contains(across) && piece.insert(across).second)
        open.push_back(across);
    }
  }
  return piece;
}

/// Surfaces of a narrower hole that goes on behind a cap and ends inside the part: capping it would
/// leave a closed void. They are those boundary pieces that the selection cuts off from the rest
/// and that lie within reach of the rim's axis.
std::set<surface_id> cut_off_surfaces(const mesh_version& mesh, const std::vector<shell>& shells) {
  std::unordered_set<facet_id> selected;
  for (const auto& part : shells)
    selected.insert(part.facets.begin(), part.facets.end());
  std::set<std::set<facet_id>> pieces;
  std::size_t covered = selected.size();
  for (const auto& part : shells)
    for (const auto& r : part.rims)
      if (auto piece = piece_within_reach(mesh, selected, r); !piece.empty()) {
        const auto size = piece.size();
        covered += pieces.insert(std::move(piece)).second ? size : 0;
      }
  // A part no larger than the reach: its skin is no inside of a hole.
  if (covered == mesh.facet_count() && !pieces.empty())
    pieces.erase(std::ranges::max_element(
      pieces, {}, [](const std::set<facet_id>& piece) { return piece.size(); }));
  std::set<surface_id> result;
  for (const auto& piece : pieces)
    for (const auto f : piece)
      result.insert(mesh.facet(f).surface);
  return result;
}

tl::unexpected<error> refuse_mixed(const rim& r, const std::string& why) {
  return fail(ec::mixed_rim, r.name() + " " + why,
              "Select all surfaces of the hole, or only those up to a clean edge", r.name());
}

}  // namespace

expected<completed_selection> complete_hole(const mesh_version& mesh,
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
    auto shells = find_shells(mesh, facets);
    std::set<surface_id> more;
    for (const auto& part : shells) {
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
    if (more.empty() && !settings.exact) {
      more = cut_off_surfaces(mesh, shells);
      result.behind.insert(result.behind.end(), more.begin(), more.end());
    }
    if (more.empty()) {
      result.shells = std::move(shells);
      result.surfaces = list;
      return result;
    }
    for (const auto id : more)
      if (chosen.insert(id).second)
        result.added.push_back(id);
  }
}

}  // namespace tedit
