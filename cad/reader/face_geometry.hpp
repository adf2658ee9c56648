// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <TopoDS_Face.hxx>

#include "mesh/types.hpp"

namespace tedit::cad {

/// What a face of a part in mm is a piece of, in metres; `none` for offset surfaces, and for free
/// form of more poles than `spline_surface` has.
[[nodiscard]] surface_geometry geometry_of(const TopoDS_Face& face);

}  // namespace tedit::cad
