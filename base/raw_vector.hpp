// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace tedit {

/// Leaves new items of plain types as the memory is, where `std::allocator` writes zeros: they are
/// written once, and on the core that fills them, not first on the one that made room.
template <class T>
class raw_allocator : public std::allocator<T> {
public:
  template <class U>
  struct rebind {
    using other = raw_allocator<U>;
  };

  raw_allocator() = default;
  template <class U>
  raw_allocator(const raw_allocator<U>&) noexcept {}

  template <class U>
  void construct(U* at) {
    ::new (static_cast<void*>(at)) U;
  }
  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    std::construct_at(at, std::forward<Arguments>(arguments)...);
  }
};

/// A vector for large arrays that are filled right after `resize`. Items that nobody wrote have no
/// value: they must not be read for what they say.
template <class T>
using raw_vector = std::vector<T, raw_allocator<T>>;

}  // namespace tedit
