// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/tools/placement.hpp"
#include "ops/tools/sweep.hpp"

namespace tedit::ops {

/// What is carried along which way.
struct sweep_order {
  std::vector<vec3> path;  ///< m.
  profile shape;
  vec3 up;            ///< Unit: which way the profile's height goes at the start.
  double reach = 0;   ///< m: half of the profile's greatest extent.
  double length = 0;  ///< m: of the path.
  double local = 0;   ///< m: the part's mean edge around the path.
  double size = 0;    ///< m: what the tool's triangles should measure.
  boolean_mode mode = boolean_mode::cut;
};

/// That these parameters of `sweep` ask for. Errors: `invalid_parameter` without a path, or where
/// the profile is too small for the mesh. Cost: O(facet slots).
[[nodiscard]] expected<sweep_order> sweep_order_of(const mesh_version& mesh,
                                                   const selection& picked,
                                                   const parameters& values);

/// Cuts it from the part or adds it. Errors: those of `sweep` and of `apply_tool`.
[[nodiscard]] expected<edit_result> sweep_along(const version_ptr& mesh, const selection& picked,
                                                const parameters& values, context& ctx);

}  // namespace tedit::ops
