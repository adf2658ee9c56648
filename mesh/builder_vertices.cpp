// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <functional>

#include "mesh/builder.hpp"

namespace tedit {

void mesh_builder::repair_vertices(const std::vector<vertex_id>& suspects,
                                   std::span<const tet_id> candidates) {
  std::unordered_set<vertex_id> open(suspects.begin(), suspects.end());
  const auto claim = [&](tet_id t) {
    for (const auto v : tets_[t].v) {
      if (open.erase(v) || loose_vertices_.erase(v))
        vertex_tet_.write(v) = t;
    }
  };
  for (const auto t : candidates)
    claim(t);
  if (open.empty())
    return;
  if (tets_at_.empty())
    count_all_tets();
  std::vector<vertex_id> dead;
  for (const auto v : open)
    if (tets_at_[v] == 0)
      dead.push_back(v);
  for (const auto v : dead)
    open.erase(v);
  // A vertex whose fan is gone lives on in another fan that only touches it there: rare, so a scan
  // is allowed.
  for (tet_id t = 0; t < tets_.size() && !open.empty(); ++t)
    if (is_live_tet(t))
      claim(t);
  std::ranges::sort(dead, std::greater{});
  for (const auto v : dead)
    free_vertex_slot(v);
}

void mesh_builder::count_tets(const tet& corners, int change) {
  for (const auto v : corners.v) {
    if (v >= tets_at_.size())
      tets_at_.resize(vertex_slots(), 0);
    tets_at_[v] += static_cast<std::uint32_t>(change);
  }
}

void mesh_builder::count_all_tets() {
  tets_at_.assign(vertex_slots(), 0);
  for (tet_id t = 0; t < tets_.size(); ++t)
    if (is_live_tet(t))
      for (const auto v : tets_[t].v)
        ++tets_at_[v];
}

}  // namespace tedit
