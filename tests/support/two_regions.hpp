// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "tests/support/meshes.hpp"

namespace tedit::test {

/// A box of 1 x 0.5 x 0.5 m of 4 x 2 x 2 cells times `finer` with the surfaces of `box_mesh`:
/// region 4 for x < 0.5 and 90 beyond, with surface 77 between them.
inline version_ptr two_regions(int finer = 1) {
  const auto whole = test::box_mesh({4 * finer, 2 * finer, 2 * finer}, {1, 0.5, 0.5});
  raw_mesh raw;
  for (vertex_id v = 0; v < whole->vertex_slots(); ++v)
    raw.positions.push_back(whole->position(v));
  for (tet_id t = 0; t < whole->tet_slots(); ++t) {
    const auto p = whole->corners(t);
    raw.tets.push_back(whole->tet_at(t));
    raw.tet_regions.push_back((p[0] + p[1] + p[2] + p[3]).x < 2 ? 4 : 90);
  }
  for (facet_id f = 0; f < whole->facet_slots(); ++f)
    raw.triangles.push_back({whole->facet(f).v, whole->facet(f).surface, true});
  for (tet_id t = 0; t < whole->tet_slots(); ++t)
    for (int i = 0; i < 4; ++i) {
      const auto behind = whole->neighbours(t)[i];
      const auto& v = whole->tet_at(t).v;
      if (!is_facet(behind) && behind > t && raw.tet_regions[t] != raw.tet_regions[behind])
        raw.triangles.push_back(
          {{v[tet_faces[i][0]], v[tet_faces[i][1]], v[tet_faces[i][2]]}, 77, true});
    }
  return build_version(std::move(raw), 1)->version;
}

/// The volume of a region, m^3.
inline double region_volume(const mesh_version& mesh, region_id region) {
  double sum = 0;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t) && mesh.region_of(t) == region)
      sum += signed_volume(mesh.corners(t));
  return sum;
}

/// The area of all faces between regions that have a surface, m^2.
inline double interface_area(const mesh_version& mesh) {
  double sum = 0;
  for (const auto& row : mesh.data().interfaces.to_vector())
    sum +=
      norm(area_vector(mesh.position(row.v[0]), mesh.position(row.v[1]), mesh.position(row.v[2])));
  return sum;
}

}  // namespace tedit::test
