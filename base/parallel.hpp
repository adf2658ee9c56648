// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace tedit {

/// Work is cut into chunks of this many items, whatever the number of threads, so that sums over
/// chunks give the same bits everywhere.
inline constexpr std::size_t parallel_chunk = 2048;

[[nodiscard]] constexpr std::size_t chunk_count(std::size_t items) {
  return (items + parallel_chunk - 1) / parallel_chunk;
}

/// Calls `work(first, last, chunk)` for every chunk of [0, items) on all cores and waits. Idle
/// threads look out for the next loop for 50 us, then they block. Calls from several threads at
/// once are served one after the other; a call from inside `work` runs inline. `chunk_items` is for
/// items that cost much more than a row of a matrix. What `work` throws ends the loop and is thrown
/// again here: only std::bad_alloc and a cancel that the `cancel_scope` of the caller noticed
/// (guard.hpp), please.
void parallel_for(
  std::size_t items,
  const std::function<void(std::size_t first, std::size_t last, std::size_t chunk)>& work,
  std::size_t chunk_items = parallel_chunk);

/// The sum of `term(first, last)` over all chunks, added in chunk order.
[[nodiscard]] double parallel_sum(
  std::size_t items, const std::function<double(std::size_t first, std::size_t last)>& term);

}  // namespace tedit
