// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "mesh/vec3.hpp"

namespace tedit::fem {

/// The three numbers of node n.
[[nodiscard]] inline vec3 value_at(std::span<const double> x, std::size_t n) {
  return {x[3 * n], x[3 * n + 1], x[3 * n + 2]};
}

inline void put(vec3 value, std::size_t n, std::span<double> x) {
  x[3 * n] = value.x;
  x[3 * n + 1] = value.y;
  x[3 * n + 2] = value.z;
}

/// S v of a symmetric matrix, upper triangle.
[[nodiscard]] inline vec3 filtered(const std::array<double, 6>& s, vec3 v) {
  return {s[0] * v.x + s[1] * v.y + s[2] * v.z, s[1] * v.x + s[3] * v.y + s[4] * v.z,
          s[2] * v.x + s[4] * v.y + s[5] * v.z};
}

/// What work(n, part) adds for the nodes of each chunk, in order: all cores work, and sums over the
/// parts do not depend on their number.
template <class Part, class Work>
[[nodiscard]] std::vector<Part> parts_of_nodes(std::size_t nodes, const Work& work) {
  std::vector<Part> parts(chunk_count(nodes));
  parallel_for(nodes, [&](std::size_t first, std::size_t last, std::size_t chunk) {
    Part part{};
    for (std::size_t n = first; n < last; ++n)
      work(n, part);
    parts[chunk] = part;
  });
  return parts;
}

}  // namespace tedit::fem
