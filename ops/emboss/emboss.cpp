// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/emboss/emboss.hpp"

#include <algorithm>
#include <cmath>

#include "ops/emboss/text_outlines.hpp"
#include "ops/tools/profiles.hpp"

namespace tedit::ops {

vec3 text_up(vec3 outward) {
  return std::abs(outward.z) < 0.9 ? vec3{0, 0, 1} : vec3{0, 1, 0};
}

expected<edit_result> emboss(const version_ptr& mesh, const placement& where,
                             const emboss_text& what, const std::vector<surface_id>& picked,
                             context& ctx) {
  if (what.text.find_first_not_of(" \t") == std::string::npos)
    return fail(ec::invalid_parameter, "there is no text to emboss", "Give text=...");
  if (what.height == 0)
    return fail(ec::invalid_parameter, "letters of no height are none",
                "Give a height; a negative one is sunk");
  const auto font = font_file(what.font);
  if (!font)
    return fail(font.error());
  // Strokes are about an eighth of a capital wide.
  const double edge = std::min(where.size, what.letter_height / 8);
  if (auto ok = check_fineness(where, edge, std::abs(what.height)); !ok)
    return fail(ok.error());
  const auto outlines = text_outlines(what.text, *font, what.letter_height, edge);
  if (!outlines)
    return fail(outlines.error());
  const double radius = radius_of(*outlines);
  const bool raised = what.height > 0;
  const vec3 lifted = where.at + 1e-4 * where.size * where.outward;
  const double gap = raised ? gap_below(*mesh, lifted, where.outward, radius) : 0;
  const double foot = gap > 1e-3 * where.size ? gap + 0.2 * edge : 0;
  const double above = clearance(*mesh, where.at, where.outward, radius) + 0.5 * edge;
  const auto tool =
    extrude(make_frame(where.at, where.outward, what.up), *outlines, raised ? -foot : what.height,
            raised ? what.height : above, edge, "text", *ctx.host);
  if (!tool)
    return fail(tool.error());
  return apply_tool(mesh, *tool, raised ? boolean_mode::add : boolean_mode::cut, where.size, picked,
                    ctx);
}

}  // namespace tedit::ops
