// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <bit>
#include <cassert>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "mesh/page.hpp"

namespace tedit {

/// An immutable array in pages. Copies share pages; a random access is two indexings.
/// `T` is plain data without padding, so that equal content has equal bytes and hashes.
template <class T>
class paged_array {
  static_assert(std::is_trivially_copyable_v<T>);

public:
  /// A power of two, so that an index splits by shift and mask.
  static constexpr std::size_t items_per_page = std::bit_floor(max_page_bytes / sizeof(T));
  static constexpr std::size_t shift = std::countr_zero(items_per_page);
  static constexpr std::size_t mask = items_per_page - 1;

  paged_array() = default;

  /// Copies `items` into fresh pages. Cost: O(n).
  [[nodiscard]] static paged_array from(std::span<const T> items) {
    paged_array result;
    result.size_ = items.size();
    for (std::size_t first = 0; first < items.size(); first += items_per_page) {
      const auto part = items.subspan(first, std::min(items_per_page, items.size() - first));
      result.pages_.push_back(page::from_bytes(std::as_bytes(part)));
    }
    result.find_items();
    return result;
  }

  /// Puts an array together from pages that came over the wire or from storage.
  /// Errors: `invalid_mesh` when the page sizes do not add up to `size` items.
  [[nodiscard]] static expected<paged_array> from_pages(std::vector<page_ptr> pages,
                                                        std::size_t size) {
    if (pages.size() != (size + items_per_page - 1) / items_per_page)
      return fail(ec::invalid_mesh, "an array's page count does not match its length");
    for (std::size_t p = 0; p < pages.size(); ++p) {
      const std::size_t items = std::min(items_per_page, size - p * items_per_page);
      if (!pages[p] || pages[p]->bytes().size() != items * sizeof(T))
        return fail(ec::invalid_mesh, "an array's page has the wrong size");
    }
    paged_array result;
    result.size_ = size;
    result.pages_ = std::move(pages);
    result.find_items();
    return result;
  }

  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  [[nodiscard]] const T& operator[](std::size_t i) const noexcept {
    assert(i < size_);
    return items_[i >> shift][i & mask];
  }

  /// The items of one page, contiguous.
  [[nodiscard]] std::span<const T> page_items(std::size_t p) const noexcept {
    return {items_[p], pages_[p]->bytes().size() / sizeof(T)};
  }

  [[nodiscard]] const std::vector<page_ptr>& pages() const noexcept { return pages_; }

  [[nodiscard]] std::vector<T> to_vector() const {
    std::vector<T> result;
    result.reserve(size_);
    for (std::size_t p = 0; p < pages_.size(); ++p) {
      const auto part = page_items(p);
      result.insert(result.end(), part.begin(), part.end());
    }
    return result;
  }

private:
  void find_items() {
    items_.reserve(pages_.size());
    for (const auto& p : pages_)
      items_.push_back(reinterpret_cast<const T*>(p->bytes().data()));
  }

  std::vector<page_ptr> pages_;
  std::vector<const T*> items_;  ///< Where each page begins: one load less at each access.
  std::size_t size_ = 0;
};

/// Write access to a paged array: pages are copied when first written, the others stay shared.
template <class T>
class paged_array_builder {
  using array = paged_array<T>;

public:
  paged_array_builder() = default;

  explicit paged_array_builder(const array& base) : size_(base.size()) {
    for (const auto& p : base.pages()) {
      pages_.push_back({reinterpret_cast<const T*>(p->bytes().data()), p, nullptr});
    }
  }

  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  [[nodiscard]] const T& operator[](std::size_t i) const noexcept {
    assert(i < size_);
    return pages_[i >> array::shift].items[i & array::mask];
  }

  /// A reference that is valid until the next call of a non-const member.
  [[nodiscard]] T& write(std::size_t i) {
    assert(i < size_);
    return own(i >> array::shift)[i & array::mask];
  }

  std::size_t push_back(const T& value) {
    const std::size_t i = size_++;
    if ((i >> array::shift) == pages_.size()) {
      auto fresh = std::make_shared<page>(array::items_per_page * sizeof(T));
      pages_.push_back({reinterpret_cast<const T*>(fresh->bytes().data()), nullptr, fresh});
    }
    own(i >> array::shift)[i & array::mask] = value;
    return i;
  }

  /// The array as it now is. The builder stays usable: pages are shared with the result and
  /// copied again on the next write. Cost: O(pages) and a copy of the last page.
  [[nodiscard]] array freeze() {
    std::vector<page_ptr> frozen;
    for (std::size_t p = 0; p < pages_.size(); ++p) {
      auto& entry = pages_[p];
      const std::size_t used =
        std::min(array::items_per_page, size_ - p * array::items_per_page) * sizeof(T);
      if (entry.owned) {
        entry.shared = entry.owned->bytes().size() == used
                         ? entry.owned
                         : page::from_bytes(entry.owned->bytes().first(used));
        entry.owned = nullptr;
        entry.items = reinterpret_cast<const T*>(entry.shared->bytes().data());
      }
      frozen.push_back(entry.shared);
    }
    return *array::from_pages(std::move(frozen), size_);
  }

private:
  struct page_slot {
    const T* items;
    page_ptr shared;
    std::shared_ptr<page> owned;
  };

  T* own(std::size_t p) {
    auto& e = pages_[p];
    if (!e.owned) {
      e.owned = std::make_shared<page>(e.shared->bytes(), array::items_per_page * sizeof(T));
      e.shared = nullptr;
      e.items = reinterpret_cast<const T*>(e.owned->bytes().data());
    }
    return reinterpret_cast<T*>(e.owned->mutable_bytes().data());
  }

  std::vector<page_slot> pages_;
  std::size_t size_ = 0;
};

}  // namespace tedit
