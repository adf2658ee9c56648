// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/execution.hpp"
#include "ops/boolean/surface_mesh.hpp"

namespace tedit::ops {

/// How far cleaning may go. All lengths are shares of the local size.
struct clean_settings {
  double off_plane = 1e-4;   ///< Nothing moves further off the planes that it is in.
  double weld = 0.03;        ///< Edges shorter than this go, whatever their triangles look like.
  double least_size = 0.12;  ///< Where creases nearly meet, triangles get at most so much smaller.
};

/// Makes triangles that tets fit on out of those that an exact boolean leaves: merges what is
/// closer than `weld`; finds sizes from the vertices and from creases that nearly meet; contracts
/// short edges, halves long ones, turns and moves what raises the worst triangle around. Creases
/// and corners stay, labels stay, frozen faces stay. Source: the practice of isotropic remeshing
/// (Botsch and Kobbelt 2004), with guards. Where it is cancelled the surface is left as it is then.
/// Cost: O(faces) a round, a dozen rounds.
void clean_surface(surface_mesh& mesh, const clean_settings& settings, const cancel_token& cancel);

}  // namespace tedit::ops
