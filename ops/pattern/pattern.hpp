// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/sdk/operation.hpp"
#include "ops/shapes/features/motion.hpp"

namespace tedit::ops {

/// Copies in rows: `count` in all along `step`, and `rows` of these along `row_step`.
struct grid_pattern {
  int count = 2;
  vec3 step;  ///< m.
  int rows = 1;
  vec3 row_step;  ///< m.
};

/// Copies at distances of their own.
struct uneven_pattern {
  std::vector<double> distances;  ///< m, from the one that is there, along `step`.
  vec3 step;                      ///< Only which way it goes counts.
  int rows = 1;
  vec3 row_step;  ///< m.
};

/// The motions of the copies, without that of the original. Errors: `invalid_parameter` where two
/// would lie in the same place, or there is none.
[[nodiscard]] expected<std::vector<motion>> grid_motions(const grid_pattern& grid);

[[nodiscard]] expected<std::vector<motion>> uneven_motions(const uneven_pattern& rows);

/// `count` in all around an axis (a point and a unit direction): evenly over the whole turn, or
/// from 0 to `angle` (rad) where that is less. Errors: as above.
[[nodiscard]] expected<std::vector<motion>> ring_motions(vec3 point, vec3 axis, int count,
                                                         double angle);

/// One at each of these angles (rad) from the one that is there. Errors: as above.
[[nodiscard]] expected<std::vector<motion>> angle_motions(vec3 point, vec3 axis,
                                                          const std::vector<double>& angles);

/// Those that the parameters of the operation ask for. Errors: as above.
[[nodiscard]] expected<std::vector<motion>> pattern_motions(const parameters& values);

/// Copies the holes or bosses that the surfaces belong to. Errors: those of `pick_features` and of
/// `place_copies`.
[[nodiscard]] expected<edit_result> repeat_features(const version_ptr& mesh,
                                                    const std::vector<surface_id>& picked,
                                                    const std::vector<motion>& motions,
                                                    context& ctx);

}  // namespace tedit::ops
