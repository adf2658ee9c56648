// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "fem/incidence.hpp"

/// The steps of `make_problem`; internal to fem/.
namespace tedit::fem {

/// Adds the middles of all edges to a problem of linear tets: nodes, `edge_ends`, ten nodes per
/// element. Cost: O(elements), on all cores; 4 bytes per edge of each tet while it works.
void add_mid_nodes(problem& p);

/// The node in the middle of the edge between corner nodes a and b of a quadratic problem, or
/// `no_id`. May be unused. Cost: O(log edges).
[[nodiscard]] std::uint32_t mid_node(const problem& p, std::uint32_t a, std::uint32_t b);

/// The triangles of each surface by node, boundary and interface ones.
class surface_triangles {
public:
  /// Corners, then (order 2) the middles of (0,1), (1,2), (2,0).
  struct triangle {
    std::array<std::uint32_t, 6> nodes{};
    int count = 3;           ///< 3 or 6.
    bool interface = false;  ///< Between two regions: has no outward side.

    [[nodiscard]] std::span<const std::uint32_t> all() const {
      return std::span(nodes).first(count);
    }
    /// The nodes that share an even load equally. On a quadratic triangle the corner functions
    /// integrate to zero, the middle ones to a third of the area each.
    [[nodiscard]] std::span<const std::uint32_t> loaded() const {
      return std::span(nodes).subspan(count - 3, 3);
    }
  };

  /// Of the surfaces that the load case names. `p` has its nodes and elements.
  surface_triangles(const mesh_version& mesh, const load_case& loads,
                    const std::vector<std::uint32_t>& node_of, const problem& p);

  [[nodiscard]] const std::vector<triangle>& of(surface_id id) const;

private:
  std::map<surface_id, std::vector<triangle>> by_surface_;
  std::vector<triangle> none_;
};

/// Between two looks for a cancel where each triangle of a surface is visited.
inline constexpr std::size_t triangles_between = 2048;

/// The area vector of a triangle, m^2: outward, as long as the area.
[[nodiscard]] inline vec3 area_of(const problem& p, const surface_triangles::triangle& t) {
  return area_vector(p.nodes[t.nodes[0]], p.nodes[t.nodes[1]], p.nodes[t.nodes[2]]);
}

/// Fills constants, yield strengths, densities per element. Errors: `invalid_material`.
[[nodiscard]] expected<void> assign_materials(const mesh_version& mesh, const load_case& loads,
                                              problem& p);

/// Errors: `surface_not_found` naming the item, the id and the nearest id that there is.
[[nodiscard]] expected<void> check_surfaces(const mesh_version& mesh, const load_case& loads);

/// `set_conditions` without its check that the part is held.
[[nodiscard]] expected<void> place_conditions(const mesh_version& mesh, const load_case& loads,
                                              problem& p);

/// Whether tets that share nodes with an edit hang together over faces among themselves. Then the
/// edit has torn nothing apart: whatever hung together through it before still does. `nodes` are
/// those of `problem_change`. Cost: the tets around.
[[nodiscard]] bool hangs_together(const mesh_version& mesh, const problem& p,
                                  const incidence& corners, std::span<const std::uint32_t> nodes);

/// Which material each region has, by index.
struct region_materials {
  std::map<region_id, std::uint32_t> named;
  std::uint32_t fallback = no_id;  ///< Of all other regions.

  [[nodiscard]] std::uint32_t of(region_id region) const {
    const auto found = named.find(region);
    return found == named.end() ? fallback : found->second;
  }
};

/// Of a load case whose materials `assign_materials` took.
[[nodiscard]] region_materials materials_of_regions(const load_case& loads);

/// `invalid_material`: the region has no material.
[[nodiscard]] tl::unexpected<error> refuse_region(region_id region);

/// Errors: `inverted_tet`, `degenerate_tet`, naming the first of these tets and their number.
[[nodiscard]] expected<void> check_shapes(const mesh_version& mesh, std::span<const tet_id> tets);

/// Fills filter, prescribed values and holders. Errors: `invalid_argument` for contradictions, not
/// finite values.
[[nodiscard]] expected<void> add_constraints(const mesh_version& mesh,
                                             const surface_triangles& triangles,
                                             const load_case& loads, problem& p);

/// Fills loads, as the nodal forces that do the same work. Errors: `invalid_load`.
[[nodiscard]] expected<void> add_loads(const surface_triangles& triangles, const load_case& loads,
                                       problem& p);

/// Errors: `under_constrained` for a body with rigid-body motions left.
[[nodiscard]] expected<void> check_supports(const mesh_version& mesh, const problem& p);

}  // namespace tedit::fem
