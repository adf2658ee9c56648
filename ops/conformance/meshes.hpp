// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/version.hpp"

namespace tedit::ops {

/// A mesh to try operations on.
struct sample {
  std::string name;  ///< For messages: "the drilled block".
  version_ptr mesh;
};

/// The kit's own meshes, cells of 10 mm with six tets each:
/// - the box: 40 x 30 x 30 mm, surfaces 1 to 6
/// - the drilled block: 60 x 50 x 30 mm with a through hole (surface 11), a blind hole (walls 12,
///   bottom 13), a boss (21) and sides with sparse and negative ids
/// - the block of two regions: the same with regions 4 and 90 and their interface (77)
/// - the edited block: the same after its boss was cut off, with free slots of every kind
[[nodiscard]] std::vector<sample> kit_samples();

}  // namespace tedit::ops
