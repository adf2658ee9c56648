// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "tests/support/meshes.hpp"

namespace tedit::test {

/// The surface between both.
inline constexpr surface_id bond = 9;

/// m^3, of one region.
inline double volume_of(const mesh_version& mesh, region_id region) {
  double sum = 0;
  for (const auto t : all_tets(mesh))
    if (mesh.region_of(t) == region)
      sum += signed_volume(mesh.corners(t));
  return sum;
}

/// m^2, of a wall; what of the surface lies between regions does not count.
inline double boundary_area(const mesh_version& mesh, surface_id surface) {
  double sum = 0;
  for (const auto f : facets_of(mesh, std::vector{surface}))
    sum += norm(area_vector(mesh, mesh.facet(f)));
  return sum;
}

/// `box_mesh` with region 1 where x is below its middle and region 2 beyond, bonded there; without
/// a surface id between them unless `named`.
inline version_ptr bonded_boxes(std::array<int, 3> cells, vec3 size, bool named = true) {
  const auto plain = box_mesh(cells, size);
  raw_mesh raw;
  for (vertex_id v = 0; v < plain->vertex_slots(); ++v)
    raw.positions.push_back(plain->position(v));
  for (const auto t : all_tets(*plain)) {
    const auto c = plain->corners(t);
    const bool left = c[0].x + c[1].x + c[2].x + c[3].x < 2 * size.x;
    raw.tets.push_back(plain->tet_at(t));
    raw.tet_regions.push_back(left ? 1 : 2);
    for (int i = 0; named && left && i < 4; ++i) {
      const auto& f = tet_faces[i];
      const auto& v = plain->tet_at(t).v;
      if (2 * std::min({c[f[0]].x, c[f[1]].x, c[f[2]].x}) == size.x)
        raw.triangles.push_back({{v[f[0]], v[f[1]], v[f[2]]}, bond, true});
    }
  }
  for (facet_id f = 0; f < plain->facet_slots(); ++f)
    raw.triangles.push_back({plain->facet(f).v, plain->facet(f).surface, true});
  return build_version(std::move(raw), 1)->version;
}

}  // namespace tedit::test
