// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/formats.hpp"
#include "mesh/io/compaction.hpp"

namespace tedit {

/// The vertices of the boundary, as files of it number them. Cost: O(n log n).
[[nodiscard]] inline compaction boundary_vertices_of_file(const mesh_version& mesh) {
  std::vector<bool> on_boundary(mesh.vertex_slots());
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      for (const auto v : mesh.facet(f).v)
        on_boundary[v] = true;
  return compact(mesh.vertex_slots(), mesh.data().vertex_order,
                 [&](vertex_id v) -> bool { return on_boundary[v]; });
}

/// The colour of a surface in a file, sRGB; grey where it was given none.
[[nodiscard]] inline byte_colour colour_of_surface(const file_colours& colours,
                                                   surface_id surface) {
  constexpr byte_colour colour_of_none{176, 176, 176};
  const auto found = colours.of_surfaces.find(surface);
  return found == colours.of_surfaces.end() ? colour_of_none : found->second;
}

}  // namespace tedit
