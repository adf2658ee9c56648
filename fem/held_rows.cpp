// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/held_rows.hpp"

#include <cmath>

namespace tedit::fem {

namespace {

using matrix_row = std::array<double, 4>;

/// Makes column k a unit vector with its one in row k.
void eliminate(std::array<matrix_row, 3>& rows, int k) {
  const double pivot = rows[k][k];
  for (auto& entry : rows[k])
    entry /= pivot;
  for (int i = 0; i < 3; ++i) {
    const double factor = rows[i][k];
    for (int j = 0; i != k && j < 4; ++j)
      rows[i][j] -= factor * rows[k][j];
  }
}

}  // namespace

std::vector<held_row> held_rows(const problem& p, std::size_t node) {
  const auto& s = p.filter[node];
  const auto* z = &p.prescribed[3 * node];
  std::array<matrix_row, 3> rows{{{1 - s[0], -s[1], -s[2], z[0]},
                                  {-s[1], 1 - s[3], -s[4], z[1]},
                                  {-s[2], -s[4], 1 - s[5], z[2]}}};
  const auto rank = std::lround(3 - s[0] - s[3] - s[5]);
  std::array<bool, 3> used{};
  for (long step = 0; step < rank; ++step) {
    int pivot = -1;
    for (int k = 0; k < 3; ++k)
      if (!used[k] && (pivot < 0 || rows[k][k] > rows[pivot][pivot]))
        pivot = k;
    used[pivot] = true;
    eliminate(rows, pivot);
  }
  std::vector<held_row> result;
  for (int k = 0; k < 3; ++k) {
    if (!used[k])
      continue;
    held_row row{k, {}, rows[k][3]};
    // Below this a factor is the rounding of a normal along an axis.
    for (int j = 0; j < 3; ++j)
      if (!used[j] && std::abs(rows[k][j]) > 1e-12)
        row.factor[j] = rows[k][j];
    result.push_back(row);
  }
  return result;
}

}  // namespace tedit::fem
