// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "client/surface.hpp"
#include "mesh/version.hpp"

namespace tedit::simulation {

/// Whether what a client holds is the boundary of this version, slot for slot and bit for bit.
inline bool shows(const client::surface_model& shown, const mesh_version& mesh) {
  if (shown.version_id() != to_hex(mesh.id()) || shown.total_facets() != mesh.facet_count())
    return false;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    const auto& facet = mesh.facet(f);
    if (facet.tet == no_id)
      continue;
    const auto* there = shown.facets().find(f);
    if (!there || there->v != facet.v || there->surface != facet.surface)
      return false;
    for (const auto v : facet.v) {
      const auto* at = shown.positions().find(v);
      if (!at || !(*at == mesh.position(v)))
        return false;
    }
  }
  return true;
}

}  // namespace tedit::simulation
