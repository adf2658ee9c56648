// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/known_wall.hpp"

#include <algorithm>
#include <cmath>

namespace tedit {

namespace {

/// Of the wall's scale: what is on it. Where faces meet, edges of CAD models are off them by up to
/// that, whatever tolerance the model gives.
constexpr double on_wall = 1e-5;
/// What a mesher or its repair has moved: so much of the corners, or one, by so much.
constexpr double few_corners = 0.03;
constexpr double furthest_off = 0.02;

/// The geometry of the one surface that all facets are of; null where there is none.
const surface_geometry* geometry_of(const mesh_version& mesh, std::span<const facet_id> facets) {
  if (facets.empty())
    return nullptr;
  const auto id = mesh.facet(facets.front()).surface;
  const auto* row = mesh.find_surface(id);
  const bool is_one =
    std::ranges::all_of(facets, [&](facet_id f) { return mesh.facet(f).surface == id; });
  return row && is_one && row->geometry.type != surface_geometry::kind::none ? &row->geometry
                                                                             : nullptr;
}

exact_wall wall_of(const surface_geometry& from) {
  exact_wall wall;
  wall.is_known = true;
  wall.vague = from.tolerance;
  wall.shape.point = from.point;
  wall.shape.axis = from.axis;
  switch (from.type) {
    case surface_geometry::kind::cylinder:
      wall.shape.type = wall_shape::kind::cylinder;
      wall.shape.radius = from.radius;
      break;
    case surface_geometry::kind::cone:
      wall.shape.type = wall_shape::kind::cone;
      wall.shape.radius = from.radius;
      wall.shape.slope = from.slope;
      break;
    case surface_geometry::kind::sphere:
      wall.sphere_radius = from.radius;
      break;
    case surface_geometry::kind::torus:
      wall.shape.radius = from.radius;
      wall.tube_radius = from.tube_radius;
      break;
    case surface_geometry::kind::spline:
      wall.free_form = std::make_shared<const spline_projection>(*from.spline);
      break;
    case surface_geometry::kind::plane:
    case surface_geometry::kind::none:
      break;
  }
  return wall;
}

vec3 middle_of(std::span<const vec3> points) {
  vec3 middle;
  for (const auto& p : points)
    middle += p / static_cast<double>(points.size());
  return middle;
}

/// The point of its axis, or of the plane, that is beside the facets: a cone's radius is that
/// there.
void bring_near(std::span<const vec3> points, exact_wall& wall) {
  auto& shape = wall.shape;
  const double along = dot(middle_of(points) - shape.point, shape.axis);
  if (shape.type == wall_shape::kind::cone || shape.type == wall_shape::kind::cylinder) {
    shape.point += along * shape.axis;
    shape.radius += shape.slope * along;
  } else if (wall.flat()) {
    shape.point = middle_of(points) - along * shape.axis;
  }
}

/// What shares of lengths are taken of, m: the radius, or the facets' extent where that is less, as
/// of a plane. A large arc's share would be more than all of its facets bend.
double scale_of(std::span<const vec3> points, const exact_wall& wall) {
  const vec3 middle = middle_of(points);
  double scale = 0;
  for (const auto& p : points)
    scale = std::max(scale, norm(p - middle));
  if (wall.free_form)
    return std::min(scale, wall.free_form->radius_at(middle));
  for (const double radius : {wall.shape.radius, wall.sphere_radius, wall.tube_radius})
    if (radius > 0)
      scale = std::min(scale, radius);
  return scale;
}

/// Those that its kind has: a torus without a tube is a plane to everybody else.
bool has_radii(surface_geometry::kind type, const exact_wall& wall) {
  return wall.shape.radius >= 0 &&
         (type != surface_geometry::kind::sphere || wall.sphere_radius > 0) &&
         (type != surface_geometry::kind::torus || wall.tube_radius > 0);
}

bool holds(const facet_corners& corners, const exact_wall& wall, double scale) {
  const double near = std::max(on_wall * scale, wall.vague);
  std::size_t beside = 0;
  for (const auto& p : corners.points) {
    const double off = std::abs(wall.distance(p));
    if (!(off <= furthest_off * scale))
      return false;
    beside += off > near ? 1 : 0;
  }
  return beside <= 1 ||
         static_cast<double>(beside) <= few_corners * static_cast<double>(corners.points.size());
}

}  // namespace

bool has_geometries(const mesh_version& mesh) {
  return std::ranges::any_of(mesh.surfaces(), [](const surface_info& row) {
    return row.geometry.type != surface_geometry::kind::none;
  });
}

std::optional<exact_wall> known_wall(const mesh_version& mesh, std::span<const facet_id> facets,
                                     const facet_corners& corners) {
  const auto* geometry = geometry_of(mesh, facets);
  return geometry ? known_wall(*geometry, corners) : std::nullopt;
}

std::optional<exact_wall> stated_wall(const surface_geometry& geometry,
                                      const facet_corners& corners) {
  if (geometry.type == surface_geometry::kind::none || corners.points.empty())
    return std::nullopt;
  auto wall = wall_of(geometry);
  bring_near(corners.points, wall);
  if (!has_radii(geometry.type, wall))
    return std::nullopt;
  wall.vague = std::clamp(wall.vague, 0.0, furthest_off * scale_of(corners.points, wall));
  turn_outward(corners, wall);
  return wall;
}

std::optional<exact_wall> known_wall(const surface_geometry& geometry,
                                     const facet_corners& corners) {
  auto wall = stated_wall(geometry, corners);
  return wall && holds(corners, *wall, scale_of(corners.points, *wall)) ? wall : std::nullopt;
}

std::optional<exact_wall> find_exact(const mesh_version& mesh, std::span<const facet_id> facets) {
  const auto corners = corners_of(mesh, facets);
  auto known = known_wall(mesh, facets, corners);
  return known ? known : fit_exact(corners);
}

surface_geometry geometry_of(const exact_wall& wall) {
  using kind = surface_geometry::kind;
  surface_geometry result;
  result.point = wall.shape.point;
  result.axis = wall.shape.axis;
  result.radius = wall.shape.radius;
  if (wall.sphere_radius > 0) {
    result.type = kind::sphere;
    result.radius = wall.sphere_radius;
  } else if (wall.tube_radius > 0) {
    result.type = kind::torus;
    result.tube_radius = wall.tube_radius;
  } else if (wall.shape.type == wall_shape::kind::plane) {
    result.type = kind::plane;
  } else {
    const bool is_cone = wall.shape.type == wall_shape::kind::cone;
    result.type = is_cone ? kind::cone : kind::cylinder;
    result.slope = is_cone ? wall.shape.slope : 0;
  }
  return result;
}

surface_geometry find_geometry(const mesh_version& mesh, surface_id id) {
  const auto facets = facets_of(mesh, std::array{id});
  const auto corners = corners_of(mesh, facets);
  if (known_wall(mesh, facets, corners))
    return mesh.find_surface(id)->geometry;
  const auto fitted = fit_exact(corners);
  return fitted && (fitted->flat() || has_round_corners(*fitted, corners.points))
           ? geometry_of(*fitted)
           : surface_geometry{};
}

}  // namespace tedit
