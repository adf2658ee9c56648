// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/shapes/outlines/dxf_entities.hpp"

namespace tedit::ops {

/// What the model space of a DXF shows of outlines, as it is drawn.
struct dxf_drawing {
  std::vector<plane_path> paths;     ///< In units of the drawing; none without a curve.
  double metres_per_unit = 1e-3;     ///< By $INSUNITS; a drawing without one is in millimetres.
  std::string unit;                  ///< "mm"; empty where the drawing does not say.
  std::vector<std::string> notices;  ///< What a person should know of how it was read.
};

/// Curves and inserted blocks that one drawing may have.
inline constexpr std::size_t most_drawn = 20'000;

/// Lines, polylines, arcs, circles, ellipses and splines on layers that are shown, blocks where
/// they are inserted (scaled, turned, mirrored, in rows and in each other). Texts, hatches,
/// dimensions and all else is left out and counted in a notice. Why a reader of our own:
/// docs/decisions/0065-dxf-profiles.md. Errors: those of `dxf_groups` and `path_of_entity`;
/// `bad_input` for blocks that are not there or hold themselves, for more than `most_drawn` curves,
/// for units of no length that parts have. Cost: O(bytes + curves).
[[nodiscard]] expected<dxf_drawing> read_dxf(const attachment& file);

}  // namespace tedit::ops
