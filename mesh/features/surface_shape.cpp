// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/surface_shape.hpp"

#include <array>
#include <numbers>

#include "mesh/features/rims.hpp"

namespace tedit {

bool surface_shape::concave() const {
  return turning > 0.5 * std::numbers::pi / 180;
}

surface_shape shape_of(const mesh_version& mesh, surface_id id) {
  surface_shape shape;
  const std::array list{id};
  shape.facets = facets_of(mesh, list);
  double inner = 0;
  for (const auto f : shape.facets) {
    const auto& v = mesh.facet(f).v;
    shape.area += norm(area_vector(mesh, mesh.facet(f)));
    for (int i = 0; i < 3; ++i) {
      const auto other = mesh.facet(facet_across(mesh, f, i)).surface;
      const double edge = norm(mesh.position(v[(i + 1) % 3]) - mesh.position(v[i]));
      const double angle = material_angle(mesh, f, i);
      if (other == id) {
        shape.turning += edge * (angle - std::numbers::pi);
        inner += edge;
      } else {
        auto& joint = shape.joints[other];
        joint.length += edge;
        joint.angle += edge * angle;
      }
    }
  }
  shape.turning = inner > 0 ? shape.turning / inner : 0;
  for (auto& [other, joint] : shape.joints)
    joint.angle = joint.length > 0 ? joint.angle / joint.length : 0;
  return shape;
}

}  // namespace tedit
