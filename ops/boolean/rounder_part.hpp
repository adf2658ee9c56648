// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/boolean/round_walls.hpp"

namespace tedit::ops {

struct rounder_part {
  version_ptr mesh;          ///< Null where nothing is to be halved, or the part is too large.
  bool is_known = false;     ///< The CAD model has all round walls there: none is fitted.
  std::vector<tet_id> flat;  ///< Its tets that came out flatter than is good: to be made anew.
};

/// m: how far chords may be off their walls where a tool meets them; `size`: how long edges are
/// there.
[[nodiscard]] double most_off_walls(const tool_surface& tool, double size);

/// The part with shorter chords of its round walls where a tool is to meet them: they are halved
/// until their middles are nearer to the walls than a fiftieth of the tool's least extent and of
/// the local size, with the new vertices on the walls (`split_chords`). Where a tool is small
/// beside the chords its own vertices cannot be put on the walls without triangles turning over.
/// @param near all live facets that meet the tool's box.
/// @param size m: how long edges are there.
/// Errors: `invalid_parameter` where too many tets would come out, `cancelled`, `invalid_mesh`.
/// Cost: O(near); where there are such chords O(part), and some microseconds a new tet.
[[nodiscard]] expected<rounder_part> with_shorter_chords(const version_ptr& part,
                                                         const tool_surface& tool,
                                                         const std::vector<facet_id>& near,
                                                         round_walls& walls, double size,
                                                         const execution& run);

}  // namespace tedit::ops
