// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/region_totals.hpp"

#include "mesh/quality.hpp"

namespace tedit {

std::map<region_id, region_total> region_totals(const mesh_version& mesh) {
  std::map<region_id, region_total> totals;
  auto own = totals.end();
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    if (!mesh.is_live_tet(t))
      continue;
    // Those of a region mostly follow each other.
    if (const auto region = mesh.region_of(t); own == totals.end() || own->first != region)
      own = totals.try_emplace(region).first;
    ++own->second.tets;
    own->second.volume += signed_volume(mesh.corners(t));
  }
  return totals;
}

}  // namespace tedit
