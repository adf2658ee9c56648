// SPDX-License-Identifier: AGPL-3.0-or-later
// Whether a B-rep is the edited part: what OpenCASCADE calls valid may still be another shape.
#pragma once

#include <string>

#include "cad/editor/part.hpp"

namespace tedit::cad {

/// What a shape is found to be.
struct judgement {          // NOLINT(bugprone-exception-escape): as `part_model`.
  std::string fault;        ///< Why it is not the edited part; empty: it is.
  part_model part;          ///< The shape with its facts, where it is.
  double deviation_mm = 0;  ///< Of new vertices from the faces of their surfaces, at most.
};

/// The share of the part's size by which a new vertex of the mesh may be off the B-rep's face.
inline constexpr double vertex_share = 1e-6;

/// Compares a shape that was made of `before` with the edited mesh, in both directions:
/// - it is valid by OpenCASCADE's checks and has as many solids as the mesh has bodies;
/// - each of its faces is a surface of the mesh: faces that are as they were keep their ids, others
///   get those whose triangles lie on them; each surface of the mesh has a face;
/// - each new vertex is within `vertex_share` of the part's size of the surface behind a face of
///   each surface that it is on, and not more than ten times that beyond the face's rim; each new
///   triangle's middle is as near as a chord is to its arc;
/// - each point of a new or changed face is as near to the mesh, by samples of it;
/// - its volume changed as the mesh's, up to what chords leave out.
[[nodiscard]] judgement judge(const part_model& before, const TopoDS_Shape& after,
                              const cad_step& step, const edited_surface& mesh);

}  // namespace tedit::cad
