// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace tedit::fem {

/// The numbers of one row's columns: an open hash table that is emptied at no cost. Sorting all
/// that a row's elements name, or searching all columns of a coarse row, took longer than summing
/// the blocks.
class column_table {
public:
  /// For a row that names at most so many columns.
  void start(std::size_t most) {
    if (2 * most > slots_.size()) {
      slots_.assign(std::bit_ceil(2 * most), {});
      shift_ = 32 - std::bit_width(slots_.size() - 1);
      row_ = 0;
    }
    ++row_;
  }

  /// How many columns the row may name.
  [[nodiscard]] std::size_t most() const { return slots_.size() / 2; }

  /// Where the number of a column stands, and whether that is new: then it is 0.
  [[nodiscard]] std::pair<std::uint32_t*, bool> at(std::uint32_t column) {
    for (std::size_t i = column * 2654435761u >> shift_;; i = (i + 1) % slots_.size()) {
      auto& slot = slots_[i];
      if (slot.row == row_ && slot.column == column)
        return {&slot.number, false};
      if (slot.row == row_)
        continue;
      slot = {row_, column, 0};
      return {&slot.number, true};
    }
  }

private:
  struct entry {
    std::uint32_t row = 0, column = 0, number = 0;
  };
  std::vector<entry> slots_ = std::vector<entry>(256);
  int shift_ = 24;
  std::uint32_t row_ = 1;  ///< Entries of other rows are free places.
};

}  // namespace tedit::fem
