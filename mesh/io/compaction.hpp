// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/types.hpp"

namespace tedit {

/// The slots in use, as files number them without holes.
struct compaction {
  std::vector<std::uint32_t> slots;  ///< Of each item of the file, ascending.
  std::vector<std::uint32_t> index;  ///< Item (0-based) of each slot, `no_id` when it is left out.
};

/// Those of `slots` slots for which `is_wanted` says so.
template <class IsWanted>
[[nodiscard]] compaction compact(std::uint32_t slots, const IsWanted& is_wanted) {
  compaction result;
  result.index.assign(slots, no_id);
  for (std::uint32_t s = 0; s < slots; ++s)
    if (is_wanted(s)) {
      result.index[s] = static_cast<std::uint32_t>(result.slots.size());
      result.slots.push_back(s);
    }
  return result;
}

}  // namespace tedit
