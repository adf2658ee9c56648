// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "mesh/features/wall_shape.hpp"
#include "ops/shapes/outlines/outline_file.hpp"

namespace tedit::ops {

struct emboss_text {
  std::string text;           ///< UTF-8, one line.
  std::string font = "sans";  ///< As `font_file` takes it.
  double letter_height = 0;   ///< m, of capitals; of a logo its longer side.
  double height = 0;          ///< m; negative is sunk.
  vec3 up;                    ///< Which way the letters stand; zero: by the part's axes.
  std::optional<outline_file> logo = {};  ///< Instead of the text.
  bool wraps = true;                      ///< Around a selected wall that is a round cylinder.
};

/// Up for a wall that nobody gave one for: the part's z axis, on level walls its y axis.
[[nodiscard]] vec3 text_up(vec3 outward);

/// What the parameters of the operation ask for, and where.
struct emboss_order {
  emboss_text what;
  placement where;
};

/// Errors: `invalid_parameter` for a long text, those of `outline_file_of` and of `placement_of`.
[[nodiscard]] expected<emboss_order> emboss_order_of(const mesh_version& mesh,
                                                     const selection& picked,
                                                     const parameters& values);

/// Letters as a solid, before they are divided into triangles: even-odd filled outlines from `from`
/// to `to` (m) along the frame's z axis.
struct emboss_shape {
  frame place;
  profile outlines;
  double from = 0;
  double to = 0;
  double edge = 0;                  ///< m: of the triangles.
  std::optional<wall_shape> round;  ///< The cylinder that they are bent around.
};

/// Errors: those of `text_outlines` and of `outline_file::outlines`, `invalid_parameter` for
/// letters that no mesh can have there. Cost: some rays.
[[nodiscard]] expected<emboss_shape> emboss_shape_of(const mesh_version& mesh,
                                                     const placement& where,
                                                     const emboss_text& what,
                                                     const std::vector<surface_id>& picked);

/// The text or logo raised from the wall at the place, or sunk into it: straight, or around the
/// cylinder that the first selected wall is. Errors: those of
/// `text_outlines`, of `outline_file::outlines` and of `services::boolean`.
[[nodiscard]] expected<edit_result> emboss(const version_ptr& mesh, const placement& where,
                                           const emboss_text& what,
                                           const std::vector<surface_id>& picked, context& ctx);

}  // namespace tedit::ops
