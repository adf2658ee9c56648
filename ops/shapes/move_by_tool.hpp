// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "ops/shapes/walls/moving_walls.hpp"

namespace tedit::ops {

/// Moves walls of any form by `distance` (m, outward; negative: into the material): what lies
/// between them and where they go is cut off or added (`make_wall_tool`, `services::boolean_onto`).
/// What is left of each keeps its id. Errors: those of both, `invalid_argument` where the part
/// would fall into pieces or nothing of a wall would be left, those of `passes`. Cost: that of a
/// boolean with a tool as large as the walls.
[[nodiscard]] expected<edit_result> move_by_tool(const version_ptr& mesh,
                                                 const std::vector<surface_id>& surfaces,
                                                 double distance, context& ctx);

/// One way to move walls.
using wall_way = std::function<expected<edit_result>()>;

/// Ways to move the same walls, the best one first.
struct wall_ways {
  std::vector<surface_id> surfaces;
  double distance = 0;  ///< m, outward; negative: into the material.
  bool flat = false;    ///< The first way cuts by planes: where it tells a limit, it is the part's.
  std::vector<wall_way> ways;
  /// Before all others, which know nothing of what is round: where fillets go along with flat
  /// walls, or round neighbours are trimmed by them. What these cannot do is for the others.
  std::vector<wall_way> round = {};
};

/// The first way whose result holds what an edit promises; else the first result that holds it with
/// tets as flat as a boolean may leave them. Where the first one fails and the part leaves no room
/// (`check_space`) no other one is tried, nor where `flat` walls are told an `invalid_argument` or
/// `empty_selection`. Errors: these; where walls are not flat, a limit that the last way tells;
/// else that of the first way that tells more than what a mesher could not do. Cost: that of the
/// ways that are tried.
[[nodiscard]] expected<edit_result> first_that_passes(const version_ptr& mesh, const wall_ways& all,
                                                      const execution& run);

}  // namespace tedit::ops
