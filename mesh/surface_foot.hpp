// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/vec3.hpp"

namespace tedit {

/// Where a surface is nearest to a point.
struct surface_foot {
  vec3 at;
  vec3 normal;  ///< Unit.
};

/// Finds the point of a surface of free form that is nearest to others.
class surface_projection {
public:
  virtual ~surface_projection() = default;

  [[nodiscard]] virtual surface_foot operator()(vec3 p) const = 0;

  /// m: a radius of curvature that it is not below near p, as far as was looked.
  [[nodiscard]] virtual double radius_at(vec3 p) const = 0;
};

}  // namespace tedit
