// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <unordered_set>
#include <vector>

#include "mesh/version.hpp"

namespace tedit {

/// A tet to add.
struct new_tet {
  tet corners;
  region_id region = 0;
};

/// Says which surface a new boundary triangle belongs to; the corners may stand in any order.
struct new_facet {
  std::array<vertex_id, 3> v;
  surface_id surface = 0;
};

/// One local change of topology. After it, every face of an added tet must lie against another
/// added tet, against a kept tet at the cavity's wall, against a glued facet's tet, or be a
/// boundary facet: one that a removed tet had (its surface is kept), or one named in `facets`. A
/// facet of a removed tet that comes to lie between two added ones goes.
/// Faces of kept tets that lose their neighbour become boundary facets and must be named, too.
struct cavity_change {
  std::vector<tet_id> removed;
  std::vector<new_tet> added;
  std::vector<facet_id> glued;    ///< Boundary facets of kept tets that added tets cover.
  std::vector<new_facet> facets;  ///< Surfaces of new boundary facets.
};

/// Copy-on-write editing of a version. Slots keep their numbers; adjacency, incident tets and
/// boundary facets are kept up to date locally, so cost follows the change and not the mesh.
/// Not thread-safe.
class mesh_builder {
public:
  explicit mesh_builder(version_ptr base);

  // -- reading the current state ----------------------------------------------

  [[nodiscard]] const version_ptr& base() const { return base_; }
  [[nodiscard]] std::uint32_t vertex_slots() const { return positions_.size(); }
  [[nodiscard]] std::uint32_t tet_slots() const { return tets_.size(); }
  [[nodiscard]] std::uint32_t facet_slots() const { return facets_.size(); }
  [[nodiscard]] std::uint32_t tet_count() const { return counts_.live_tets; }
  [[nodiscard]] bool is_live_vertex(vertex_id v) const { return !is_facet(vertex_tet_[v]); }
  [[nodiscard]] bool is_live_tet(tet_id t) const { return tets_[t].v[0] != no_id; }
  [[nodiscard]] bool is_live_facet(facet_id f) const { return facets_[f].tet != no_id; }
  [[nodiscard]] const vec3& position(vertex_id v) const { return positions_[v]; }
  [[nodiscard]] const tet& tet_at(tet_id t) const { return tets_[t]; }
  [[nodiscard]] region_id region_of(tet_id t) const { return tet_regions_[t]; }
  [[nodiscard]] const adjacency& neighbours(tet_id t) const { return neighbours_[t]; }
  [[nodiscard]] const boundary_facet& facet(facet_id f) const { return facets_[f]; }
  [[nodiscard]] std::array<vec3, 4> corners(tet_id t) const;
  [[nodiscard]] const paged_array<interface_facet>& interfaces() const {
    return counts_.interfaces;
  }

  /// The tets around a vertex, found over shared faces. Cost: O(star).
  [[nodiscard]] std::vector<tet_id> star(vertex_id v) const;

  /// The tets that hold both vertices. Cost: O(star of a).
  [[nodiscard]] std::vector<tet_id> edge_ring(vertex_id a, vertex_id b) const;

  /// True when a boundary facet touches the vertex. Cost: O(star).
  [[nodiscard]] bool is_boundary_vertex(vertex_id v) const;

  // -- changing ---------------------------------------------------------------

  /// A vertex without tets: it must be used by an added tet before `freeze`, else it is freed.
  vertex_id add_vertex(vec3 position);

  void set_position(vertex_id v, vec3 position);

  /// Applies one change and returns the new tets' ids, in the order of `added`. Vertices that no
  /// tet uses any more are freed.
  /// Errors: `invalid_mesh` naming the face that does not fit; then nothing has changed.
  /// Cost: O(change).
  [[nodiscard]] expected<std::vector<tet_id>> apply(const cavity_change& change);

  /// Gives all facets named another surface.
  void set_surface(facet_id f, surface_id surface);

  /// Replaces the list of interface facets: `apply` leaves it alone, so who splits or removes tets
  /// between regions brings it up to date.
  void set_interfaces(const std::vector<interface_facet>& facets);

  /// A new surface with an id that the table has not had (largest id + 1).
  surface_id add_surface(std::string name, surface_geometry geometry = {});
  /// A surface that an earlier version had, under its own id; nothing where the table has it.
  void restore_surface(surface_id id, std::string name, surface_geometry geometry = {});

  /// Tets added or with a moved vertex since the builder was made, live ones, ascending.
  [[nodiscard]] std::vector<tet_id> touched() const;

  /// Freezes the current state to a version. Surfaces without facets leave the table, vertices
  /// without tets are freed. The builder stays usable.
  [[nodiscard]] version_ptr freeze();

private:
  struct face_entry;
  class face_group;
  struct link_plan;

  [[nodiscard]] std::uint8_t local_face(tet_id t, std::uint32_t behind) const;
  [[nodiscard]] expected<std::vector<face_entry>> faces_of_change(
    const cavity_change& change) const;
  [[nodiscard]] expected<void> link_face(std::span<const face_entry> entries,
                                         const cavity_change& change, link_plan& links) const;
  [[nodiscard]] expected<link_plan> plan(const cavity_change& change) const;
  void detach(const cavity_change& change, const link_plan& links);
  std::vector<tet_id> attach(const cavity_change& change, const link_plan& links);
  void repair_vertices(const std::vector<vertex_id>& suspects, std::span<const tet_id> candidates);
  void count_tets(const tet& corners, int change);
  void count_all_tets();
  tet_id take_tet_slot();
  facet_id take_facet_slot();
  void free_tet_slot(tet_id t);
  void free_facet_slot(facet_id f);
  void free_vertex_slot(vertex_id v);

  version_ptr base_;
  paged_array_builder<vec3> positions_;
  paged_array_builder<std::uint32_t> vertex_tet_;
  paged_array_builder<tet> tets_;
  paged_array_builder<region_id> tet_regions_;
  paged_array_builder<adjacency> neighbours_;
  paged_array_builder<boundary_facet> facets_;
  paged_array_builder<std::uint32_t> vertex_order_;
  paged_array_builder<std::uint32_t> tet_order_;
  mesh_data counts_;  ///< Tables, counts and free lists; its arrays stay empty.
  surface_id largest_surface_ = 0;
  std::unordered_set<tet_id> touched_;
  std::unordered_set<vertex_id> loose_vertices_;
  /// Live tets at each vertex slot, kept up to date from the first time that it is asked for.
  std::vector<std::uint32_t> tets_at_;
};

}  // namespace tedit
