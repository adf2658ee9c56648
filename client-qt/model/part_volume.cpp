// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/part_volume.hpp"

#include <optional>

namespace tedit::desktop {

/// By the divergence theorem: the cones from a point of the surface, which keeps sums small, to its
/// facets.
double enclosed_volume(const client::surface_model& surface) {
  double six_times = 0;
  std::optional<vec3> apex;
  surface.facets().for_each([&](std::uint32_t, const client::surface_facet& facet) {
    const vec3 a = *surface.positions().find(facet.v[0]);
    if (!apex)
      apex = a;
    const vec3 b = *surface.positions().find(facet.v[1]) - *apex;
    const vec3 c = *surface.positions().find(facet.v[2]) - *apex;
    six_times += dot(a - *apex, cross(b, c));
  });
  return six_times / 6;
}

}  // namespace tedit::desktop
