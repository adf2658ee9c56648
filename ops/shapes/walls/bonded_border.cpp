// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/bonded_border.hpp"

#include <algorithm>
#include <cmath>

namespace tedit::ops {

namespace {

/// Tets along a ray are counted, so that rounding cannot lead in a circle.
constexpr int most_tets = 1000;
/// Which faces are at an edge, in its lengths: so far from its middle; from this above it.
constexpr double beside = 0.8;
constexpr double no_depth = 1e-6;

std::array<vec3, 3> face_of(const mesh_version& mesh, tet_id t, int face) {
  const auto p = mesh.corners(t);
  const auto& f = tet_faces[face];
  return {p[f[0]], p[f[1]], p[f[2]]};
}

/// How far a ray that enters tet t through `face` goes until the region or the part ends.
double way_through(const mesh_version& mesh, tet_id t, int face, vec3 from, vec3 direction) {
  const auto region = mesh.region_of(t);
  double way = 0;
  for (int n = 0; n < most_tets; ++n) {
    int out = -1;
    double least = 1e300;
    for (int k = 0; k < 4; ++k) {
      const auto p = face_of(mesh, t, k);
      const vec3 outward = area_vector(p[0], p[1], p[2]);
      const double speed = dot(outward, direction);
      const double distance = dot(outward, p[0] - from) / speed;
      if (k != face && speed > 0 && distance < least) {
        least = distance;
        out = k;
      }
    }
    if (out < 0)
      return way;
    way = std::max(way, least);
    const auto behind = mesh.neighbours(t)[out];
    if (is_facet(behind) || mesh.region_of(behind) != region)
      return way;
    for (int k = 0; k < 4; ++k)
      if (mesh.neighbours(behind)[k] == t)
        face = k;
    t = behind;
  }
  return way;
}

double room_behind(const mesh_version& mesh, tet_id t, int face) {
  const auto p = face_of(mesh, t, face);
  const auto behind = mesh.neighbours(t)[face];
  int back = 0;
  for (int k = 0; k < 4; ++k)
    if (mesh.neighbours(behind)[k] == t)
      back = k;
  return way_through(mesh, behind, back, (p[0] + p[1] + p[2]) / 3,
                     normalized(area_vector(p[0], p[1], p[2])));
}

/// The unit direction from the line a b to p, square to it.
vec3 away_from(vec3 a, vec3 b, vec3 p) {
  const vec3 along = normalized(b - a);
  return normalized(p - a - dot(p - a, along) * along);
}

}  // namespace

std::optional<bonded_border> bonded_border_at(const mesh_version& mesh, facet_id f, int edge) {
  const auto& facet = mesh.facet(f);
  const auto a = facet.v[edge];
  const auto b = facet.v[(edge + 1) % 3];
  const auto region = mesh.region_of(facet.tet);
  auto t = facet.tet;
  auto leave = facet.v[(edge + 2) % 3];
  while (true) {
    // A tet has two faces at the edge: it is left by the one opposite the corner it was entered by.
    const auto& corners = mesh.tet_at(t).v;
    int face = 0;
    auto other = no_id;
    for (int i = 0; i < 4; ++i) {
      if (corners[i] == leave)
        face = i;
      else if (corners[i] != a && corners[i] != b)
        other = corners[i];
    }
    const auto behind = mesh.neighbours(t)[face];
    if (is_facet(behind))
      return std::nullopt;
    if (mesh.region_of(behind) != region)
      return bonded_border{away_from(mesh.position(a), mesh.position(b), mesh.position(other)),
                           room_behind(mesh, t, face)};
    t = behind;
    leave = other;
  }
}

std::vector<bond_triangle> bonds_in(const mesh_version& mesh, const box& where) {
  std::vector<bond_triangle> result;
  const auto& rows = mesh.data().interfaces;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& v = rows[i].v;
    const bond_triangle p{mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
    if (where.meets(box_of(p)))
      result.push_back(p);
  }
  return result;
}

double bulge_over(const std::vector<bond_triangle>& bonds, vec3 a, vec3 b, vec3 down,
                  double depth) {
  const vec3 along = b - a;
  const vec3 away = normalized(cross(down, along));
  // In edges, from the middle of this one.
  const auto aside = [&](vec3 p) { return std::abs(dot(p - a, along) / dot(along, along) - 0.5); };
  double most = 0;
  for (const auto& triangle : bonds) {
    const bool is_there = std::ranges::any_of(triangle, [&](vec3 p) {
      const double deep = dot(p - a, down);
      return aside(p) < beside && deep > -no_depth * norm(along) && deep < depth;
    });
    for (const auto& p : triangle)
      if (is_there && aside(p) < beside)
        most = std::max(most, dot(p - a, away));
  }
  return most;
}

}  // namespace tedit::ops
