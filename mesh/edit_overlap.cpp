// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/edit_overlap.hpp"

#include <algorithm>
#include <set>

#include "mesh/changes.hpp"

namespace tedit {

namespace {

bool is_at_its_place(const mesh_version& here, const mesh_version& there, vertex_id v) {
  return v < there.vertex_slots() && here.position(v) == there.position(v);
}

/// By slot: the live tets of `here` that `there` has not, or with another shape.
std::vector<bool> other_tets(const mesh_version& here, const mesh_version& there) {
  std::vector<bool> found(here.tet_slots());
  for_each_dirty_slot(here.data().tets, there.data().tets, [&](tet_id t) {
    if (t < here.tet_slots() && here.is_live_tet(t))
      found[t] = t >= there.tet_slots() || here.tet_at(t) != there.tet_at(t);
  });
  std::vector<tet_id> star;
  for_each_dirty_slot(here.data().positions, there.data().positions, [&](vertex_id v) {
    if (v >= here.vertex_slots() || !here.is_live_vertex(v) || is_at_its_place(here, there, v))
      return;
    star.clear();
    grow_star(here, v, here.incident_tet(v), star);
    for (const auto t : star)
      found[t] = true;
  });
  return found;
}

/// Another tet behind it is no other facet.
bool is_same_facet(const mesh_version& here, const mesh_version& there, facet_id f) {
  const auto& facet = here.facet(f);
  return f < there.facet_slots() && there.is_live_facet(f) && facet.v == there.facet(f).v &&
         facet.surface == there.facet(f).surface &&
         std::ranges::all_of(facet.v, [&](auto v) { return is_at_its_place(here, there, v); });
}

/// Those of `named` that own a facet here which they have not, or elsewhere, there.
void add_reshaped(const mesh_version& here, const mesh_version& there,
                  const std::set<surface_id>& named, std::set<surface_id>& to) {
  for (facet_id f = 0; f < here.facet_slots() && !named.empty(); ++f)
    if (here.is_live_facet(f) && named.contains(here.facet(f).surface) &&
        !is_same_facet(here, there, f))
      to.insert(here.facet(f).surface);
}

}  // namespace

edit_overlap overlap_of(const mesh_version& seen, const mesh_version& head,
                        const mesh_version& edited, std::span<const surface_id> named) {
  edit_overlap result;
  auto both = other_tets(head, edited);
  const auto since = other_tets(head, seen);
  for (tet_id t = 0; t < head.tet_slots(); ++t) {
    both[t] = both[t] && since[t];
    result.tets += both[t];
  }
  std::set<surface_id> surfaces, reshaped;
  for (facet_id f = 0; f < head.facet_slots() && result.tets > 0; ++f)
    if (head.is_live_facet(f) && both[head.facet(f).tet])
      surfaces.insert(head.facet(f).surface);
  const std::set<surface_id> names(named.begin(), named.end());
  add_reshaped(head, seen, names, reshaped);
  add_reshaped(seen, head, names, reshaped);
  result.surfaces.assign(surfaces.begin(), surfaces.end());
  result.reshaped.assign(reshaped.begin(), reshaped.end());
  return result;
}

}  // namespace tedit
