// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace tedit {

/// What the reader does with an element type.
enum class element_use { skip, triangle, tet, quad, refuse };

struct element_kind {
  int type;
  int nodes;
  element_use purpose;
  const char* name;
};

// Gmsh reference manual, table of element types; the corner nodes always come first.
inline constexpr element_kind element_kinds[] = {
  {1, 2, element_use::skip, "line"},
  {2, 3, element_use::triangle, "triangle"},
  {3, 4, element_use::quad, "quadrangle"},
  {4, 4, element_use::tet, "tetrahedron"},
  {5, 8, element_use::refuse, "hexahedron"},
  {6, 6, element_use::refuse, "prism"},
  {7, 5, element_use::refuse, "pyramid"},
  {8, 3, element_use::skip, "quadratic line"},
  {9, 6, element_use::triangle, "quadratic triangle"},
  {10, 9, element_use::quad, "quadratic quadrangle"},
  {11, 10, element_use::tet, "quadratic tetrahedron"},
  {12, 27, element_use::refuse, "quadratic hexahedron"},
  {13, 18, element_use::refuse, "quadratic prism"},
  {14, 14, element_use::refuse, "quadratic pyramid"},
  {15, 1, element_use::skip, "point"},
  {16, 8, element_use::quad, "8-node quadrangle"},
  {17, 20, element_use::refuse, "20-node hexahedron"},
  {18, 15, element_use::refuse, "15-node prism"},
  {19, 13, element_use::refuse, "13-node pyramid"},
  {21, 10, element_use::triangle, "cubic triangle"},
  {26, 4, element_use::skip, "cubic line"},
  {29, 20, element_use::tet, "cubic tetrahedron"},
};

}  // namespace tedit
