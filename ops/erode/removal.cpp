// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/erode/removal.hpp"

#include <algorithm>
#include <map>

namespace tedit::ops {

namespace {

using face_corners = std::array<vertex_id, 3>;

face_corners in_order(face_corners v) {
  std::ranges::sort(v);
  return v;
}

/// The ids of faces between regions.
std::map<face_corners, surface_id> bonds_of(const mesh_builder& mesh) {
  std::map<face_corners, surface_id> result;
  for (const auto& row : mesh.interfaces().to_vector())
    result.emplace(in_order(row.v), row.surface);
  return result;
}

}  // namespace

expected<void> take_off(mesh_builder& mesh, const std::unordered_set<tet_id>& removed,
                        const surface_of_face& name) {
  cavity_change change;
  change.removed.assign(removed.begin(), removed.end());
  std::ranges::sort(change.removed);
  const auto bonds = bonds_of(mesh);
  for (const auto t : change.removed)
    for (int i = 0; i < 4; ++i) {
      const auto behind = mesh.neighbours(t)[i];
      if (is_facet(behind) || removed.contains(behind))
        continue;
      const auto& v = mesh.tet_at(t).v;
      const auto& order = tet_faces[i];
      const std::array<vertex_id, 3> face{v[order[0]], v[order[1]], v[order[2]]};
      const auto bond = bonds.find(in_order(face));
      change.facets.push_back({face, bond == bonds.end() ? name(face) : bond->second});
    }
  if (const auto done = mesh.apply(change); !done)
    return fail(done.error());
  drop_bare_interfaces(mesh);
  return {};
}

void erosion_sum::add(const removal_report& step) {
  removal.hinges_mended += step.hinges_mended;
  removal.crumbs += step.crumbs;
  removal.crumb_volume += step.crumb_volume;
  removal.dropped += step.dropped;
  removal.dropped_volume += step.dropped_volume;
  removal.bodies = step.bodies;
  removal.pieces = step.pieces;
  bodies_added += step.pieces - step.bodies;
}

}  // namespace tedit::ops
