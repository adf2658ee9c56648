// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/print/print_checks.hpp"

namespace tedit {

/// The shells of a part's boundary and how they hang together. Cost: O(facets log facets).
struct shells {
  explicit shells(const mesh_version& mesh);

  std::size_t outward = 0;
  std::size_t inward = 0;
  std::size_t open_edges = 0;
  std::size_t hinge_edges = 0;
};

/// Puts facets that hang together over edges, or are joined, into places.
class place_finder {
public:
  place_finder(const mesh_version& mesh, bool least_is_worst);

  /// At most once for a facet.
  void add(facet_id facet, double area, double worst, vec3 at);
  /// Two that have been added are of one place; others are left alone.
  void join(facet_id one, facet_id two);

  /// Largest area first. Cost: O(n log n) of the facets that were added.
  [[nodiscard]] std::vector<print_place> places();

private:
  struct row {
    facet_id facet = 0;
    double area = 0;
    double worst = 0;
    vec3 at;
  };

  void unite_neighbours();

  const mesh_version& mesh_;
  bool least_is_worst_;
  std::vector<row> rows_;
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> row_of_;  ///< By facet slot.
};

}  // namespace tedit
