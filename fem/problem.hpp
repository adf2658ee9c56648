// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
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

/// A discretised static problem: what a backend assembles and solves. Nodes and elements are dense;
/// nothing here assumes that an element has four nodes.
struct problem {
  int element_order = 1;                 ///< 1: linear tets. (2: quadratic, mid nodes on edges.)
  int nodes_per_element = 4;             ///< 4 for order 1.
  std::vector<vec3> nodes;               ///< Rest positions, m.
  std::vector<vertex_id> node_vertices;  ///< Mesh vertex of each corner node.
  std::vector<std::uint32_t> element_nodes;      ///< nodes_per_element per element.
  std::vector<tet_id> element_tets;              ///< Mesh tet of each element.
  std::vector<std::uint32_t> element_materials;  ///< Index into `constants`.
  std::vector<lame_constants> constants;
  std::vector<double> densities;        ///< kg/m^3, by material.
  std::vector<double> yield_strengths;  ///< Pa, by material; 0 unknown.

  std::vector<double> loads;  ///< f, N, 3 per node.

  /// The constraint filter S (Baraff & Witkin 1998): per node a symmetric projector onto the free
  /// directions as xx, xy, xz, yy, yz, zz. Identity for a free node, zero for a clamped one.
  std::vector<std::array<double, 6>> filter;
  /// z: prescribed displacement, m, 3 per node; zero in free directions.
  std::vector<double> prescribed;

  [[nodiscard]] std::size_t node_count() const { return nodes.size(); }
  [[nodiscard]] std::size_t element_count() const { return element_tets.size(); }
  [[nodiscard]] std::size_t dofs() const { return 3 * nodes.size(); }
};

/// Sets up the problem of a load case on a version: nodes renumbered for locality, loads summed,
/// constraints turned into the filter. Cost: O(mesh).
/// Errors, each naming the place and the numbers: `surface_not_found`; `invalid_material` (E <= 0,
/// nu outside
/// (-1, 0.5), not finite, a region without material or with two); `invalid_load` (not finite, on no
/// area, gravity without density, no load at all and no prescribed displacement);
/// `inverted_tet`/`degenerate_tet` (count and first ids); `under_constrained` (a connected
/// component with rigid-body modes left: names component size, place and free modes; tets joined
/// only at a vertex or an edge count as hinged, not as connected).
[[nodiscard]] expected<problem> make_problem(const mesh_version& mesh, const load_case& loads);

}  // namespace tedit::fem
