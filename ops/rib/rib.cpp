// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/rib/rib.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/features/wall_shape.hpp"
#include "ops/tools/placement.hpp"

namespace tedit::ops {

namespace {

/// Walls whose normals differ by less than 10 degrees from each other's opposite face each other.
constexpr double least_sine = 0.1736;

/// A wall where the rib meets it.
struct wall_plane {
  vec3 point;
  vec3 normal;  ///< Unit, outward.
  bool flat = false;
};

expected<wall_plane> plane_of(const mesh_version& mesh, surface_id id,
                              const std::optional<vec3>& at) {
  const auto middle = middle_of(mesh, id);
  if (!middle)
    return fail(middle.error());
  wall_plane result{middle->point, middle->normal, false};
  const auto facets = facets_of(mesh, std::array{id});
  if (const auto shape = fit_wall(mesh, facets); shape && shape->type == wall_shape::kind::plane) {
    result = {shape->point, shape->axis, true};
  } else if (at) {
    double nearest = 1e300;
    for (const auto f : facets) {
      const auto& v = mesh.facet(f).v;
      const vec3 p = (mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2])) / 3;
      if (const double d = norm(p - *at); d < nearest) {
        nearest = d;
        result.point = p;
        result.normal = normalized(area_vector(mesh, mesh.facet(f)));
      }
    }
  }
  return result;
}

/// The point on three planes, given by normals and offsets.
vec3 common_point(const std::array<vec3, 3>& n, const std::array<double, 3>& d) {
  const double det = dot(n[0], cross(n[1], n[2]));
  return (d[0] * cross(n[1], n[2]) + d[1] * cross(n[2], n[0]) + d[2] * cross(n[0], n[1])) / det;
}

/// The rib's outline in its middle plane.
struct flat_rib {
  frame place;  ///< z across the rib.
  std::vector<std::array<double, 2>> points;
};

/// In the corner of two walls; `over` (m): how far it reaches into each.
flat_rib gusset(const wall_plane& a, const wall_plane& b, const rib_shape& shape,
                const std::array<double, 2>& over) {
  const vec3 across = normalized(cross(a.normal, b.normal));
  const vec3 at = shape.at.value_or(0.5 * (a.point + b.point));
  const vec3 corner =
    common_point({a.normal, b.normal, across},
                 {dot(a.normal, a.point), dot(b.normal, b.point), dot(across, at)});
  vec3 along_a = normalized(cross(across, a.normal));
  if (dot(along_a, b.normal) < 0)
    along_a = -along_a;
  vec3 along_b = normalized(cross(across, b.normal));
  if (dot(along_b, a.normal) < 0)
    along_b = -along_b;
  const vec3 end_a = corner + shape.size * along_a;
  const vec3 end_b = corner + shape.size * along_b;
  std::vector<vec3> points{end_a, end_b};
  if (over[1] > 0)
    points.push_back(end_b - over[1] * b.normal);
  // The corner of both walls moved inward.
  points.push_back(common_point(
    {a.normal, b.normal, across},
    {dot(a.normal, a.point) - over[0], dot(b.normal, b.point) - over[1], dot(across, at)}));
  if (over[0] > 0)
    points.push_back(end_a - over[0] * a.normal);
  flat_rib rib{make_frame(corner, across, along_b), {}};
  for (const auto& p : points)
    rib.points.push_back({dot(p - corner, rib.place.x), dot(p - corner, rib.place.y)});
  return rib;
}

