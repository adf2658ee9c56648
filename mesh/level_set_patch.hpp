// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/builder.hpp"

namespace tedit {

/// An edge between a surface and another one, in the direction of the surface's facet.
struct patch_edge {
  vertex_id a = no_id;
  vertex_id b = no_id;
  facet_id inner = no_id;  ///< Of the surface.
  facet_id outer = no_id;  ///< Of the other one.
  double angle = 0;        ///< Through the material, rad: 90 degrees at a block's edge.

  /// The neighbour goes down beside the surface: by more than a degree, else it runs on or rises.
  [[nodiscard]] bool convex() const;

  /// It goes straight down.
  [[nodiscard]] bool vertical() const;
};

/// One surface of the current state of an edit, and how it lies in space.
struct surface_patch {
  surface_id surface = 0;
  std::vector<facet_id> facets;
  std::vector<patch_edge> border;
  vec3 origin;           ///< On the plane.
  vec3 normal;           ///< Unit, outward: mean over the area.
  double deviation = 0;  ///< Largest distance of a vertex from the plane, m.
  double mean_edge = 0;  ///< m.
  double size = 0;       ///< Diagonal of the box around it, m.

  /// Flat within rounding of a CAD file.
  [[nodiscard]] bool flat() const { return deviation <= 1e-6 * size; }

  /// Distance below the plane, m.
  [[nodiscard]] double depth(vec3 p) const { return dot(normal, origin - p); }
};

/// Errors: `empty_selection` when the surface has no facets (left), `non_manifold` where an edge of
/// it does not have one facet on each side. Cost: O(facet slots).
[[nodiscard]] expected<surface_patch> find_patch(const mesh_builder& mesh, surface_id surface);

/// A straight run of border edges at which what lies below the surface ends: at the plane through
/// the run and the normal. Either the neighbour does not go down, so material stands beside the
/// surface; or it goes straight down, and what lies behind its lower end is not below the surface.
struct patch_wall {
  vec3 origin;
  vec3 along;    ///< Unit.
  vec3 outward;  ///< Unit, across the run, away from the surface.
  double length = 0;
  facet_id outer = no_id;  ///< A facet of the neighbour at the run.
  bool descends = false;   ///< The neighbour goes straight down.

  [[nodiscard]] double across(vec3 p) const { return dot(outward, p - origin); }
  [[nodiscard]] double position(vec3 p) const { return dot(along, p - origin); }
};

/// The walls of a flat patch, longest runs first.
[[nodiscard]] std::vector<patch_wall> walls_of(const mesh_builder& mesh,
                                               const surface_patch& patch);

}  // namespace tedit
