// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>

#include "ops/shapes/walls/moving_walls.hpp"

namespace tedit::ops {

/// Surfaces that go with moving walls as they are, each with its whole way, m.
using carried_set = std::map<surface_id, vec3>;

/// The fillets and rounds at the borders of flat walls that move, and what these run into smoothly
/// (the corners between them): they keep their shape and go along, so that they stay tangent to the
/// wall and to the flat surfaces on their other side. What keeps its place under that way (a
/// cylinder along it, a plane along it) ends the run. A fillet that was selected with its wall and
/// meets an unselected plane is taken out of `walls`: moved by the normal it would leave that
/// plane. Cost: O(facets of the surfaces and of their neighbours).
carried_set find_carried(const mesh_version& mesh, wall_set& walls, double distance);

}  // namespace tedit::ops
