// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include "mesh/features/wall_shape.hpp"

namespace tedit {

/// What a patch of triangles is a part of.
enum class surface_form { free, plane, cylinder, cone, sphere };

/// "free form", "plane", "cylinder", "cone", "sphere".
[[nodiscard]] std::string_view name_of(surface_form form);

/// The exact surface behind a patch of triangles, in the unit of their points.
struct fitted_shape {
  surface_form form = surface_form::free;
  /// Of a plane, cylinder or cone; of a sphere its `point` is the centre. Its side is +1.
  wall_shape wall;

  /// How far a point is off it, without sign; 0 for a free form.
  [[nodiscard]] double distance(vec3 p) const;
  /// Unit, away from the axis or centre; of a plane its own normal.
  [[nodiscard]] vec3 normal(vec3 p) const;
  /// The nearest point on it; of a free form the point itself.
  [[nodiscard]] vec3 project(vec3 p) const;
};

/// A facet as a fit sees it: where it is, and its area vector.
struct fit_facet {
  vec3 point;
  vec3 area;
};

/// The points and facets that a shape is fitted to.
struct fit_sample {
  std::span<const vec3> points;
  std::span<const fit_facet> facets;
};

/// The shape nearest to all points, whatever its error. Nothing where the points do not say one:
/// too few, or in one plane. Cost: O(points + facets).
[[nodiscard]] std::optional<fitted_shape> fit_shape(surface_form form, const fit_sample& sample);

}  // namespace tedit
