// SPDX-License-Identifier: AGPL-3.0-or-later
// Holes and bosses by their faces.
#pragma once

#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_MapOfShape.hxx>

#include "cad/editor/ways.hpp"

namespace tedit::cad {

/// Faces that go, or are made again, and what of their edges belongs to other faces.
struct feature {
  std::vector<TopoDS_Face> faces;
  TopTools_MapOfShape gone;
  TopTools_MapOfShape rim;                  ///< Edges.
  TopTools_DataMapOfShapeShape neighbours;  ///< Rim edge to the face that stays.
};

[[nodiscard]] feature feature_of(const part_model& part, const std::vector<int>& surfaces);

/// What faces enclose with caps on their rim.
struct plug {
  TopoDS_Shape solids;  ///< Null where it cannot be closed.
  std::vector<TopoDS_Face> caps;
};

/// Caps are flat where the rim is, as mouths of holes are, else on the surface around it.
[[nodiscard]] plug plug_of(const feature& what);

}  // namespace tedit::cad
