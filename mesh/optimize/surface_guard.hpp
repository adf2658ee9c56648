// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/optimize/improvement.hpp"
#include "mesh/optimize/work_mesh.hpp"

namespace tedit {

using triangle = std::array<vec3, 3>;

/// An upper bound of the distance between two triangulated patches with the same rim, in m:
/// +infinity when the second one folds over, seen along the first one's mean normal. Both are
/// piecewise linear, so it is enough to look at vertices and where edges cross.
[[nodiscard]] double patch_distance(const std::vector<triangle>& before,
                                    const std::vector<triangle>& after);

/// A facet at a vertex v: (v, j, k) outward.
struct fan_facet {
  std::uint32_t facet;
  std::uint32_t j, k;
};

/// The facets at a boundary vertex, in no order.
void facets_at(const work_mesh& mesh, std::uint32_t v, const std::vector<std::uint32_t>& star,
               std::vector<fan_facet>& result);

/// Keeps every boundary change within the tolerance, and each surface's share with its surface. A
/// facet remembers how far it may be from the original boundary; a change adds what it moves to the
/// largest of the facets that it replaces, so that the sum bounds the whole deviation.
class surface_guard {
public:
  surface_guard(const work_mesh& mesh, surface_tolerance tolerance)
      : mesh_(mesh), tolerance_(tolerance) {}

  [[nodiscard]] bool active() const { return tolerance_.allows_any(); }

  /// Compares the facets that a change takes with those it makes, surface by surface. True when all
  /// stay within the tolerance and no surface loses its last facet; sets the change's deviation.
  [[nodiscard]] bool admits(work_change& change) const;

  /// The same for a move of vertex v; `deviation` is for all facets at v.
  [[nodiscard]] bool admits_move(std::uint32_t v, const std::vector<fan_facet>& fan, vec3 to,
                                 double& deviation) const;

  /// Along what a boundary vertex may move: two directions in the tangent plane of its surface, one
  /// along the crease of two surfaces, none at a corner.
  [[nodiscard]] std::vector<vec3> free_directions(std::uint32_t v,
                                                  const std::vector<fan_facet>& fan) const;

  /// May boundary vertex v go to its neighbour u over a boundary edge? Both must have no neighbour
  /// in common but over tets and facets of their edge (the link condition). Whether creases and
  /// corners stay where they are is for `admits` to say.
  [[nodiscard]] bool may_collapse(std::uint32_t v, std::uint32_t u,
                                  const std::vector<std::uint32_t>& star,
                                  const std::vector<fan_facet>& fan) const;

private:
  [[nodiscard]] double allowed(const std::vector<triangle>& patch) const;
  [[nodiscard]] bool has_other_facet(surface_id surface, const work_change& change) const;

  const work_mesh& mesh_;
  surface_tolerance tolerance_;
};

}  // namespace tedit
