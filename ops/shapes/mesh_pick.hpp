// SPDX-License-Identifier: AGPL-3.0-or-later
// What operations share that make a mesh finer or coarser around a pick.
#pragma once

#include "mesh/adapt/size_field.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// The parameters "at" and "radius" where a place is given, else the selected surfaces; all of them
/// are in `surfaces` in any case.
[[nodiscard]] mesh_pick pick_of(const selection& picked, const parameters& values);

/// Is there something of the part? Errors: `empty_selection` where neither surface nor place is
/// given, or naming a surface without an outer side, or the distance of a place from the part.
[[nodiscard]] expected<void> check_pick(const mesh_version& mesh, const mesh_pick& pick);

/// The description of "radius".
[[nodiscard]] parameter_description pick_radius_parameter();

/// "1.25 mm".
[[nodiscard]] std::string size_text(double metres);

}  // namespace tedit::ops
