// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/execution.hpp"
#include "ops/boolean/surface_mesh.hpp"

namespace tedit::ops {

/// How far cleaning may go. All lengths are shares of the local size. Facets with slack may be left
/// by that much more.
struct clean_settings {
  double off_plane = 1e-4;   ///< Nothing moves further off the planes that it is in.
  double weld = 0.03;        ///< Edges shorter than this go, whatever their triangles look like.
  double least_size = 0.12;  ///< Where creases nearly meet, triangles get at most so much smaller.
  /// Every bend is a crease, and triangles get as small as what is between two of them, in as many
  /// rounds as that takes, and as small as what is left between two faces; `least_size` is then a
  /// share of the new vertices' mean size.
  bool fine = false;
};

/// Makes triangles that tets fit on out of those that an exact boolean leaves: merges what is
/// closer than `weld`; finds sizes from the vertices and from creases that nearly meet; contracts
/// short edges, halves long ones, turns and moves what raises the worst triangle around. Creases
/// and corners stay, labels stay, frozen faces stay. Source: the practice of isotropic remeshing
/// (Botsch and Kobbelt 2004), with guards. Where it is cancelled the surface is left as it is then.
/// Cost: O(faces) a round, a dozen rounds, some thirty where it is fine.
void clean_surface(surface_mesh& mesh, const clean_settings& settings, const cancel_token& cancel);

}  // namespace tedit::ops
