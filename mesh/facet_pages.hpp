// SPDX-License-Identifier: AGPL-3.0-or-later
// Questions about a version's boundary, answered page by page: what a page of facets holds is found
// out once and kept with it, so that after an edit only the pages around it are read.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "mesh/box.hpp"
#include "mesh/version.hpp"

namespace tedit {

struct surface_size {
  std::uint64_t facets = 0;
  double area_m2 = 0;
};

/// What one page of boundary facets holds.
struct facet_page final : page_facts {
  struct part {
    surface_id surface = 0;
    surface_size size;
  };

  static constexpr std::size_t block = 32;

  std::vector<part> parts;   ///< Ascending by surface.
  box extent;                ///< Of the corners; m.
  std::vector<box> extents;  ///< The same for each `block` slots.
  /// The pages of positions with those corners, ascending, and which they were.
  std::vector<std::pair<std::size_t, hash128>> positions;
};

/// The facts about page `p` of a version's facets. Cost: O(its facets) the first time, and when a
/// page with corners of it has changed; else O(pages of positions).
[[nodiscard]] std::shared_ptr<const facet_page> facet_page_of(const mesh_version& mesh,
                                                              std::size_t p);

/// Facets and area of each surface that has boundary facets. Added up page by page: the same
/// version has the same sums however it came to be. Cost: see `facet_page_of`, for each page.
[[nodiscard]] std::map<surface_id, surface_size> surface_sizes(const mesh_version& mesh);

/// Area of each surface with those of its facets between regions, m^2. Cost: the same, and
/// O(facets between regions).
[[nodiscard]] std::map<surface_id, double> surface_areas(const mesh_version& mesh);

/// Calls `visit(slot)` for each live boundary facet of blocks of slots that reach into the box: for
/// all that meet it, and some more. In slot order. Cost: `facet_page_of`, for each page, and the
/// visits.
template <class Visit>
void for_each_facet_near(const mesh_version& mesh, const box& within, const Visit& visit) {
  constexpr auto per_page = paged_array<boundary_facet>::items_per_page;
  const auto& facets = mesh.data().facets;
  for (std::size_t p = 0; p < facets.pages().size(); ++p) {
    const auto facts = facet_page_of(mesh, p);
    if (!facts->extent.meets(within))
      continue;
    const auto items = facets.page_items(p);
    for (std::size_t i = 0; i < items.size(); ++i)
      if (!facts->extents[i / facet_page::block].meets(within))
        i |= facet_page::block - 1;  // The last of the block.
      else if (items[i].tet != no_id)
        visit(static_cast<facet_id>(p * per_page + i));
  }
}

/// The vertices of the boundary, ascending. Cost: O(vertex slots + facets).
[[nodiscard]] std::vector<vertex_id> boundary_vertices(const mesh_version& mesh);

}  // namespace tedit
