// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>

#include "mesh/builder.hpp"

namespace tedit::test {

/// Takes away the tets whose centroid is `inside`; the new faces get surface `id`.
inline version_ptr dig(const version_ptr& mesh, const std::function<bool(vec3)>& inside,
                       surface_id id) {
  cavity_change change;
  const auto goes = [&](tet_id t) {
    const auto c = mesh->corners(t);
    return inside(0.25 * (c[0] + c[1] + c[2] + c[3]));
  };
  for (tet_id t = 0; t < mesh->tet_slots(); ++t) {
    if (!mesh->is_live_tet(t) || !goes(t))
      continue;
    change.removed.push_back(t);
    for (int i = 0; i < 4; ++i) {
      const auto behind = mesh->neighbours(t)[i];
      if (is_facet(behind) || goes(behind))
        continue;
      auto face = mesh->tet_at(t).v;
      std::swap(face[i], face[3]);
      change.facets.push_back({{face[0], face[1], face[2]}, id});
    }
  }
  mesh_builder builder(mesh);
  if (!builder.apply(change))
    return nullptr;
  return builder.freeze();
}

/// Cuts each tet that is `chosen` into four at its centroid.
inline version_ptr split(const version_ptr& mesh, const std::function<bool(tet_id)>& chosen) {
  mesh_builder builder(mesh);
  for (tet_id t = 0; t < mesh->tet_slots(); ++t) {
    if (!mesh->is_live_tet(t) || !chosen(t))
      continue;
    const auto c = mesh->corners(t);
    const auto middle = builder.add_vertex(0.25 * (c[0] + c[1] + c[2] + c[3]));
    cavity_change change;
    change.removed = {t};
    for (int i = 0; i < 4; ++i) {
      auto v = mesh->tet_at(t).v;
      v[i] = middle;
      change.added.push_back({v, mesh->region_of(t)});
    }
    if (!builder.apply(change))
      return nullptr;
  }
  return builder.freeze();
}

/// Moves vertices.
inline version_ptr move(const version_ptr& mesh, const std::function<vec3(vec3)>& place) {
  mesh_builder builder(mesh);
  for (vertex_id v = 0; v < mesh->vertex_slots(); ++v)
    if (mesh->is_live_vertex(v) && place(mesh->position(v)) != mesh->position(v))
      builder.set_position(v, place(mesh->position(v)));
  return builder.freeze();
}

}  // namespace tedit::test
