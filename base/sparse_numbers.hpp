// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cassert>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

namespace tedit {

/// A number for each of many indices, of which few get one: as quick as an array, but memory is
/// touched only around those. Below 2^32 - 1.
class sparse_numbers {
public:
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  /// All have `none`. Cost: none worth a word, the system gives zeros when they are first read.
  /// Throws `std::bad_alloc`.
  explicit sparse_numbers(std::size_t size)
      : size_(size), above_(static_cast<std::uint32_t*>(std::calloc(size + 1, 4))) {
    if (!above_)
      throw std::bad_alloc();
  }

  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  [[nodiscard]] std::uint32_t operator[](std::size_t i) const noexcept {
    assert(i < size_);
    return above_[i] - 1;
  }

  void set(std::size_t i, std::uint32_t number) noexcept {
    assert(i < size_);
    above_[i] = number + 1;
  }

private:
  struct release {
    void operator()(std::uint32_t* p) const noexcept { std::free(p); }
  };

  std::size_t size_;
  std::unique_ptr<std::uint32_t[], release> above_;  ///< One more than the number; 0: none.
};

}  // namespace tedit
