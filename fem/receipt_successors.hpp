// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "mesh/version.hpp"

namespace tedit::fem {

/// Which surfaces took the place of one that an edit removed, the same for every operation: those
/// of boundary facets that the edit made and that touch a vertex of the removed surface's border
/// (vertices that it shared with others). When none does, the border of all facets that went and
/// that hang together with it is taken: a fin's face goes with its fillets.
class successors {
public:
  /// Both versions must outlive this. Cost: O(facets in dirty pages).
  successors(const mesh_version& from, const mesh_version& to);

  /// Each successor with the area, m^2, by which the edit made it grow; those that only have
  /// other facets than before are left out unless no other is found. Empty when there is none (a
  /// void inside the part has no border). Cost: O(facets).
  [[nodiscard]] std::map<surface_id, double> of(surface_id removed) const;

private:
  using vertex_marks = std::vector<bool>;

  [[nodiscard]] vertex_marks vertices_of(surface_id removed) const;
  [[nodiscard]] vertex_marks hanging_together(vertex_marks with) const;
  [[nodiscard]] std::map<surface_id, double> touching(const vertex_marks& vertices) const;

  const mesh_version& from_;
  const mesh_version& to_;
  std::vector<facet_id> gone_;          ///< Facets of `from_` that `to_` does not have.
  std::vector<facet_id> made_;          ///< Facets of `to_` that `from_` does not have.
  std::map<surface_id, double> grown_;  ///< Area of made facets less that of gone ones.
  std::map<surface_id, double> made_area_;
};

}  // namespace tedit::fem
