// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/surface_foot.hpp"

namespace tedit {

/// A rational B-spline surface over two parameters, as CAD models have for free form. Not periodic.
struct spline_surface {
  std::array<std::uint32_t, 2> degree{};     ///< 1 to `most_degree`.
  std::array<std::vector<double>, 2> knots;  ///< Each as often as it counts, ascending.
  std::vector<vec3> poles;                   ///< m: all of the second parameter, row by row.
  std::vector<double> weights;               ///< Above 0, one a pole; none: all are 1.

  static constexpr std::uint32_t most_degree = 25;
  static constexpr std::size_t most_poles = 4096;

  /// How many poles a parameter has.
  [[nodiscard]] std::size_t count(int direction) const {
    return knots[direction].size() - degree[direction] - 1;
  }

  struct point {
    vec3 at;
    vec3 along_u;  ///< Derivatives.
    vec3 along_v;
  };
  /// Parameters beyond the knots are taken at their ends. Cost: O(degree^2).
  [[nodiscard]] point operator()(double u, double v) const;

  friend bool operator==(const spline_surface&, const spline_surface&) = default;
};

/// Do its sizes fit together, and is each number finite and where it can be? For what comes from
/// outside: nothing else may be asked of one that is not.
[[nodiscard]] bool is_possible(const spline_surface& surface);

/// Finds the point of a spline's surface that is nearest to others: from the nearest of a grid of
/// its points, by Gauss and Newton's method on the two parameters.
class spline_projection final : public surface_projection {
public:
  /// Cost: O(poles) points.
  explicit spline_projection(const spline_surface& surface);

  /// Its normal is by the right hand of the two parameters. The same for the same point, to
  /// rounding. Cost: some microseconds.
  [[nodiscard]] surface_foot operator()(vec3 p) const override;

  /// m: the least radius of curvature that the grid shows, at most the surface's extent.
  [[nodiscard]] double least_radius() const { return least_radius_; }
  /// The same.
  [[nodiscard]] double radius_at(vec3) const override { return least_radius_; }

private:
  struct sample {
    vec3 at;
    double u = 0;
    double v = 0;
  };

  spline_surface surface_;
  std::vector<sample> grid_;
  double least_radius_ = 0;
};

}  // namespace tedit
