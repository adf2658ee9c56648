// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>

#include "fem/element_operator.hpp"

namespace tedit::test {

/// |S (f - K d)| / |S f| in double precision, for constraints that prescribe nothing but zero.
inline double residual_share(const fem::problem& p, const std::vector<double>& d) {
  std::vector<double> kd(d.size());
  fem::element_operator(p).apply(d, kd);
  double left = 0;
  double all = 0;
  for (std::size_t n = 0; n < p.node_count(); ++n) {
    const auto& s = p.filter[n];
    const auto square_of_free = [&](const auto& x) {
      const double a = x(3 * n), b = x(3 * n + 1), c = x(3 * n + 2);
      return std::pow(s[0] * a + s[1] * b + s[2] * c, 2) +
             std::pow(s[1] * a + s[3] * b + s[4] * c, 2) +
             std::pow(s[2] * a + s[4] * b + s[5] * c, 2);
    };
    left += square_of_free([&](std::size_t i) { return p.loads[i] - kd[i]; });
    all += square_of_free([&](std::size_t i) { return p.loads[i]; });
  }
  return std::sqrt(left / all);
}

}  // namespace tedit::test
