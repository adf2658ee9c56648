// SPDX-License-Identifier: AGPL-3.0-or-later
// Which versions a document may go without.
#pragma once

#include <cstdint>
#include <vector>

#include "actors/store/document.hpp"

namespace tedit::actors {

/// What is to be cleaned out of a document.
struct cleaning {
  /// Versions on branches that no undo or redo reaches go, unless they have a name or a note.
  bool unreachable = false;
  std::vector<std::uint32_t> keep;  ///< These stay all the same.
};

/// Versions that a cleaning takes out, by the numbers that they had.
struct cleaning_plan {
  store::removal what;
  std::vector<std::uint32_t> dropped;  ///< Ascending.
};

/// With each version that stays, the one that it was made from stays, up to its import. Versions
/// get new numbers where one before them goes; so do the lines of the log that name them, and a
/// change whose version goes is not made again by who asks for it again.
/// @param rows of a sound document.
/// Errors: `not_found` for a number to keep that no version has. Cost: O(rows).
[[nodiscard]] expected<cleaning_plan> plan_cleaning(const store::contents& rows,
                                                    const cleaning& wanted);

}  // namespace tedit::actors
