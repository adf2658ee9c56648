// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "fem/block_matrix.hpp"

namespace tedit::fem {

/// a.b, summed in double precision in a fixed order.
[[nodiscard]] double dot_of(const std::vector<float>& a, const std::vector<float>& b);

/// z += x, n values.
void add_to(const float* x, float* z, std::size_t n);

}  // namespace tedit::fem
