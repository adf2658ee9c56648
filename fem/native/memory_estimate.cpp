// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/memory_estimate.hpp"

namespace tedit::fem::native {

std::uint64_t solve_bytes(const problem& p) {
  const std::uint64_t elements = p.element_count();
  const std::uint64_t nodes = p.node_count();
  return p.element_order == 1 ? 140 * elements + 860 * nodes : 170 * elements + 630 * nodes;
}

}  // namespace tedit::fem::native
