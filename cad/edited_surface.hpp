// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cad/editing.hpp"
#include "mesh/version.hpp"

namespace tedit::cad {

/// The boundary and the interfaces of `after`, in mm, with what the edit made and what of `before`
/// is gone. Cost: O(facet slots).
[[nodiscard]] edited_surface surface_after(const mesh_version& before, const mesh_version& after);

/// Sets of tets that hang together over faces within a region: the solids of a CAD model. Cost:
/// O(tet slots).
[[nodiscard]] std::size_t count_bodies(const mesh_version& mesh);

}  // namespace tedit::cad
