// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/fill_hole/gates.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/predicates.hpp"

namespace tedit::ops {

namespace {

struct box {
  vec3 low{1e300, 1e300, 1e300};
  vec3 high{-1e300, -1e300, -1e300};

  void add(vec3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  [[nodiscard]] bool meets(const box& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y &&
           low.z <= b.high.z && b.low.z <= high.z;
  }
};

template <std::size_t N>
box box_of(const std::array<vec3, N>& points) {
  box result;
  for (const auto& p : points)
    result.add(p);
  return result;
}

struct placed_triangle {
  std::array<vec3, 3> p;
  std::array<vertex_id, 3> v;  ///< no_id for cap points.
  box extent;
};

expected<void> check_closed(const plug_surface& plug) {
  std::unordered_set<std::uint64_t> edges;
  const auto key = [](std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32 | b; };
  for (const auto& t : plug.surface.triangles)
    for (int i = 0; i < 3; ++i)
      if (!edges.insert(key(t[i], t[(i + 1) % 3])).second)
        return fail(ec::not_a_hole, "walls and caps do not form a clean closed surface",
                    "Select the walls of one hole, without surfaces beside it");
  for (const auto edge : edges)
    if (!edges.contains(edge << 32 | edge >> 32))
      return fail(ec::not_a_hole, "walls and caps do not close",
                  "Select all wall surfaces of the hole");
  return {};
}

expected<void> check_volume(const plug_surface& plug) {
  const auto& points = plug.surface.points;
  double area = 0;
  box extent;
  for (const auto& t : plug.surface.triangles)
    area += norm(area_vector(points[t[0]], points[t[1]], points[t[2]]));
  for (const auto& p : points)
    extent.add(p);
  const double size = norm(extent.high - extent.low);
  if (plug.volume < -1e-6 * area * size)
    return fail(ec::not_a_hole, "the selected surfaces bound material, not a hole",
                "Select the inner walls of a hole");
  if (plug.volume < 1e-3 * area * size / 6)
    return fail(ec::flat_plug, "there is no space to fill: the selected surfaces are flat",
                "Select the walls of a hole");
  return {};
}

bool share_a_corner(const placed_triangle& a, const std::array<vertex_id, 3>& v) {
  return std::ranges::any_of(
    a.v, [&](vertex_id i) { return i != no_id && std::ranges::count(v, i) > 0; });
}

std::vector<placed_triangle> placed_caps(const plug_surface& plug) {
  std::vector<placed_triangle> result;
  for (const auto& c : plug.caps)
    for (const auto& t : c.triangles) {
      placed_triangle placed;
      for (int i = 0; i < 3; ++i) {
        placed.p[i] = plug.surface.points[t[i]];
        placed.v[i] = plug.vertices[t[i]];
      }
      placed.extent = box_of(placed.p);
      result.push_back(placed);
    }
  return result;
}

tl::unexpected<error> cuts(const mesh_version& mesh, const boundary_facet& facet) {
  const vec3 at = mesh.position(facet.v[0]);
  char where[96];
  std::snprintf(where, sizeof(where), "(%.4g, %.4g, %.4g) mm", 1e3 * at.x, 1e3 * at.y, 1e3 * at.z);
  return fail(ec::cap_intersects,
              "a cap over the hole would cut surface " + std::to_string(facet.surface),
              "Select all surfaces inside the hole, or fill what stands in it first", where);
}

expected<void> check_boundary(const mesh_version& mesh, const std::vector<placed_triangle>& caps,
                              const box& all) {
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    const auto& facet = mesh.facet(f);
    const std::array<vec3, 3> p{mesh.position(facet.v[0]), mesh.position(facet.v[1]),
                                mesh.position(facet.v[2])};
    const box extent = box_of(p);
    if (!extent.meets(all))
      continue;
    for (const auto& c : caps)
      if (c.extent.meets(extent) && !share_a_corner(c, facet.v) && triangles_intersect(c.p, p))
        return cuts(mesh, facet);
  }
  return {};
}

bool holds(const std::array<vec3, 4>& c, vec3 p) {
  return orient3d(p, c[1], c[2], c[3]) > 0 && orient3d(c[0], p, c[2], c[3]) > 0 &&
         orient3d(c[0], c[1], p, c[3]) > 0 && orient3d(c[0], c[1], c[2], p) > 0;
}

expected<void> check_outside(const mesh_version& mesh, const std::vector<placed_triangle>& caps,
                             const box& all) {
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    if (!mesh.is_live_tet(t))
      continue;
    const auto corners = mesh.corners(t);
    const box extent = box_of(corners);
    if (!extent.meets(all))
      continue;
    for (const auto& c : caps) {
      const vec3 middle = (c.p[0] + c.p[1] + c.p[2]) / 3;
      box point;
      point.add(middle);
      if (extent.meets(point) && holds(corners, middle))
        return fail(ec::cap_intersects, "a cap over the hole would lie inside the part",
                    "Select all surfaces of the hole");
    }
  }
  return {};
}

}  // namespace

expected<void> check_plug(const mesh_version& mesh, const plug_surface& plug) {
  if (auto ok = check_closed(plug); !ok)
    return ok;
  if (auto ok = check_volume(plug); !ok)
    return ok;
  const auto caps = placed_caps(plug);
  box all;
  for (const auto& c : caps)
    for (const auto& p : c.p)
      all.add(p);
  if (auto ok = check_boundary(mesh, caps, all); !ok)
    return ok;
  return check_outside(mesh, caps, all);
}

}  // namespace tedit::ops
