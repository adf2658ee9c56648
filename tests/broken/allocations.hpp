// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>

namespace tedit::test {

/// The largest piece of memory that one `new` asked for while this lives, whether or not it was
/// written: a count that no file holds shows here at once. 0 where a sanitizer has `new`.
class largest_allocation {
public:
  largest_allocation();
  ~largest_allocation();
  largest_allocation(const largest_allocation&) = delete;
  largest_allocation& operator=(const largest_allocation&) = delete;

  [[nodiscard]] static std::size_t bytes();
};

}  // namespace tedit::test
