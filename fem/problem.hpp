// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "base/error.hpp"
#include "fem/load_case.hpp"
#include "mesh/version.hpp"

namespace tedit::fem {

/// Elasticity constants of a material (Lame), Pa.
struct lame_constants {
  double lambda = 0;
  double mu = 0;
};

/// A surface that holds a node. `stiffness` (m^2; xx, xy, xz, yy, yz, zz) is the projector onto the
/// directions that the surface's constraints hold there, times the area of the surface's triangles
/// around the node. By it a reaction is shared where several surfaces hold one node.
struct node_holder {
  std::uint32_t node = 0;
  surface_id surface = 0;
  std::array<double, 6> stiffness{};
  double uncertainty = 0;  ///< Sine of the angle by which the directions may be off.
};

/// A discretised static problem: what a backend assembles and solves. Nodes and elements are dense;
/// nothing here assumes that an element has four nodes.
///
/// Nodes: first the corners, along a Morton curve, then (order 2) the middles of the edges, by
/// (lower end, higher end). Elements: by their smallest node, so that they follow space, too.
/// Nodes of a quadratic element, in the order of VTK and Abaqus (C3D10): corners 0 to 3, then the
/// middles of (0,1), (1,2), (2,0), (0,3), (1,3), (2,3); its edges are straight.
struct problem {
  int element_order = 1;                 ///< 1: linear tets. 2: quadratic, mid nodes on edges.
  int nodes_per_element = 4;             ///< 4 for order 1, 10 for order 2.
  std::size_t corner_count = 0;          ///< Nodes for vertices of the mesh.
  std::vector<vec3> nodes;               ///< Rest positions, m.
  std::vector<vertex_id> node_vertices;  ///< Mesh vertex of each corner node; `no_id` when unused.
  /// Lower and higher end of the edge of node corner_count + i. Empty for order 1.
  std::vector<std::array<std::uint32_t, 2>> edge_ends;
  std::size_t ordered_edges = 0;  ///< So many of `edge_ends` ascend; the others are `late_edges`.
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> late_edges;  ///< Mid node by ends.
  /// Nodes that no element has, ascending: held, without load. Spare corners for later edits, and
  /// what edits left.
  std::vector<std::uint32_t> unused;
  std::vector<std::uint32_t> element_nodes;      ///< nodes_per_element per element.
  std::vector<tet_id> element_tets;              ///< Mesh tet of each element.
  std::vector<std::uint32_t> element_materials;  ///< Index into `constants`.
  std::vector<lame_constants> constants;
  std::vector<double> densities;        ///< kg/m^3, by material; 0 unknown.
  std::vector<double> yield_strengths;  ///< Pa, by material; 0 unknown.

  std::vector<double> loads;  ///< f, N, 3 per node.

  /// The constraint filter S (Baraff & Witkin 1998): per node a symmetric projector onto the free
  /// directions as xx, xy, xz, yy, yz, zz. Identity for a free node, zero for a clamped one.
  std::vector<std::array<double, 6>> filter;
  /// z: prescribed displacement, m, 3 per node; zero in free directions.
  std::vector<double> prescribed;
  std::vector<node_holder> holders;  ///< By (node, surface), ascending.

  [[nodiscard]] std::size_t node_count() const { return nodes.size(); }
  [[nodiscard]] std::size_t element_count() const { return element_tets.size(); }
  [[nodiscard]] std::size_t dofs() const { return 3 * nodes.size(); }
  /// `dofs` without those of unused nodes: what a person calls the size of the problem.
  [[nodiscard]] std::size_t unknowns() const { return 3 * (nodes.size() - unused.size()); }
};

/// Sets up the problem of a load case on a version with linear (`element_order` 1) or quadratic (2)
/// tets: nodes renumbered for locality, loads summed, constraints turned into the filter.
/// `spare_corners` unused corner nodes are room for vertices that an edit adds. Cost: O(mesh).
/// Errors, each naming the place and the numbers: `surface_not_found`; `invalid_material` (E <= 0,
/// nu outside (-1, 0.5), not finite, a region without material or with two); `invalid_load` (not
/// finite, on no area, gravity without density, no load at all and no prescribed displacement);
/// `inverted_tet`/`degenerate_tet` (count and first ids); `under_constrained` (a connected
/// component with rigid-body modes left: names component size, place and free modes; tets joined
/// only at a vertex or an edge count as hinged, not as connected); `invalid_argument` for another
/// order.
[[nodiscard]] expected<problem> make_problem(const mesh_version& mesh, const load_case& loads,
                                             int element_order = 1,
                                             std::uint32_t spare_corners = 0);

/// Replaces loads and constraints of a problem that `make_problem` made of the same mesh and the
/// same materials: nodes, elements and with them the matrix stay. Cost: O(surfaces' triangles +
/// nodes). Errors: those of `make_problem`; then `p` is not to be used.
[[nodiscard]] expected<void> set_conditions(const mesh_version& mesh, const load_case& loads,
                                            problem& p);

}  // namespace tedit::fem
