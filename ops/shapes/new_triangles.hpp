// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/box_tree.hpp"
#include "mesh/types.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// The triangles that an edit would add to the boundary, and what of the boundary is in their way.
class new_triangles {
public:
  /// Those of `surface` from `first` on. `vertices`: the mesh's vertex at each of its points, no_id
  /// where there is none. Both must outlive this. Cost: O(n log n).
  new_triangles(const closed_surface& surface, const std::vector<vertex_id>& vertices,
                std::size_t first);

  /// Around all of them.
  [[nodiscard]] box extent() const { return tree_.extent(); }

  /// Does a facet with these corners, at these places in m, meet one that it has no corner in
  /// common with? Cost: O(log n), and those whose boxes meet its own.
  [[nodiscard]] bool meet(const std::array<vertex_id, 3>& corners,
                          const std::array<vec3, 3>& places) const;

private:
  [[nodiscard]] std::array<vec3, 3> at(std::size_t i) const;

  const closed_surface& surface_;
  const std::vector<vertex_id>& vertices_;
  std::size_t first_ = 0;
  box_tree tree_;
};

}  // namespace tedit::ops
