// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace tedit::fem {

/// Where the rows of a sparse structure lie in its arrays. Rows are contiguous at first; one that
/// is replaced stays in its place when it fits, else moves to the end, so that a local change costs
/// what it touches. What moved leaves a hole; `crowded` says when to build anew.
class row_places {
public:
  row_places() = default;

  /// Rows of these lengths, one after the other.
  explicit row_places(std::span<const std::uint32_t> lengths) {
    first_.reserve(lengths.size());
    last_.reserve(lengths.size());
    for (const auto length : lengths)
      add(length);
  }

  [[nodiscard]] std::size_t size() const { return first_.size(); }
  [[nodiscard]] std::uint32_t begin(std::size_t row) const { return first_[row]; }
  [[nodiscard]] std::uint32_t end(std::size_t row) const { return last_[row]; }
  [[nodiscard]] std::uint32_t length(std::size_t row) const { return last_[row] - first_[row]; }

  /// The items of a row in one of the structure's arrays.
  template <class T>
  [[nodiscard]] auto of(std::size_t row, T& items) const {
    return std::span(items).subspan(first_[row], last_[row] - first_[row]);
  }

  /// Where each row starts, and where the last one ends: as long as no row was replaced.
  [[nodiscard]] std::vector<std::uint32_t> starts() const {
    auto result = first_;
    result.push_back(room_);
    return result;
  }

  /// Length that the structure's arrays need.
  [[nodiscard]] std::uint32_t room() const { return room_; }

  /// Adds a row at the end; returns its place.
  std::uint32_t add(std::uint32_t length) {
    first_.push_back(room_);
    room_ += length;
    last_.push_back(room_);
    return first_.back();
  }

  /// Gives a row another length; its items are lost. Returns its place.
  std::uint32_t replace(std::size_t row, std::uint32_t length) {
    const auto old = last_[row] - first_[row];
    if (length > old) {
      lost_ += old;
      first_[row] = room_;
      room_ += length;
    } else {
      lost_ += old - length;
    }
    last_[row] = first_[row] + length;
    return first_[row];
  }

  [[nodiscard]] bool crowded() const { return lost_ > 65536 && lost_ > room_ / 4; }
  [[nodiscard]] std::uint64_t bytes() const { return 8 * first_.size(); }

private:
  std::vector<std::uint32_t> first_, last_;
  std::uint32_t room_ = 0;
  std::uint32_t lost_ = 0;
};

/// Ascending, each once.
inline void sort_unique(std::vector<std::uint32_t>& list) {
  std::ranges::sort(list);
  list.erase(std::ranges::unique(list).begin(), list.end());
}

/// Address space for rows that will be replaced: a vector that grows copies itself, and then a
/// small edit would cost as much as a pass over the whole. Untouched memory costs nothing.
template <class T, class Allocator>
void reserve_for_edits(std::vector<T, Allocator>& items, std::size_t size) {
  items.reserve(size + size / 16 + 1024);
}

}  // namespace tedit::fem
