// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "ops/hollow/region_walls.hpp"
#include "ops/shapes/isosurface/isosurface.hpp"

namespace tedit::ops {

/// The space that a shell encloses, as a field: below 0 where what the walls bound is further than
/// the thickness from them. Through open walls it reaches out of the part by `overlap`.
class shell_field {
public:
  /// `thickness`, `overlap` (less than that): m. Cost: O(n log n) in the facets.
  shell_field(const mesh_version& mesh, const region_walls& walls,
              const std::vector<surface_id>& open, double thickness, double overlap);
  ~shell_field();

  /// Cost: O(log n).
  [[nodiscard]] field_sample at(vec3 p) const;

private:
  class wall_tree;

  double thickness_;
  double overlap_;
  std::unique_ptr<wall_tree> closed_;
  std::unique_ptr<wall_tree> open_;  ///< Null where no wall is open.
};

}  // namespace tedit::ops
