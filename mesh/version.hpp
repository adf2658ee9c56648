// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mesh/paged_array.hpp"
#include "mesh/types.hpp"
#include "mesh/vec3.hpp"

namespace tedit {

/// The arrays and tables of a version, before it is frozen. Slots that are not in use form free
/// lists through the tombstones, so that equal editing history gives equal bytes.
struct mesh_data {
  paged_array<vec3> positions;              ///< Metres, by vertex slot.
  paged_array<std::uint32_t> vertex_tet;    ///< One incident tet; free: facet_flag | next slot.
  paged_array<tet> tets;                    ///< By tet slot.
  paged_array<region_id> tet_regions;       ///< By tet slot.
  paged_array<adjacency> neighbours;        ///< By tet slot.
  paged_array<boundary_facet> facets;       ///< By facet slot.
  paged_array<interface_facet> interfaces;  ///< Dense; corners in no particular order.
  /// Of each slot, where its item stands among those of the file that the mesh came from; slots
  /// that were added later stand behind. Empty: in the order of the slots. What is written to
  /// files stands in this order, while slots follow a curve through space (decision 0034).
  paged_array<std::uint32_t> vertex_order;
  paged_array<std::uint32_t> tet_order;
  std::vector<surface_info> surfaces;  ///< Ascending by id.
  std::vector<region_info> regions;    ///< Ascending by id.
  std::uint32_t vertices = 0;          ///< Live counts.
  std::uint32_t live_tets = 0;
  std::uint32_t live_facets = 0;
  std::uint32_t free_vertex = no_id;  ///< Heads of the free lists.
  std::uint32_t free_tet = no_id;
  std::uint32_t free_facet = no_id;
};

/// The list of page identities of all arrays of a version, with its tables and counts: all that
/// is needed to fetch the version from page stores. Its hash is the version's id.
struct manifest {
  /// One row per array of `mesh_data`, in declaration order; the two orders have none where both
  /// are empty.
  struct array_row {
    std::uint64_t size = 0;  ///< Items.
    std::vector<hash128> pages;

    friend bool operator==(const array_row&, const array_row&) = default;
  };

  std::vector<array_row> arrays;
  std::vector<surface_info> surfaces;
  std::vector<region_info> regions;
  std::array<std::uint32_t, 6> counts{};  ///< The six numbers at the end of `mesh_data`.

  /// A canonical byte string; `hash_bytes` of it is the version's id. Where surfaces have a
  /// geometry its tag is another, and these stand at the end.
  [[nodiscard]] std::vector<std::byte> to_bytes() const;

  /// The inverse of `to_bytes`. Bounded: sizes are checked against the bytes that are there.
  /// Errors: `protocol_error`.
  [[nodiscard]] static expected<manifest> from_bytes(std::span<const std::byte> bytes);

  /// All page identities, without duplicates, in order of first use.
  [[nodiscard]] std::vector<hash128> page_ids() const;

  friend bool operator==(const manifest&, const manifest&) = default;
};

/// An immutable mesh with its surfaces. Versions share the pages that did not change; same
/// content has the same id on every machine.
class mesh_version {
public:
  /// Freezes `data`. Cost: hashes the pages that are new.
  [[nodiscard]] static std::shared_ptr<const mesh_version> create(mesh_data data);

  /// Rebuilds a version from its manifest; `find` yields the page with an identity, or null.
  /// Errors: `not_found` when a page is missing, `invalid_mesh` when sizes do not fit.
  [[nodiscard]] static expected<std::shared_ptr<const mesh_version>> from_manifest(
    const manifest& list, const std::function<page_ptr(const hash128&)>& find);

  /// The hash of the manifest.
  [[nodiscard]] const hash128& id() const noexcept { return id_; }
  [[nodiscard]] const mesh_data& data() const noexcept { return data_; }
  [[nodiscard]] const manifest& pages() const noexcept { return manifest_; }

  /// Calls `visit` for each distinct page of the version.
  void for_each_page(const std::function<void(const page_ptr&)>& visit) const;

  // -- counts and access -----------------------------------------------------

  [[nodiscard]] std::uint32_t vertex_count() const noexcept { return data_.vertices; }
  [[nodiscard]] std::uint32_t tet_count() const noexcept { return data_.live_tets; }
  [[nodiscard]] std::uint32_t facet_count() const noexcept { return data_.live_facets; }
  [[nodiscard]] std::uint32_t vertex_slots() const noexcept { return data_.positions.size(); }
  [[nodiscard]] std::uint32_t tet_slots() const noexcept { return data_.tets.size(); }
  [[nodiscard]] std::uint32_t facet_slots() const noexcept { return data_.facets.size(); }

  [[nodiscard]] bool is_live_vertex(vertex_id v) const { return !is_facet(data_.vertex_tet[v]); }
  [[nodiscard]] bool is_live_tet(tet_id t) const { return data_.tets[t].v[0] != no_id; }
  [[nodiscard]] bool is_live_facet(facet_id f) const { return data_.facets[f].tet != no_id; }

  [[nodiscard]] const vec3& position(vertex_id v) const { return data_.positions[v]; }
  [[nodiscard]] const tet& tet_at(tet_id t) const { return data_.tets[t]; }
  [[nodiscard]] region_id region_of(tet_id t) const { return data_.tet_regions[t]; }
  [[nodiscard]] const adjacency& neighbours(tet_id t) const { return data_.neighbours[t]; }
  [[nodiscard]] const boundary_facet& facet(facet_id f) const { return data_.facets[f]; }
  [[nodiscard]] tet_id incident_tet(vertex_id v) const { return data_.vertex_tet[v]; }
  [[nodiscard]] const std::vector<surface_info>& surfaces() const { return data_.surfaces; }
  [[nodiscard]] const std::vector<region_info>& regions() const { return data_.regions; }

  /// The table row of a surface, or null.
  [[nodiscard]] const surface_info* find_surface(surface_id id) const;

  /// The four corner positions of a tet.
  [[nodiscard]] std::array<vec3, 4> corners(tet_id t) const;

private:
  mesh_version() = default;

  mesh_data data_;
  manifest manifest_;
  hash128 id_;
};

using version_ptr = std::shared_ptr<const mesh_version>;

/// Sum of the tet volumes in m^3.
[[nodiscard]] double total_volume(const mesh_version& mesh);

/// The boundary facets of each of the given surfaces, in slot order. Cost: O(facets) of the pages
/// that hold some of them (mesh/facet_pages.hpp).
[[nodiscard]] std::vector<facet_id> facets_of(const mesh_version& mesh,
                                              std::span<const surface_id> surfaces);

/// Adds to `star` the tet `from` and those that hang together with it over faces at its corner v,
/// unless it is there already. Wrong neighbours lead nowhere else. Cost: O(star^2), a star has some
/// twenty tets.
void grow_star(const mesh_version& mesh, vertex_id v, tet_id from, std::vector<tet_id>& star);

/// The live tets that hold one of the vertices, found over faces from each vertex' incident tet,
/// ascending; free vertices are skipped. Cost: O(stars), not O(mesh).
[[nodiscard]] std::vector<tet_id> tets_around(const mesh_version& mesh,
                                              std::span<const vertex_id> vertices);

/// Area vector (outward normal times area, m^2) of a triangle.
[[nodiscard]] vec3 area_vector(vec3 a, vec3 b, vec3 c);
[[nodiscard]] vec3 area_vector(const mesh_version& mesh, const boundary_facet& facet);

}  // namespace tedit
