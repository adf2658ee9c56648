// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "mesh/version.hpp"

namespace tedit {

/// The slots in use, as files number them without holes.
struct compaction {
  std::vector<std::uint32_t> slots;  ///< Of each item of the file, in the file's order.
  std::vector<std::uint32_t> index;  ///< Item (0-based) of each slot, `no_id` when it is left out.
};

/// The slots by their places in `order`, each below `order.size()`; equal ones stay as they are.
/// Cost: O(n).
inline void put_in_order(std::vector<std::uint32_t>& slots,
                         const paged_array<std::uint32_t>& order) {
  std::vector<std::uint32_t> place(slots.size());
  std::vector<std::uint32_t> first(order.size() + 1);  // Where those of each place begin.
  for (std::size_t i = 0; i < slots.size(); ++i) {
    place[i] = order[slots[i]];
    ++first[place[i] + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> sorted(slots.size());
  for (std::size_t i = 0; i < slots.size(); ++i)
    sorted[first[place[i]]++] = slots[i];
  slots = std::move(sorted);
}

/// Those of `slots` slots for which `is_wanted` says so, in the order that `order` gives them
/// (mesh_data), ascending where that is empty. Cost: O(n).
template <class IsWanted>
[[nodiscard]] compaction compact(std::uint32_t slots, const paged_array<std::uint32_t>& order,
                                 const IsWanted& is_wanted) {
  compaction result;
  result.slots.reserve(slots);
  for (std::uint32_t s = 0; s < slots; ++s)
    if (is_wanted(s))
      result.slots.push_back(s);
  if (order.size() == slots)
    put_in_order(result.slots, order);
  result.index.assign(slots, no_id);
  for (std::size_t i = 0; i < result.slots.size(); ++i)
    result.index[result.slots[i]] = static_cast<std::uint32_t>(i);
  return result;
}

/// The vertices of a mesh, as files number them.
[[nodiscard]] inline compaction vertices_of_file(const mesh_version& mesh) {
  return compact(mesh.vertex_slots(), mesh.data().vertex_order,
                 [&](vertex_id v) { return mesh.is_live_vertex(v); });
}

/// The tets of a mesh, as files number them.
[[nodiscard]] inline compaction tets_of_file(const mesh_version& mesh) {
  return compact(mesh.tet_slots(), mesh.data().tet_order,
                 [&](tet_id t) { return mesh.is_live_tet(t); });
}

}  // namespace tedit
