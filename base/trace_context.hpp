// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>

namespace tedit::tracing {

/// A span that others may be part of (tracing/tracing.hpp).
struct context {
  std::array<unsigned char, 16> trace{};
  std::array<unsigned char, 8> span{};

  /// All zeros stand for none.
  [[nodiscard]] bool is_there() const { return trace != std::array<unsigned char, 16>{}; }

  friend bool operator==(const context&, const context&) = default;
};

}  // namespace tedit::tracing
