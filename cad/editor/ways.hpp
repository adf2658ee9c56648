// SPDX-License-Identifier: AGPL-3.0-or-later
// Ways in which a step may be done on a B-rep. None is trusted: judge.hpp says which one is right.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cad/editor/part.hpp"

namespace tedit::cad {

struct way {
  std::string name;
  std::function<TopoDS_Shape()> make;  ///< Null or a Standard_Failure: it cannot be done so.
};

/// Quickest and most exact first; the last ones of some ask the edited mesh. What they are given
/// must outlive them.
[[nodiscard]] std::vector<way> ways_of(const part_model& part, const cad_step& step,
                                       const edited_surface& mesh);

// Those of each kind.
[[nodiscard]] std::vector<way> ways_to_copy(const part_model& part, const cad_step& step);
[[nodiscard]] std::vector<way> ways_to_hollow(const part_model& part, const cad_step& step);
[[nodiscard]] std::vector<way> ways_to_shift(const part_model& part, const cad_step& step,
                                             const edited_surface& mesh);
[[nodiscard]] std::vector<way> ways_to_round(const part_model& part, const cad_step& step);
[[nodiscard]] std::vector<way> ways_with_tool(const part_model& part, const cad_step& step);

enum class body_operation { cut, add, keep };

/// Takes a hole's or a boss's faces away; the operation is what its body is closed or cut off with.
[[nodiscard]] std::vector<way> ways_to_remove(const part_model& part,
                                              const std::vector<int>& surfaces,
                                              body_operation operation);

/// The solids of a tool: outlines extruded, a section turned, or triangles. Throws a
/// Standard_Failure, or gives none, where there is no such solid.
[[nodiscard]] std::vector<TopoDS_Shape> solids_of_tool(const exact_tool& tool);

/// A closed surface of flat triangles; those in one plane become one face where that works.
[[nodiscard]] std::vector<TopoDS_Shape> faceted(const exact_tool& tool);

/// Edges that a boolean draws across a face.
enum class new_edges {
  go,  ///< They are taken out again where that works.
  /// Those across planes and cylinders alone: where a wall has many holes OpenCASCADE 7.6.3 looks
  /// for others for ever.
  go_across_simple,
  stay  ///< Those of the tool may part surfaces that have ids of their own.
};

/// The operation on each solid that `concerns` (all where it is empty), others as they are. Edges
/// that it draws across a face are taken out again where that works. Null where it fails.
[[nodiscard]] TopoDS_Shape combined(
  const part_model& part, const std::vector<TopoDS_Shape>& tools, body_operation operation,
  const std::function<bool(const TopoDS_Shape& solid)>& concerns = {},
  new_edges edges = new_edges::go);

/// The solids of a shape.
[[nodiscard]] std::vector<TopoDS_Shape> solids_of(const TopoDS_Shape& shape);

/// A compound of them.
[[nodiscard]] TopoDS_Shape compound_of(const std::vector<TopoDS_Shape>& shapes);

}  // namespace tedit::cad
