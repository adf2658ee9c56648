// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ops/shapes/rounding/rolling_ball.hpp"

namespace tedit::ops {

/// A run of mesh edges between the same two surfaces that is to be rounded.
struct round_chain {
  surface_id a = 0;  ///< The smaller id; the path runs along its facets' edges.
  surface_id b = 0;
  std::vector<vertex_id> path;
  bool closed = false;   ///< The last vertex is followed by the first.
  double mean_edge = 0;  ///< m.

  /// "the edge between surfaces 3 and 7 at (..) mm".
  [[nodiscard]] std::string name(const mesh_version& mesh) const;
};

/// The surfaces around a boundary vertex and the edges between them, in order.
struct surface_fan {
  std::vector<surface_id> sectors;
  std::vector<vertex_id> rays;  ///< rays[i] ends the mesh edge between sectors i and i + 1.

  [[nodiscard]] bool has(surface_id s) const;
};

/// Cost: O(star).
[[nodiscard]] surface_fan fan_at(const mesh_version& mesh, facet_id f, vertex_id v);

/// One end of a chain.
struct chain_end {
  std::size_t chain = 0;
  bool last = false;  ///< At the path's end, not its start.
};

/// A vertex at which chains end, with the three surfaces around it.
struct round_corner {
  enum class kind {
    wall,    ///< One chain, which ends at the third surface.
    smooth,  ///< Two chains that go on in each other: their outer walls are tangent.
    mitre,   ///< Two chains that meet; the edge between their outer walls stays sharp.
    ball     ///< Three chains: the ball itself rounds the corner.
  };

  kind type = kind::wall;
  vertex_id at = no_id;
  surface_fan fan;
  std::vector<chain_end> ends;
};

/// What is to be rounded, and how it hangs together.
struct round_plan {
  double side = 1;  ///< +1: inner corners, -1: outer edges; see `rolling_ball`.
  std::map<surface_id, exact_wall> shapes;
  std::vector<round_chain> chains;
  std::vector<round_corner> corners;
  std::vector<surface_id> used;   ///< The selection as completed, ascending.
  std::vector<surface_id> added;  ///< Surfaces onto which a chain ran on smoothly.
};

/// Finds the edges of one kind (material angle beyond 180 degrees for side +1, below for -1, by
/// more than 5 degrees, by the exact shapes): between the selected surfaces, or all around a single
/// one. A chain that goes on smoothly at its end (a pocket's wall and its round corner) is
/// followed. Errors: `empty_selection` when there is no such edge, `invalid_argument` naming the
/// surface of free form, or the corner that cannot be rounded. Cost: O(facet
/// slots).
[[nodiscard]] expected<round_plan> find_chains(const mesh_version& mesh,
                                               const std::vector<surface_id>& surfaces,
                                               double side);

}  // namespace tedit::ops
