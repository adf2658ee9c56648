// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/receipt_successors.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "mesh/changes.hpp"

namespace tedit::fem {

namespace {

using corners = std::array<vertex_id, 3>;

corners sorted_corners(const boundary_facet& f) {
  corners v{f.v[0], f.v[1], f.v[2]};
  std::ranges::sort(v);
  return v;
}

/// Live facets of each version whose slot holds another one in the other version.
struct differing_facets {
  std::vector<facet_id> before;
  std::vector<facet_id> after;
};

differing_facets compare_slots(const mesh_version& from, const mesh_version& to) {
  differing_facets result;
  for_each_dirty_slot(from.data().facets, to.data().facets, [&](facet_id f) {
    const bool was = f < from.facet_slots() && from.is_live_facet(f);
    const bool is = f < to.facet_slots() && to.is_live_facet(f);
    if (was && is && from.facet(f).v == to.facet(f).v)
      return;
    if (was)
      result.before.push_back(f);
    if (is)
      result.after.push_back(f);
  });
  return result;
}

}  // namespace

successors::successors(const mesh_version& from, const mesh_version& to) : from_(from), to_(to) {
  const auto differing = compare_slots(from, to);
  // A facet may have come back in another slot.
  std::set<corners> before;
  std::set<corners> after;
  for (const auto f : differing.before)
    before.insert(sorted_corners(from.facet(f)));
  for (const auto f : differing.after)
    after.insert(sorted_corners(to.facet(f)));
  for (const auto f : differing.before)
    if (!after.contains(sorted_corners(from.facet(f)))) {
      gone_.push_back(f);
      grown_[from.facet(f).surface] -= norm(area_vector(from, from.facet(f)));
    }
  for (const auto f : differing.after)
    if (!before.contains(sorted_corners(to.facet(f)))) {
      made_.push_back(f);
      const double area = norm(area_vector(to, to.facet(f)));
      grown_[to.facet(f).surface] += area;
      made_area_[to.facet(f).surface] += area;
    }
}

successors::vertex_marks successors::vertices_of(surface_id removed) const {
  vertex_marks own(from_.vertex_slots());
  for (facet_id f = 0; f < from_.facet_slots(); ++f)
    if (from_.is_live_facet(f) && from_.facet(f).surface == removed)
      for (const auto v : from_.facet(f).v)
        own[v] = true;
  return own;
}

successors::vertex_marks successors::hanging_together(vertex_marks with) const {
  for (bool more = true; more;) {
    more = false;
    for (const auto f : gone_) {
      const auto& v = from_.facet(f).v;
      const auto known = std::ranges::count_if(v, [&](vertex_id i) { return with[i]; });
      if (known == 0 || known == 3)
        continue;
      for (const auto i : v)
        with[i] = true;
      more = true;
    }
  }
  return with;
}

std::map<surface_id, double> successors::touching(const vertex_marks& vertices) const {
  // A slot may hold another vertex now. What is made can touch the border alone: the surface's
  // inner vertices are no longer on the boundary, or it would still be there.
  const auto still_there = [&](vertex_id v) {
    return v < vertices.size() && vertices[v] && from_.position(v) == to_.position(v);
  };
  std::map<surface_id, double> result;
  std::map<surface_id, double> unchanged;
  for (const auto f : made_) {
    const auto id = to_.facet(f).surface;
    if (!std::ranges::any_of(to_.facet(f).v, still_there))
      continue;
    if (const double by = grown_.at(id); by > 1e-9 * made_area_.at(id))
      result[id] = by;
    else
      unchanged[id] = made_area_.at(id);
  }
  return result.empty() ? unchanged : result;
}

std::map<surface_id, double> successors::of(surface_id removed) const {
  const auto own = vertices_of(removed);
  const auto near = touching(own);
  return near.empty() ? touching(hanging_together(own)) : near;
}

}  // namespace tedit::fem
