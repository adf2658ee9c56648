// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/vectors.hpp"

namespace tedit::fem::native {

double dot_of(const std::vector<float>& a, const std::vector<float>& b) {
  return dots_of<one_case>(a, b)[0];
}

void add_to(const float* x, float* z, std::size_t n) {
  parallel_for(n, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i)
      z[i] += x[i];
  });
}

}  // namespace tedit::fem::native
