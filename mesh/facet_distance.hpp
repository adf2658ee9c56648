// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/box_tree.hpp"

namespace tedit {

/// How far points are from a set of triangles.
class facet_distance {
public:
  /// Cost: O(n log n).
  explicit facet_distance(std::vector<std::array<vec3, 3>> triangles);

  [[nodiscard]] box extent() const { return tree_.extent(); }

  /// m: the distance of the nearest triangle, or `at_most` where none is nearer. Cost: O(log n +
  /// triangles about as far as the nearest).
  [[nodiscard]] double operator()(vec3 p, double at_most) const;

  /// Is one nearer than `distance` (m)? Cost: less, as any will do.
  [[nodiscard]] bool is_within(vec3 p, double distance) const;

private:
  /// Around a triangle.
  struct ball {
    vec3 centre;
    double radius = 0;
  };

  [[nodiscard]] bool further(std::size_t i, vec3 p, double than) const;

  std::vector<std::array<vec3, 3>> triangles_;
  std::vector<ball> balls_;
  box_tree tree_;
};

}  // namespace tedit
