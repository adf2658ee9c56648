// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fem/load_case.hpp"
#include "mesh/deck.hpp"
#include "mesh/version.hpp"

namespace tedit::fem {

/// A load case made of what a solver's deck says of nodes and faces.
struct deck_case {
  load_case loads;
  /// What of the deck is not in it, or not in the same way, one sentence each with the numbers.
  std::vector<std::string> remarks;
};

/// Finds the surfaces that the nodes and faces of a deck (in SI units) make up:
/// - Supports: surfaces all of whose vertices are held in a component by the same value, the fewest
///   that cover the held vertices. All three at zero is `fixed`.
/// - Nodal forces: surfaces all of whose vertices have one, the fewest that cover them; those that
///   touch are one load. It becomes a `force` of their sum; where the nodal forces are not spread
///   as an even traction spreads them, that is said.
/// - Pressures: a surface all of whose faces have the same.
/// What makes up no surface is left out and counted. Cost: O(mesh).
[[nodiscard]] deck_case load_case_of_deck(const mesh_version& mesh, const deck& from);

}  // namespace tedit::fem
