// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "base/attachment.hpp"
#include "ops/tools/placement.hpp"

namespace tedit::ops {

struct emboss_text {
  std::string text;                     ///< UTF-8, one line.
  std::string font = "sans";            ///< As `font_file` takes it.
  double letter_height = 0;             ///< m, of capitals; of a logo its longer side.
  double height = 0;                    ///< m; negative is sunk.
  vec3 up;                              ///< Which way the letters stand; zero: by the part's axes.
  std::optional<attachment> logo = {};  ///< An SVG instead of the text.
  bool wraps = true;                    ///< Around a selected wall that is a round cylinder.
};

/// Up for a wall that nobody gave one for: the part's z axis, on level walls its y axis.
[[nodiscard]] vec3 text_up(vec3 outward);

/// The text or logo raised from the wall at the place, or sunk into it: straight, or around the
/// cylinder that the first selected wall is. Errors: those of
/// `text_outlines`, of `svg_outlines` and of `services::boolean`.
[[nodiscard]] expected<edit_result> emboss(const version_ptr& mesh, const placement& where,
                                           const emboss_text& what,
                                           const std::vector<surface_id>& picked, context& ctx);

}  // namespace tedit::ops
