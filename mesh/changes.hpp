// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "mesh/paged_array.hpp"

/// What differs between two versions, array by array:
/// `for_each_dirty_slot(before.data().tets, after.data().tets, ...)`.
namespace tedit {

/// The pages of an array that may differ between two versions, ascending: those of equal identity
/// are skipped. Cost: O(pages).
template <class T>
[[nodiscard]] std::vector<std::size_t> dirty_pages(const paged_array<T>& before,
                                                   const paged_array<T>& after) {
  const auto& was = before.pages();
  const auto& is = after.pages();
  std::vector<std::size_t> result;
  for (std::size_t p = 0; p < std::max(was.size(), is.size()); ++p)
    if (p >= was.size() || p >= is.size() || (was[p] != is[p] && was[p]->id() != is[p]->id()))
      result.push_back(p);
  return result;
}

/// Calls `visit(slot)` for each slot of those pages that one of the versions has, ascending. Cost:
/// O(pages) and that of the slots of changed pages.
template <class T, class Visit>
void for_each_dirty_slot(const paged_array<T>& before, const paged_array<T>& after,
                         const Visit& visit) {
  constexpr auto per_page = paged_array<T>::items_per_page;
  const auto slots = std::max<std::size_t>(before.size(), after.size());
  for (const auto p : dirty_pages(before, after))
    for (std::size_t slot = p * per_page; slot < std::min(slots, (p + 1) * per_page); ++slot)
      visit(static_cast<std::uint32_t>(slot));
}

}  // namespace tedit
