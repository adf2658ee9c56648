// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>

namespace tedit::cad {

/// A point of a face with what bends there: the surface, or an edge of the face near by.
struct face_sample {
  gp_Pnt at;
  double curvature = 0;  ///< 1/mm.
};

/// Points of a face, about `spacing` (mm) apart, at most some thousand.
[[nodiscard]] std::vector<face_sample> samples_of(const TopoDS_Face& face, double spacing);

}  // namespace tedit::cad
