// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/tools/placement.hpp"

namespace tedit::ops {

struct emboss_text {
  std::string text;           ///< UTF-8, one line.
  std::string font = "sans";  ///< As `font_file` takes it.
  double letter_height = 0;   ///< m, of capitals.
  double height = 0;          ///< m; negative is sunk.
  vec3 up;                    ///< Which way the letters stand; zero: by the part's axes.
};

/// Up for a wall that nobody gave one for: the part's z axis, on level walls its y axis.
[[nodiscard]] vec3 text_up(vec3 outward);

/// The text raised from the wall at the place, or sunk into it. Errors: those of `text_outlines`
/// and of `services::boolean`.
[[nodiscard]] expected<edit_result> emboss(const version_ptr& mesh, const placement& where,
                                           const emboss_text& what,
                                           const std::vector<surface_id>& picked, context& ctx);

}  // namespace tedit::ops
