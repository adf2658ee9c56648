// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/features/plug_gates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <unordered_set>

#include "mesh/box.hpp"
#include "mesh/facet_pages.hpp"
#include "mesh/place_text.hpp"
#include "mesh/predicates.hpp"

namespace tedit::ops {

namespace {

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

/// Does the open segment go through the triangle's inside? Exact.
bool pierces(vec3 p, vec3 q, const std::array<vec3, 3>& t) {
  const int from = orient3d(t[0], t[1], t[2], p);
  const int to = orient3d(t[0], t[1], t[2], q);
  if (from * to >= 0)
    return false;
  const int side = orient3d(p, q, t[0], t[1]);
  return side != 0 && orient3d(p, q, t[1], t[2]) == side && orient3d(p, q, t[2], t[0]) == side;
}

/// Do the triangles meet elsewhere than at corners and edges that they share?
bool crosses(const placed_triangle& c, const std::array<vertex_id, 3>& v,
             const std::array<vec3, 3>& p) {
  const auto shared = [](const std::array<vertex_id, 3>& list, vertex_id i) {
    return i != no_id && std::ranges::count(list, i) > 0;
  };
  if (std::ranges::none_of(c.v, [&](vertex_id i) { return shared(v, i); }))
    return triangles_intersect(c.p, p);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (!shared(v, c.v[i]) && !shared(v, c.v[j]) && pierces(c.p[i], c.p[j], p))
      return true;
    if (!shared(c.v, v[i]) && !shared(c.v, v[j]) && pierces(p[i], p[j], c.p))
      return true;
  }
  return false;
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
  return fail(ec::cap_intersects,
              "a cap over the hole would cut surface " + std::to_string(facet.surface),
              "Select all surfaces inside the hole, or fill what stands in it first",
              place_text(mesh.position(facet.v[0])));
}

expected<void> check_boundary(const mesh_version& mesh, const std::vector<placed_triangle>& caps,
                              const box& all) {
  expected<void> result;
  for_each_facet_near(mesh, all, [&](facet_id f) {
    const auto& facet = mesh.facet(f);
    const std::array<vec3, 3> p{mesh.position(facet.v[0]), mesh.position(facet.v[1]),
                                mesh.position(facet.v[2])};
    const box extent = box_of(p);
    if (!result || !extent.meets(all))
      return;
    for (const auto& c : caps)
      if (c.extent.meets(extent) && crosses(c, facet.v, p))
        result = cuts(mesh, facet);
  });
  return result;
}

/// The angle from the direction `in` around the axis `along`, from 0 to 2 pi.
double angle_around(vec3 along, vec3 in, vec3 d) {
  const double angle = std::atan2(dot(along, cross(in, d)), dot(in, d));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

/// Each cap triangle at a rim edge must lie between the wall and what is across, on the open side:
/// with that, a cap that crosses the boundary nowhere has no part inside the material.
expected<void> check_open_side(const mesh_version& mesh, const rim& r,
                               const std::unordered_map<std::uint64_t, vec3>& third_corner) {
  const std::size_t n = r.loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto a = r.loop[i];
    const auto b = r.loop[(i + 1) % n];
    const auto found = third_corner.find(std::uint64_t{a} << 32 | b);
    if (found == third_corner.end())
      return fail(ec::not_a_hole, "walls and caps do not close",
                  "Select all wall surfaces of the hole");
    const vec3 at = mesh.position(a);
    const vec3 along = normalized(mesh.position(b) - at);
    const auto off_edge = [&](vec3 p) { return p - at - dot(p - at, along) * along; };
    const auto apex = [&](facet_id f) {
      const auto& v = mesh.facet(f).v;
      return mesh.position(*std::ranges::find_if(v, [&](auto c) { return c != a && c != b; }));
    };
    // From the wall the turn around its edge goes first to its outward normal: the open side.
    const vec3 wall = off_edge(apex(r.inner[i]));
    const double open = angle_around(along, wall, off_edge(apex(r.outer[i])));
    const double leaves = angle_around(along, wall, off_edge(found->second));
    constexpr double margin = 1e-9;
    if (leaves <= margin || leaves >= open - margin)
      return fail(ec::cap_intersects, "a cap over the hole would lie inside the part",
                  "Select all surfaces of the hole", r.name());
  }
  return {};
}

expected<void> check_open_sides(const mesh_version& mesh, const shell& part,
                                const plug_surface& plug) {
  std::unordered_map<std::uint64_t, vec3> third_corner;
  for (const auto& c : plug.caps)
    for (const auto& t : c.triangles)
      for (int i = 0; i < 3; ++i) {
        const auto a = plug.vertices[t[i]];
        const auto b = plug.vertices[t[(i + 1) % 3]];
        if (a != no_id && b != no_id)
          third_corner.emplace(std::uint64_t{a} << 32 | b, plug.surface.points[t[(i + 2) % 3]]);
      }
  for (const auto& r : part.rims)
    if (auto ok = check_open_side(mesh, r, third_corner); !ok)
      return ok;
  return {};
}

}  // namespace

expected<void> check_plug(const mesh_version& mesh, const shell& part, const plug_surface& plug) {
  if (auto ok = check_closed(plug); !ok)
    return ok;
  if (auto ok = check_volume(plug); !ok)
    return ok;
  const auto caps = placed_caps(plug);
  box all;
  for (const auto& c : caps)
    for (const auto& p : c.p)
      all.add(p);
  if (auto ok = check_open_sides(mesh, part, plug); !ok)
    return ok;
  return check_boundary(mesh, caps, all);
}

}  // namespace tedit::ops
