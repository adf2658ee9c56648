// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/build_version.hpp"

namespace tedit::test {

/// The same mesh with vertices, tets and facets in the reverse order: every slot is another.
inline version_ptr renumbered(const mesh_version& mesh) {
  raw_mesh raw;
  const auto last = mesh.vertex_slots() - 1;
  for (vertex_id v = 0; v <= last; ++v)
    raw.positions.push_back(mesh.position(last - v));
  for (tet_id t = mesh.tet_slots(); t-- > 0;) {
    tet turned = mesh.tet_at(t);
    for (auto& v : turned.v)
      v = last - v;
    raw.tets.push_back(turned);
    raw.tet_regions.push_back(mesh.region_of(t));
  }
  for (facet_id f = mesh.facet_slots(); f-- > 0;) {
    auto corners = mesh.facet(f).v;
    for (auto& v : corners)
      v = last - v;
    raw.triangles.push_back({corners, mesh.facet(f).surface, true});
  }
  return build_version(std::move(raw), 1)->version;
}

}  // namespace tedit::test
