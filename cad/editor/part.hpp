// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Dir.hxx>

#include "cad/editing.hpp"
#include "cad/exchange.hpp"

namespace tedit::cad {

/// A B-rep with what is known of its faces and solids.
struct part_model {  // NOLINT(bugprone-exception-escape): to move a map of OpenCASCADE allocates.
  TopoDS_Shape shape;
  part_facts facts;
  TopTools_IndexedMapOfShape faces;  ///< In the order of `facts.faces`, from 1.

  /// The faces that carry one of the ids, in order.
  [[nodiscard]] std::vector<TopoDS_Face> faces_of(const std::vector<int>& ids) const;
};

/// Errors: `internal` where shape and facts do not belong together.
[[nodiscard]] expected<part_model> load_part(const std::filesystem::path& folder);

[[nodiscard]] bool save_part(const part_model& part, const std::filesystem::path& folder);

/// The faces at each edge.
[[nodiscard]] TopTools_IndexedDataMapOfShapeListOfShape faces_at_edges(const TopoDS_Shape& shape);

/// What a face encloses with the origin, mm3: summed over a closed shell the volume.
[[nodiscard]] double volume_below(const TopoDS_Face& face);

[[nodiscard]] double area_of(const TopoDS_Shape& shape);

/// Out of the material. @pre the face is flat.
[[nodiscard]] gp_Dir outward_of_plane(const TopoDS_Face& face);

}  // namespace tedit::cad
