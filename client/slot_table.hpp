// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace tedit::client {

/// Values by 32-bit slot in immutable pages: a copy costs one pointer per 1024 slots and shares the
/// values, a change copies the pages that it touches.
template <class T>
class slot_table {
  static constexpr std::uint32_t page_size = 1024;

  struct page {
    std::array<T, page_size> values{};
    std::bitset<page_size> held;
  };

public:
  /// Slots that hold a value.
  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  /// The value in a slot, or null. Valid while this table or a copy of it lives unchanged.
  [[nodiscard]] const T* find(std::uint32_t slot) const noexcept {
    const auto number = slot / page_size;
    if (number >= pages_.size() || !pages_[number] || !pages_[number]->held[slot % page_size])
      return nullptr;
    return &pages_[number]->values[slot % page_size];
  }

  /// Calls `visit(slot, value)` in ascending order of slots.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::uint32_t number = 0; number < pages_.size(); ++number)
      for (std::uint32_t i = 0; pages_[number] && i < page_size; ++i)
        if (pages_[number]->held[i])
          visit(number * page_size + i, pages_[number]->values[i]);
  }

  /// One change of a table: every page that it touches is copied once, so that earlier copies of
  /// the table keep their values.
  class editor {
  public:
    explicit editor(slot_table& table) : table_(table) {}

    void set(std::uint32_t slot, const T& value) {
      page& p = own(slot / page_size);
      table_.size_ += p.held[slot % page_size] ? 0 : 1;
      p.held.set(slot % page_size);
      p.values[slot % page_size] = value;
    }

    /// Empties a slot; nothing happens when it is empty.
    void erase(std::uint32_t slot) {
      if (!table_.find(slot))
        return;
      page& p = own(slot / page_size);
      p.held.reset(slot % page_size);
      p.values[slot % page_size] = T{};
      --table_.size_;
    }

  private:
    page& own(std::uint32_t number) {
      if (number >= table_.pages_.size())
        table_.pages_.resize(number + 1);
      if (number >= owned_.size())
        owned_.resize(number + 1, nullptr);
      if (!owned_[number]) {
        const auto& before = table_.pages_[number];
        auto copy = before ? std::make_shared<page>(*before) : std::make_shared<page>();
        owned_[number] = copy.get();
        table_.pages_[number] = std::move(copy);
      }
      return *owned_[number];
    }

    slot_table& table_;
    std::vector<page*> owned_;  ///< Pages that only this change has seen, by number.
  };

private:
  std::vector<std::shared_ptr<const page>> pages_;
  std::size_t size_ = 0;
};

}  // namespace tedit::client
