// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/shift_patch.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "mesh/box.hpp"
#include "mesh/features/wall_shape.hpp"
#include "mesh/level_set_freedom.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

/// Unit normals whose planes meet at less than this sine are one plane, or next to parallel.
constexpr double same_plane = 1e-6;
constexpr double least_sine = 0.05;

vec3 facet_normal(const mesh_builder& mesh, facet_id f) {
  const auto& v = mesh.facet(f).v;
  return normalized(area_vector(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])));
}

/// The shortest step with normal . step = distance that stays in all planes; nothing when there is
/// none.
std::optional<vec3> step_within(vec3 normal, double distance, const std::vector<vec3>& planes) {
  // The planes' directions one after the other, made orthogonal.
  std::vector<vec3> basis;
  for (const auto& m : planes) {
    vec3 rest = m;
    for (const auto& b : basis)
      rest = rest - dot(rest, b) * b;
    const double size = norm(rest);
    if (size < same_plane)
      continue;
    if (size < least_sine)
      return std::nullopt;
    basis.push_back(rest / size);
    if (basis.size() == 3)
      return std::nullopt;
  }
  vec3 along = normal;
  for (const auto& b : basis)
    along = along - dot(along, b) * b;
  // What is left of the normal in the planes: 0 where a neighbour runs on flush.
  const double share = dot(along, normal);
  if (share < least_sine)
    return std::nullopt;
  return distance / share * along;
}

/// What the neighbours of a patch are, where they are not flat.
class curved_neighbours {
public:
  explicit curved_neighbours(const mesh_builder& mesh) : mesh_(mesh) {}

  /// Would a vertex that stays in their facets' planes leave one of them? A chord of a round wall
  /// is no way along it; of free form nobody knows.
  bool left_by(const surface_patch& patch, vertex_id v, vec3 step) {
    for (const auto near : facets_at(mesh_, v, mesh_.star(v))) {
      const auto id = mesh_.facet(near).surface;
      if (id == patch.surface || std::abs(dot(facet_normal(mesh_, near), patch.normal)) < upright)
        continue;
      const auto& wall = wall_of(id);
      const vec3 p = mesh_.position(v);
      if (!wall.flat && (!wall.shape || std::abs(wall.shape->distance(p + step) -
                                                 wall.shape->distance(p)) > on_wall * norm(step)))
        return true;
    }
    return false;
  }

private:
  /// A facet that stands so nearly along the way is followed by straight lines of its wall.
  static constexpr double upright = 1e-6;
  static constexpr double on_wall = 1e-6;

  struct wall {
    bool flat = false;
    std::optional<wall_shape> shape;
  };

  const wall& wall_of(surface_id id) {
    const auto [row, fresh] = walls_.try_emplace(id);
    if (!fresh)
      return row->second;
    const auto patch = find_patch(mesh_, id);
    row->second.flat = patch && patch->flat();
    if (!row->second.flat)
      row->second.shape =
        fit_wall(*mesh_.base(), facets_of(*mesh_.base(), std::array{id}), round_enough);
    return row->second;
  }

  const mesh_builder& mesh_;
  std::map<surface_id, wall> walls_;
};

/// The planes that a vertex must not leave: those of the neighbours' facets and of faces between
/// regions.
std::vector<vec3> planes_at(const mesh_builder& mesh, const surface_patch& patch, vertex_id v) {
  const auto star = mesh.star(v);
  std::vector<vec3> planes;
  for (const auto near : facets_at(mesh, v, star))
    if (mesh.facet(near).surface != patch.surface)
      planes.push_back(facet_normal(mesh, near));
  for (const auto t : star)
    for (int face = 0; face < 4; ++face) {
      const auto behind = mesh.neighbours(t)[face];
      if (mesh.tet_at(t).v[face] == v || is_facet(behind) || behind < t ||
          mesh.region_of(behind) == mesh.region_of(t))
        continue;
      const auto p = mesh.corners(t);
      const auto& [a, b, c] = tet_faces[face];
      planes.push_back(normalized(area_vector(p[a], p[b], p[c])));
    }
  return planes;
}

/// A step for each vertex of the patch.
std::optional<std::map<vertex_id, vec3>> steps_of(const mesh_builder& mesh,
                                                  const surface_patch& patch, double distance) {
  std::map<vertex_id, vec3> steps;
  curved_neighbours curved(mesh);
  for (const auto f : patch.facets)
    for (const auto v : mesh.facet(f).v) {
      if (steps.contains(v))
        continue;
      const auto step = step_within(patch.normal, distance, planes_at(mesh, patch, v));
      if (!step || (distance > 0 && norm(*step - distance * patch.normal) > 1e-9 * distance) ||
          curved.left_by(patch, v, *step))
        return std::nullopt;
      steps.emplace(v, *step);
    }
  return steps;
}

using triangle = std::array<vec3, 3>;

triangle triangle_of(const mesh_builder& mesh, facet_id f) {
  const auto& v = mesh.facet(f).v;
  return {mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
}

/// Does p lie above the triangle, seen along its normal?
bool over(const triangle& t, vec3 normal, vec3 p) {
  for (int i = 0; i < 3; ++i)
    if (dot(cross(t[(i + 1) % 3] - t[i], p - t[i]), normal) < 0)
      return false;
  return true;
}

/// Would the surface on its way out meet another part of the boundary?
bool runs_into_boundary(const mesh_builder& mesh, const surface_patch& patch,
                        const std::map<vertex_id, vec3>& steps, double distance) {
  std::vector<std::pair<triangle, box>> swept;
  box all;
  for (const auto f : patch.facets) {
    triangle top = triangle_of(mesh, f);
    box extent;
    for (int i = 0; i < 3; ++i) {
      extent.add(top[i]);
      top[i] += steps.at(mesh.facet(f).v[i]);
      extent.add(top[i]);
      all.add(top[i]);
    }
    swept.emplace_back(top, extent);
    all.add(extent.low);
    all.add(extent.high);
  }
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f) ||
        std::ranges::any_of(mesh.facet(f).v, [&](vertex_id v) { return steps.contains(v); }))
      continue;
    const auto other = triangle_of(mesh, f);
    const auto extent = box_of(other);
    if (!extent.meets(all))
      continue;
    for (const auto& [top, reach] : swept)
      if (extent.meets(reach) &&
          (triangles_intersect(top, other) || std::ranges::any_of(other, [&](vec3 p) {
             const double depth = patch.depth(p);
             return depth < 0 && -depth <= distance && over(top, patch.normal, p);
           })))
        return true;
  }
  return false;
}

}  // namespace

bool shift_patch(mesh_builder& mesh, const surface_patch& patch, double distance, double floor) {
  const auto steps = steps_of(mesh, patch, distance);
  if (!steps)
    return false;
  std::set<tet_id> tets;
  for (const auto& [v, step] : *steps)
    for (const auto t : mesh.star(v))
      tets.insert(t);
  for (const auto t : tets) {
    auto p = mesh.corners(t);
    const double before = radius_ratio(p);
    for (int i = 0; i < 4; ++i)
      if (const auto found = steps->find(mesh.tet_at(t).v[i]); found != steps->end())
        p[i] += found->second;
    if (orient3d(p[0], p[1], p[2], p[3]) <= 0 || radius_ratio(p) < std::min(floor, before))
      return false;
  }
  if (distance > 0 && runs_into_boundary(mesh, patch, *steps, distance))
    return false;
  for (const auto& [v, step] : *steps)
    mesh.set_position(v, mesh.position(v) + step);
  return true;
}

}  // namespace tedit
