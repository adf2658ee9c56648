// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fem/problem.hpp"

/// The steps of `make_problem`; internal to fem/.
namespace tedit::fem {

/// "(1.5, 2, 30) mm" for a message.
[[nodiscard]] std::string point_text(vec3 p);

/// The triangles of each surface by node, boundary and interface ones.
class surface_triangles {
public:
  struct triangle {
    std::array<std::uint32_t, 3> nodes;
    bool interface = false;  ///< Between two regions: has no outward side.
  };

  surface_triangles(const mesh_version& mesh, const std::vector<std::uint32_t>& node_of);

  /// Errors: `surface_not_found` naming the item, the id and the nearest id that there is.
  [[nodiscard]] expected<void> check_ids(const mesh_version& mesh, const load_case& loads) const;

  [[nodiscard]] const std::vector<triangle>& of(surface_id id) const;

private:
  std::map<surface_id, std::vector<triangle>> by_surface_;
  std::vector<triangle> none_;
};

/// Fills constants, yield strengths, densities per element. Errors: `invalid_material`.
[[nodiscard]] expected<void> assign_materials(const mesh_version& mesh, const load_case& loads,
                                              problem& p);

/// Fills filter and prescribed values. Errors: `invalid_argument` for contradictions, not finite
/// values.
[[nodiscard]] expected<void> add_constraints(const surface_triangles& triangles,
                                             const load_case& loads, problem& p);

/// Fills loads. Errors: `invalid_load`.
[[nodiscard]] expected<void> add_loads(const surface_triangles& triangles, const load_case& loads,
                                       problem& p);

/// Errors: `under_constrained` for a body with rigid-body motions left.
[[nodiscard]] expected<void> check_supports(const mesh_version& mesh, const problem& p);

}  // namespace tedit::fem
