// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/types.hpp"
#include "mesh/vec3.hpp"

namespace tedit {

using triangle_corners = std::array<std::uint32_t, 3>;

/// Triangles of a closed surface; their unit is whatever it is.
struct triangle_surface {
  std::vector<vec3> points;
  std::vector<triangle_corners> triangles;
};

/// The triangle behind each edge (k: from corner k to the next); `no_id` where there is not exactly
/// one other. Cost: O(n log n).
[[nodiscard]] std::vector<triangle_corners> triangles_across(
  const std::vector<triangle_corners>& triangles);

/// What is behind the edges that a flat facet shares with another one.
struct facet_link {
  std::uint32_t other = 0;
  double length = 0;
  double cosine = 1;  ///< Between both normals.
};

/// Triangles in one plane.
struct flat_facet {
  vec3 area;  ///< Sum of their area vectors.
  vec3 middle;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> corners;  ///< Each point once.
  std::vector<facet_link> links;       ///< In the order of `other`.
};

/// A surface as its flat facets: a tessellated CAD part has one for each plane and one for each
/// strip of a cylinder, a scan nearly as many as triangles.
class facet_net {
public:
  /// Points count as in a plane within `tolerance`; triangles that are not higher than a few times
  /// that go with the one behind their longest edge. Triangles of different `groups` stay apart;
  /// empty: there are none. Cost: O(n log n).
  facet_net(const triangle_surface& surface, double tolerance,
            const std::vector<std::uint32_t>& groups);

  [[nodiscard]] const std::vector<flat_facet>& facets() const { return facets_; }
  /// The facet of each triangle.
  [[nodiscard]] const std::vector<std::uint32_t>& facet_of() const { return facet_of_; }

private:
  void grow(std::uint32_t seed);
  void attach_slivers();
  void add_corners();
  void add_links();
  [[nodiscard]] vec3 normal_of(std::uint32_t triangle) const;
  [[nodiscard]] bool same_group(std::uint32_t a, std::uint32_t b) const;

  const triangle_surface& surface_;
  double tolerance_;
  const std::vector<std::uint32_t>& groups_;
  std::vector<triangle_corners> across_;
  std::vector<double> heights_;
  std::vector<std::uint32_t> facet_of_;
  std::vector<flat_facet> facets_;
};

}  // namespace tedit