/// From one wall to the one across.
flat_rib bridge(const wall_plane& a, const wall_plane& b, const rib_shape& shape, vec3 up,
                const std::array<double, 2>& over) {
  const vec3 at = shape.at.value_or(0.5 * (a.point + b.point));
  const vec3 standing = normalized(up - dot(up, a.normal) * a.normal);
  const vec3 across = cross(a.normal, standing);
  flat_rib rib{{at, a.normal, standing, across}, {}};
  // Where lines along the first wall's normal meet both, low and high.
  const auto reach = [&](const wall_plane& wall, double y, double more) {
    const vec3 from = rib.place.at(0, y, 0);
    return dot(wall.point - from, wall.normal) / dot(a.normal, wall.normal) + more;
  };
  const double low = -shape.size / 2;
  const double high = shape.size / 2;
  rib.points = {{reach(a, low, -over[0]), low},
                {reach(b, low, over[1]), low},
                {reach(b, high, over[1]), high},
                {reach(a, high, -over[0]), high}};
  return rib;
}

expected<flat_rib> outline_of(const wall_plane& a, const wall_plane& b, const rib_shape& shape,
                              const std::array<double, 2>& over) {
  if (norm(cross(a.normal, b.normal)) > least_sine)
    return gusset(a, b, shape, over);
  if (dot(a.normal, b.normal) > 0 || dot(b.point - a.point, a.normal) <= 0)
    return fail(ec::invalid_argument,
                "the walls neither meet in an inner corner nor face each other",
                "Pick two walls with the rib's space between them");
  if (!shape.direction)
    return fail(ec::invalid_parameter,
                "the walls face each other: it is not known which way the rib stands",
                "Give direction=x,y,z along the walls");
  if (norm(cross(*shape.direction, a.normal)) < least_sine * norm(*shape.direction))
    return fail(ec::invalid_parameter, "the direction goes from wall to wall",
                "Give one along the walls");
  return bridge(a, b, shape, *shape.direction, over);
}

}  // namespace

rib_shape rib_shape_of(const parameters& values) {
  return {std::get<double>(values.at("thickness")), std::get<double>(values.at("size")),
          vector_of(values, "at"), vector_of(values, "direction")};
}

expected<rib_prism> rib_prism_of(const mesh_version& mesh, const std::vector<surface_id>& walls,
                                 const rib_shape& shape) {
  if (walls.size() != 2)
    return fail(ec::invalid_argument, "a rib stands between two walls", "Pick two walls");
  const auto a = plane_of(mesh, walls[0], shape.at);
  const auto b = plane_of(mesh, walls[1], shape.at);
  if (!a || !b)
    return fail(a ? b.error() : a.error());
  box near;
  near.add(shape.at.value_or(0.5 * (a->point + b->point)));
  const double local = local_size(mesh, near.grown(shape.size));
  const double into = 0.2 * local;
  auto rib = outline_of(*a, *b, shape, {a->flat ? 0 : into, b->flat ? 0 : into});
  if (!rib)
    return fail(rib.error());
  return rib_prism{rib->place, std::move(rib->points), shape.thickness, local};
}

expected<edit_result> add_rib(const version_ptr& mesh, const std::vector<surface_id>& walls,
                              const rib_shape& shape, context& ctx) {
  const auto rib = rib_prism_of(*mesh, walls, shape);
  if (!rib)
    return fail(rib.error());
  const double local = rib->local;
  const double size = std::min({local, shape.size / 2, 3 * shape.thickness});
  const placement where{rib->place.origin, rib->place.z, local};
  if (auto ok = check_fineness(where, size, shape.size + shape.thickness); !ok)
    return fail(ok.error());
  const auto tool = extrude(rib->place, polygon(rib->points), -shape.thickness / 2,
                            shape.thickness / 2, size, "rib", *ctx.host);
  if (!tool)
    return fail(tool.error());
  auto result = apply_tool(mesh, *tool, boolean_mode::add, local, walls, ctx);
  if (!result)
    return result;
  for (const auto wall : walls)
    if (facets_of(*mesh, std::array{wall}) == facets_of(*result->candidate, std::array{wall}))
      return fail(ec::invalid_argument, "the rib would not touch surface " + std::to_string(wall),
                  "Move it: at_mm=x,y,z, or make it larger");
  return result;
}

}  // namespace tedit::ops
