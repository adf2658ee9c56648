// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/file_surfaces.hpp"

#include <algorithm>

#include "mesh/face_key.hpp"

namespace tedit {

namespace {

/// The face of the tet that has these corners; 4 where none has.
int face_with(const tet& t, const std::array<vertex_id, 3>& corners) {
  const auto key = make_face_key(corners).v;
  int face = 0;
  while (face < 4 && make_face_key(t, face).v != key)
    ++face;
  return face;
}

void add_interfaces(const mesh_version& mesh, std::map<surface_id, std::vector<tet_side>>& sides) {
  const auto& interfaces = mesh.data().interfaces;
  if (interfaces.size() == 0)
    return;
  std::map<std::array<vertex_id, 3>, surface_id> wanted;
  for (std::size_t i = 0; i < interfaces.size(); ++i)
    wanted.try_emplace(make_face_key(interfaces[i].v).v, interfaces[i].surface);
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    if (!mesh.is_live_tet(t))
      continue;
    for (int face = 0; face < 4; ++face) {
      const auto other = mesh.neighbours(t)[static_cast<std::size_t>(face)];
      if (is_facet(other) || mesh.region_of(other) == mesh.region_of(t))
        continue;
      const auto found = wanted.find(make_face_key(mesh.tet_at(t), face).v);
      if (found == wanted.end())
        continue;
      sides[found->second].push_back({t, face});
      wanted.erase(found);
    }
  }
}

}  // namespace

std::array<vertex_id, 3> corners_of(const mesh_version& mesh, tet_side side) {
  const auto& order = tet_faces[static_cast<std::size_t>(side.face)];
  const auto& v = mesh.tet_at(side.tet).v;
  return {v[static_cast<std::size_t>(order[0])], v[static_cast<std::size_t>(order[1])],
          v[static_cast<std::size_t>(order[2])]};
}

std::map<surface_id, std::vector<tet_side>> sides_of_surfaces(const mesh_version& mesh) {
  std::map<surface_id, std::vector<tet_side>> sides;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f)) {
      const auto& facet = mesh.facet(f);
      sides[facet.surface].push_back({facet.tet, face_with(mesh.tet_at(facet.tet), facet.v)});
    }
  add_interfaces(mesh, sides);
  return sides;
}

}  // namespace tedit
