// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/edit_overlap.hpp"

#include <algorithm>
#include <set>

#include "mesh/changes.hpp"

namespace tedit {

namespace {

/// What `from` has that `to` has not so, by slot of `from`.
struct differences {
  std::vector<bool> tets;
  std::vector<bool> vertices;

  [[nodiscard]] bool at(const mesh_version& from, tet_id t) const {
    return tets[t] || std::ranges::any_of(from.tet_at(t).v, [&](auto v) { return vertices[v]; });
  }
};

differences compare(const mesh_version& from, const mesh_version& to) {
  differences found{std::vector<bool>(from.tet_slots()), std::vector<bool>(from.vertex_slots())};
  for_each_dirty_slot(from.data().tets, to.data().tets, [&](tet_id t) {
    if (t < from.tet_slots())
      found.tets[t] = t >= to.tet_slots() || from.tet_at(t) != to.tet_at(t);
  });
  for_each_dirty_slot(from.data().positions, to.data().positions, [&](vertex_id v) {
    if (v < from.vertex_slots())
      found.vertices[v] = v >= to.vertex_slots() || from.position(v) != to.position(v);
  });
  return found;
}

/// Live tets of `from` that `to` has not, or with another shape. Ascending.
std::vector<tet_id> other_tets(const mesh_version& from, const mesh_version& to) {
  std::vector<tet_id> found;
  for_each_dirty_slot(from.data().tets, to.data().tets, [&](tet_id t) {
    if (t < from.tet_slots() && from.is_live_tet(t) &&
        (t >= to.tet_slots() || from.tet_at(t) != to.tet_at(t)))
      found.push_back(t);
  });
  std::vector<tet_id> star;
  for_each_dirty_slot(from.data().positions, to.data().positions, [&](vertex_id v) {
    if (v >= from.vertex_slots() || !from.is_live_vertex(v) ||
        (v < to.vertex_slots() && from.position(v) == to.position(v)))
      return;
    star.clear();
    grow_star(from, v, from.incident_tet(v), star);
    found.insert(found.end(), star.begin(), star.end());
  });
  std::ranges::sort(found);
  const auto twice = std::ranges::unique(found);
  found.erase(twice.begin(), twice.end());
  return found;
}

bool is_same_facet(const mesh_version& here, const mesh_version& there, facet_id f) {
  return f < there.facet_slots() && there.is_live_facet(f) && here.facet(f).v == there.facet(f).v &&
         here.facet(f).surface == there.facet(f).surface;
}

/// Those of `selected` that own a facet here which they have not, or elsewhere, there.
void add_reshaped(const mesh_version& here, const mesh_version& there,
                  const std::vector<bool>& moved, std::span<const surface_id> selected,
                  std::set<surface_id>& to) {
  for (facet_id f = 0; f < here.facet_slots(); ++f) {
    if (!here.is_live_facet(f) || !std::ranges::count(selected, here.facet(f).surface))
      continue;
    const auto& v = here.facet(f).v;
    if (!is_same_facet(here, there, f) || std::ranges::any_of(v, [&](auto c) { return moved[c]; }))
      to.insert(here.facet(f).surface);
  }
}

}  // namespace

edit_overlap overlap_of(const mesh_version& seen, const mesh_version& head,
                        const mesh_version& edited, std::span<const surface_id> selected) {
  edit_overlap result;
  const auto since = compare(head, seen);
  auto both = other_tets(head, edited);
  std::erase_if(both, [&](tet_id t) { return !since.at(head, t); });
  result.tets = both.size();
  std::set<surface_id> surfaces, reshaped;
  if (result.tets > 0)
    for (facet_id f = 0; f < head.facet_slots(); ++f)
      if (head.is_live_facet(f) && std::ranges::binary_search(both, head.facet(f).tet))
        surfaces.insert(head.facet(f).surface);
  result.surfaces.assign(surfaces.begin(), surfaces.end());
  if (!selected.empty()) {
    add_reshaped(head, seen, since.vertices, selected, reshaped);
    add_reshaped(seen, head, compare(seen, head).vertices, selected, reshaped);
  }
  result.reshaped.assign(reshaped.begin(), reshaped.end());
  return result;
}

}  // namespace tedit
