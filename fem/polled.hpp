// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/guard.hpp"
#include "base/parallel.hpp"
#include "fem/rows.hpp"

namespace tedit::fem {

/// Calls `work(i)` for every i of [0, items) on this thread, in order, and asks `check_cancelled`
/// now and then: for loops over a mesh that have an order to keep. `between`: so many items take
/// less than 10 ms.
template <class Work>
void polled_for(std::size_t items, const Work& work, std::size_t between = 16384) {
  for (std::size_t first = 0; first < items;) {
    check_cancelled();
    const std::size_t last = std::min(items, first + between);
    for (; first < last; ++first)
      work(first);
  }
}

/// Gives the vector another size, in pieces: memory that was never touched comes from the system
/// page by page, 100 MB in 50 ms and more.
template <class T, class Allocator>
void polled_resize(std::vector<T, Allocator>& items, std::size_t size) {
  constexpr std::size_t piece = (std::size_t{4} << 20) / sizeof(T);
  if (items.empty())
    reserve_for_edits(items, size);
  do {
    check_cancelled();
    items.resize(std::min(size, items.size() + piece));
  } while (items.size() < size);
}

/// So many items of one value, in pieces.
template <class T>
void polled_assign(std::vector<T>& items, std::size_t size, const T& value) {
  constexpr std::size_t piece = (std::size_t{4} << 20) / sizeof(T);
  items.clear();
  if (items.capacity() < size)
    reserve_for_edits(items, size);
  while (items.size() < size) {
    check_cancelled();
    items.resize(std::min(size, items.size() + piece), value);
  }
}

/// Sorts as `std::ranges::sort` does; equal items in any order. Pieces are sorted, on all cores,
/// then merged.
template <class T, class Less>
void polled_sort(std::vector<T>& items, const Less& less) {
  constexpr std::size_t piece = 16384;
  const auto at = [&](std::size_t i) {
    return items.begin() + static_cast<std::ptrdiff_t>(std::min(i, items.size()));
  };
  parallel_for(
    items.size(),
    [&](std::size_t first, std::size_t last, std::size_t) { std::sort(at(first), at(last), less); },
    piece);
  for (std::size_t width = piece; width < items.size(); width *= 2)
    for (std::size_t first = 0; first + width < items.size(); first += 2 * width) {
      check_cancelled();
      std::inplace_merge(at(first), at(first + width), at(first + 2 * width), less);
    }
}

}  // namespace tedit::fem
