// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace tedit {

/// Erases the entries at `places` (ascending, each once); places beyond the end are passed over.
/// Cost: one pass, whatever the number of places.
template <class T, class Index>
void erase_places(std::vector<T>& column, const std::vector<Index>& places) {
  std::size_t kept = 0;
  auto place = places.begin();
  for (std::size_t i = 0; i < column.size(); ++i) {
    if (place != places.end() && *place == i)
      ++place;
    else
      column[kept++] = column[i];
  }
  column.resize(kept);
}

}  // namespace tedit
