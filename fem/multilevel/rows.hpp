// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/hierarchy.hpp"

/// The entries of one row, for kernels that know nothing of how rows are stored.
namespace tedit::fem {

/// Calls visit(column, block) for the entries of row i, the diagonal included.
template <class Visit>
[[gnu::always_inline]] inline void for_blocks(const rigid_level& level, std::size_t i,
                                              const Visit& visit) {
  for (auto s = level.rows.begin(i), end = level.rows.end(i); s < end; ++s)
    visit(std::size_t{level.column[s]}, level.block[s]);
}

/// Calls visit(parent, block) for the entries of row i of the prolongation to the next level.
template <class Visit>
[[gnu::always_inline]] inline void for_parents(const rigid_level& level, std::size_t i,
                                               const Visit& visit) {
  for (auto s = level.prolongation_rows.begin(i), end = level.prolongation_rows.end(i); s < end;
       ++s)
    visit(std::size_t{level.prolongation_column[s]}, level.prolongation[s]);
}

/// Calls visit(child, block) for the entries of that prolongation in column `parent`.
template <class Visit>
[[gnu::always_inline]] inline void for_children(const rigid_level& level, std::size_t parent,
                                                const Visit& visit) {
  for (const auto entry : level.entries.of(parent))
    visit(std::size_t{level.entry_row[entry]}, level.prolongation[entry]);
}

}  // namespace tedit::fem
