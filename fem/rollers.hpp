// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fem/problem_parts.hpp"

/// How rollers hold the nodes of flat and round surfaces; internal to fem/.
namespace tedit::fem {

/// A direction in which rollers hold a node.
struct roller_direction {
  std::uint32_t node = 0;
  vec3 direction;          ///< Outward normal of length one, each component within 1e-12.
  double uncertainty = 0;  ///< Sine of the angle by which the true normal may differ; 0 when flat.
  /// The surfaces whose normals became this one, and the area around the node on each, m^2.
  struct share {
    surface_id surface = 0;
    double area = 0;
  };
  std::vector<share> shares;
};

/// The directions that rollers on `surfaces` hold, by node. Each node has one for every surface
/// that meets another there at an edge, and one for surfaces that continue each other smoothly, as
/// the halves of a bore do. On a cylinder or a cone (`fit_wall`) normals are those of the shape;
/// elsewhere means of those of the facets around, weighted so that they are exact on a plane and on
/// a sphere (Max 1999, J. Graphics Tools 4(2)). Cost: the surfaces' triangles.
[[nodiscard]] std::vector<roller_direction> roller_directions(const mesh_version& mesh,
                                                              const problem& p,
                                                              const surface_triangles& triangles,
                                                              std::span<const surface_id> surfaces);

}  // namespace tedit::fem
