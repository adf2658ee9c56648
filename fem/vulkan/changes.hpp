// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "fem/rows.hpp"
#include "fem/vulkan/memory.hpp"

namespace tedit::fem::vulkan {

/// What an edit changes in device buffers: gathered on the host, then sent in one submission. A
/// piece must not be noted twice.
class device_changes {
public:
  /// The items of `to` from number `at` on become `values`.
  template <class T>
  void put(const gpu::buffer& to, std::uint64_t at, const std::vector<T>& values) {
    note(to, at * sizeof(T), std::as_bytes(std::span(values)));
  }

  /// Item i becomes `item(i)` for each of `dirty`, ascending. What lies between two near ones is
  /// sent with them: fewer pieces are worth some bytes.
  template <class Item>
  void items(const gpu::buffer& to, std::span<const std::uint32_t> dirty, const Item& item) {
    using T = std::invoke_result_t<Item, std::uint32_t>;
    constexpr std::uint32_t near = most_between / sizeof(T);
    std::vector<T> run;
    for (std::size_t at = 0; at < dirty.size();) {
      const auto first = dirty[at];
      run.clear();
      for (auto end = first; at < dirty.size() && dirty[at] - end <= near; ++at)
        for (; end <= dirty[at]; ++end)
          run.push_back(item(end));
      put(to, first, run);
    }
  }

  /// Something has outgrown its buffer: nothing may be sent.
  void refuse() { fits_ = false; }
  [[nodiscard]] bool fits() const { return fits_; }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_.size(); }

  /// Errors: those of the device.
  [[nodiscard]] expected<void> send(const std::shared_ptr<gpu::kernel_layout>& layout);

private:
  static constexpr std::size_t most_between = 256;  ///< Bytes.

  void note(const gpu::buffer& to, std::uint64_t offset, std::span<const std::byte> bytes);

  std::vector<gpu::patch> patches_;
  std::vector<std::byte> bytes_;
  bool fits_ = true;
};

/// Where rows of items lie in device arrays that have some room more: a row that grows moves to the
/// end, and when the end is reached all rows are placed anew.
class roomy_places {
public:
  roomy_places() = default;
  /// The arrays get room for one `share`th more items and a few, at most `most` in all unless the
  /// rows need more.
  roomy_places(std::span<const std::uint32_t> lengths, std::uint32_t share, std::uint64_t most);

  [[nodiscard]] std::uint32_t rows() const { return static_cast<std::uint32_t>(places_.size()); }
  [[nodiscard]] std::uint32_t begin(std::size_t row) const { return places_.begin(row); }
  [[nodiscard]] std::uint32_t end(std::size_t row) const { return places_.end(row); }
  /// Items up to the end of the last row.
  [[nodiscard]] std::uint32_t used() const { return places_.room(); }
  /// Items that the arrays have room for.
  [[nodiscard]] std::uint64_t room() const { return room_; }

  /// Gives `rows` (ascending) the lengths `length(row)`, and makes it `count` rows; returns those
  /// whose items are to be written, ascending. Refuses when they do not fit in any order.
  template <class Length>
  std::vector<std::uint32_t> update(std::span<const std::uint32_t> rows, std::uint32_t count,
                                    const Length& length, device_changes& changes) {
    std::vector<std::uint32_t> dirty(rows.begin(), rows.end());
    for (auto row = this->rows(); row < count; ++row) {
      places_.add(0);
      dirty.push_back(row);
    }
    sort_unique(dirty);
    for (const auto row : dirty)
      places_.replace(row, length(row));
    if (places_.room() <= room_)
      return dirty;
    std::vector<std::uint32_t> lengths(count);
    dirty.resize(count);
    for (std::uint32_t row = 0; row < count; ++row) {
      lengths[row] = length(row);
      dirty[row] = row;
    }
    places_ = row_places(lengths);
    if (places_.room() > room_)
      changes.refuse();
    return dirty;
  }

private:
  row_places places_;
  std::uint64_t room_ = 0;
};

/// The same with a table on the device that has first and last item of each row.
class row_table {
public:
  row_table() = default;
  row_table(device_memory& memory, std::span<const std::uint32_t> lengths, std::uint32_t share,
            std::uint64_t most);

  [[nodiscard]] const gpu::buffer& table() const { return table_; }
  [[nodiscard]] const roomy_places& places() const { return places_; }

  template <class Length>
  std::vector<std::uint32_t> update(std::span<const std::uint32_t> rows, std::uint32_t count,
                                    const Length& length, device_changes& changes) {
    auto dirty = places_.update(rows, count, length, changes);
    changes.items(table_, dirty, [this](std::uint32_t row) { return pair_of(row); });
    return dirty;
  }

private:
  [[nodiscard]] std::array<std::uint32_t, 2> pair_of(std::uint32_t row) const {
    return {places_.begin(row), places_.end(row)};
  }

  roomy_places places_;
  gpu::buffer table_;
};

/// A list of numbers for each row, on the device.
class row_lists {
public:
  /// Appends the numbers of a row to `list`.
  using source = std::function<void(std::uint32_t row, std::vector<std::uint32_t>& list)>;

  row_lists() = default;
  row_lists(device_memory& memory, std::uint32_t rows, const source& from);

  [[nodiscard]] const gpu::buffer& table() const { return rows_.table(); }
  [[nodiscard]] const gpu::buffer& items() const { return items_; }

  /// `rows` (ascending) changed, and there are `count` now.
  void update(std::span<const std::uint32_t> rows, std::uint32_t count, const source& from,
              device_changes& changes);

private:
  row_table rows_;
  gpu::buffer items_;
};

}  // namespace tedit::fem::vulkan
