// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Where little of the part is left between two of its faces.
struct thin_remain {
  double thickness = 0;  ///< m
  vec3 at;
};

struct combined {
  boolean_result made;
  /// m^3: of its change of volume, what walls gained by shorter chords and vertices on their arcs.
  double rounder = 0;
  /// The thinnest that finer triangles were needed for, if less than a tenth of an edge there.
  std::optional<thin_remain> thin;
};

/// `services::boolean_onto`: see there. The steps: the tets that the tool crosses and a ring around
/// are taken out; an exact boolean of their closed surface with the tool (CGAL, in a process of its
/// own); a surface that tets fit on; TetGen, in a process of its own; local improvement. Where the
/// tets are not as good as before, or a step fails, again with more room and then with less
/// exactness. Where new vertices of that lie on chords of round walls, once more on a part with
/// shorter ones (`with_shorter_chords`).
[[nodiscard]] expected<combined> combine_with_tool(
  const version_ptr& mesh, const tool_surface& tool,
  const std::vector<std::optional<surface_id>>& continues, const boolean_request& request,
  const execution& run);

/// What of that is seen, sooner: the surface as the exact boolean leaves it, with the surfaces
/// that it would have, the new ones maybe under each other's ids, and the change of volume. The
/// cavity is filled with a fan from one point, so that the candidate is linked as any other, but
/// its new tets overlap and their quality is not told: it is looked at and thrown away. Errors:
/// those of the exact boolean; nothing is tried a second time.
[[nodiscard]] expected<boolean_result> draft_with_tool(
  const version_ptr& mesh, const tool_surface& tool,
  const std::vector<std::optional<surface_id>>& continues, const boolean_request& request,
  const execution& run);

/// Errors: `invalid_argument` for a tool that is not closed, is turned inside out, or has numbers
/// that are not finite.
[[nodiscard]] expected<void> validate(const tool_surface& tool);
/// Errors: also where `continues` has another number of entries than the tool has faces, but none.
[[nodiscard]] expected<void> validate(const tool_surface& tool,
                                      const std::vector<std::optional<surface_id>>& continues);

}  // namespace tedit::ops
