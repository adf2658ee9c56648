// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/caps/caps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "ops/shapes/caps/cap_lift.hpp"
#include "ops/shapes/caps/rim_planes.hpp"

namespace tedit::ops {

namespace {

/// Surroundings within this share of the rim's radius of one quadric are taken for smooth.
constexpr double smooth_share = 0.05;
/// A cap goes on a curved surface when rim and surroundings lie this near to one quadric.
constexpr double same_share = 2e-3;

/// Rims in one plane.
struct rim_group {
  std::vector<std::size_t> rims;
  vec3 origin;
  vec3 normal;
  double largest = 0;  ///< Radius of the largest rim: its normal decides.
};

std::vector<rim_group> group_by_plane(const std::vector<rim>& rims) {
  std::vector<rim_group> groups;
  for (std::size_t i = 0; i < rims.size(); ++i) {
    const auto& r = rims[i];
    if (!r.planar())
      continue;
    const auto same_plane = [&](const rim_group& g) {
      const double tolerance = 1e-4 * std::max(r.radius, g.largest);
      return std::abs(dot(g.normal, r.normal)) > 1 - 1e-6 &&
             std::abs(dot(r.centre - g.origin, g.normal)) <= tolerance;
    };
    auto found = std::ranges::find_if(groups, same_plane);
    if (found == groups.end())
      found = groups.insert(groups.end(), {{}, r.centre, r.normal, 0});
    found->rims.push_back(i);
    if (r.radius > found->largest) {
      found->largest = r.radius;
      found->normal = r.normal;
      found->origin = r.centre;
    }
  }
  return groups;
}

/// A plane's own coordinates.
struct plane_frame {
  vec3 origin;
  vec3 normal;
  vec3 u = normalized(cross(std::abs(normal.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0}, normal));
  vec3 w = cross(normal, u);

  [[nodiscard]] std::array<double, 2> flat(vec3 p) const {
    return {dot(p - origin, u), dot(p - origin, w)};
  }
  [[nodiscard]] vec3 lift(const std::array<double, 2>& p) const {
    return origin + p[0] * u + p[1] * w;
  }
};

std::optional<surface_id> only_surface(const mesh_version& mesh,
                                       const std::vector<facet_id>& outer) {
  const auto first = mesh.facet(outer.front()).surface;
  const bool same =
    std::ranges::all_of(outer, [&](facet_id f) { return mesh.facet(f).surface == first; });
  return same ? std::optional(first) : std::nullopt;
}

class shell_closer {
public:
  shell_closer(const mesh_version& mesh, const shell& part, double spacing_factor, services& host)
      : mesh_(mesh), part_(part), factor_(spacing_factor), host_(host) {
    for (const auto f : part.facets) {
      const auto& v = mesh.facet(f).v;
      // Turned: the plug lies on the other side.
      plug_.surface.triangles.push_back({point_of(v[0]), point_of(v[2]), point_of(v[1])});
    }
    plug_.shell_triangles = plug_.surface.triangles.size();
  }

  expected<plug_surface> close() {
    for (const auto& group : group_by_plane(part_.rims))
      if (auto ok = add_flat_caps(group); !ok)
        return fail(ok.error());
    for (const auto& r : part_.rims)
      if (!r.planar())
        if (auto ok = add_curved_cap(r); !ok)
          return fail(ok.error());
    const auto& points = plug_.surface.points;
    const vec3 origin = points.front();
    for (const auto& t : plug_.surface.triangles)
      plug_.volume +=
        dot(points[t[0]] - origin, cross(points[t[1]] - origin, points[t[2]] - origin)) / 6;
    return std::move(plug_);
  }

private:
  std::uint32_t point_of(vertex_id v) {
    const auto [at, fresh] = index_.emplace(v, 0);
    if (fresh)
      at->second = add_point(mesh_.position(v), v);
    return at->second;
  }

  std::uint32_t add_point(vec3 p, vertex_id v = no_id) {
    plug_.surface.points.push_back(p);
    plug_.vertices.push_back(v);
    return static_cast<std::uint32_t>(plug_.surface.points.size() - 1);
  }

  void add_triangles(cap& c, const std::vector<std::array<std::uint32_t, 3>>& triangles,
                     const std::vector<std::uint32_t>& global) {
    for (const auto& t : triangles) {
      c.triangles.push_back({global[t[0]], global[t[1]], global[t[2]]});
      plug_.surface.triangles.push_back(c.triangles.back());
    }
  }

  /// Triangulates loops of plug points in a plane; interior points come after them in `global`.
  expected<planar_filling> fill_plane(const plane_frame& plane,
                                      const std::vector<std::vector<std::uint32_t>>& loops,
                                      double spacing, std::vector<std::uint32_t>& global) {
    planar_polygon polygon;
    for (const auto& loop : loops) {
      auto& flat = polygon.loops.emplace_back();
      for (const auto i : loop) {
        flat.push_back(static_cast<std::uint32_t>(polygon.points.size()));
        polygon.points.push_back(plane.flat(plug_.surface.points[i]));
        global.push_back(i);
      }
    }
    auto filling = host_.triangulate(polygon, factor_ * spacing);
    if (!filling)
      return fail(filling.error());
    for (std::size_t i = polygon.points.size(); i < filling->points.size(); ++i)
      global.push_back(add_point(plane.lift(filling->points[i])));
    return filling;
  }

  // -- flat rims -----------------------------------------------------------------

  expected<void> add_flat_caps(const rim_group& group) {
    std::vector<std::vector<std::uint32_t>> loops;
    double spacing = 0;
    for (const auto i : group.rims) {
      auto& loop = loops.emplace_back();
      for (const auto v : part_.rims[i].loop)
        loop.push_back(point_of(v));
      spacing += part_.rims[i].mean_edge / static_cast<double>(group.rims.size());
    }
    std::vector<std::uint32_t> global;
    const auto filling = fill_plane({group.origin, group.normal}, loops, spacing, global);
    if (!filling)
      return fail(filling.error());
    split_into_caps(group, *filling, global);
    return {};
  }

  /// One cap for each set of triangles that hang together over points.
  void split_into_caps(const rim_group& group, const planar_filling& filling,
                       const std::vector<std::uint32_t>& global) {
    std::vector<std::uint32_t> parent(filling.points.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto find = [&](std::uint32_t i) {
      while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
      return i;
    };
    for (const auto& t : filling.triangles)
      for (int i = 1; i < 3; ++i)
        parent[find(t[i])] = find(t[0]);
    const std::size_t first_cap = plug_.caps.size();
    std::unordered_map<std::uint32_t, std::size_t> cap_of;
    for (const auto& t : filling.triangles) {
      const auto [at, fresh] = cap_of.emplace(find(t[0]), plug_.caps.size());
      if (fresh)
        plug_.caps.emplace_back();
      add_triangles(plug_.caps[at->second], {t}, global);
    }
    std::uint32_t first = 0;
    for (const auto i : group.rims) {
      const auto& r = part_.rims[i];
      if (const auto found = cap_of.find(find(first)); found != cap_of.end()) {
        auto& outer = plug_.caps[found->second].outer;
        outer.insert(outer.end(), r.outer.begin(), r.outer.end());
      }
      first += static_cast<std::uint32_t>(r.loop.size());
    }
    for (std::size_t c = first_cap; c < plug_.caps.size(); ++c)
      plug_.caps[c].continues = flat_neighbour(plug_.caps[c].outer, group.normal);
  }

  [[nodiscard]] std::optional<surface_id> flat_neighbour(const std::vector<facet_id>& outer,
                                                         vec3 normal) const {
    if (outer.empty())
      return std::nullopt;
    const bool flush = std::ranges::all_of(outer, [&](facet_id f) {
      return dot(normalized(area_vector(mesh_, mesh_.facet(f))), normal) >= 1 - 1e-6;
    });
    return flush ? only_surface(mesh_, outer) : std::nullopt;
  }

  // -- other rims ------------------------------------------------------------------

  expected<void> add_curved_cap(const rim& r) {
    if (const auto planes = rim_planes(mesh_, r); !planes.empty()) {
      // A cap that does not come out flat in every plane is none: the smooth one is tried then.
      const auto kept = plug_;
      if (add_caps_in_planes(r, planes))
        return {};
      plug_ = kept;
    }
    return add_smooth_cap(r);
  }

  /// The points between two plug points at the rim's spacing, without the ends.
  std::vector<std::uint32_t> divide(std::uint32_t from, std::uint32_t to, double spacing) {
    const vec3 a = plug_.surface.points[from];
    const vec3 b = plug_.surface.points[to];
    const int parts = std::max(1, static_cast<int>(std::lround(norm(b - a) / spacing)));
    std::vector<std::uint32_t> result;
    for (int i = 1; i < parts; ++i)
      result.push_back(add_point(a + (b - a) * (static_cast<double>(i) / parts)));
    return result;
  }

  bool add_caps_in_planes(const rim& r, const std::vector<rim_plane>& planes) {
    const double spacing = factor_ * r.mean_edge;
    // Spokes from the vertices between two planes to a middle: the corner of three planes, or for
    // two the other such vertex.
    std::vector<std::vector<std::uint32_t>> spokes;
    std::vector<std::uint32_t> hub;
    if (planes.size() == 2) {
      const auto from = point_of(r.loop[planes[0].first]);
      spokes.push_back(divide(from, point_of(r.loop[planes[1].first]), spacing));
    } else {
      const auto corner = common_point(planes);
      if (!corner)
        return false;
      hub.push_back(add_point(*corner));
      for (const auto& plane : planes)
        spokes.push_back(divide(point_of(r.loop[plane.first]), hub.front(), spacing));
    }
    for (std::size_t k = 0; k < planes.size(); ++k) {
      std::vector<std::uint32_t> loop;
      cap c;
      const std::size_t n = r.loop.size();
      for (std::size_t i = 0; i <= planes[k].edges; ++i) {
        loop.push_back(point_of(r.loop[(planes[k].first + i) % n]));
        if (i < planes[k].edges)
          c.outer.push_back(r.outer[(planes[k].first + i) % n]);
      }
      const auto& there = planes.size() == 2 ? spokes[0] : spokes[(k + 1) % planes.size()];
      const bool turned = planes.size() == 2 && k == 0;
      loop.insert(loop.end(), there.begin(), there.end());
      if (turned)
        std::reverse(loop.end() - static_cast<std::ptrdiff_t>(there.size()), loop.end());
      loop.insert(loop.end(), hub.begin(), hub.end());
      if (planes.size() > 2)
        loop.insert(loop.end(), spokes[k].rbegin(), spokes[k].rend());
      std::vector<std::uint32_t> global;
      const auto filling =
        fill_plane({planes[k].point, planes[k].normal}, {loop}, r.mean_edge, global);
      if (!filling)
        return false;
      add_triangles(c, filling->triangles, global);
      c.continues = only_surface(mesh_, c.outer);
      plug_.caps.push_back(std::move(c));
    }
    return true;
  }

  /// The rim in a plane: its projection, or where that crosses itself a circle of the same length.
  planar_polygon unfolded(const rim& r, bool circle) const {
    planar_polygon polygon;
    auto& loop = polygon.loops.emplace_back();
    const plane_frame plane{r.centre, r.normal};
    const std::size_t n = r.loop.size();
    const double length = r.mean_edge * static_cast<double>(n);
    double done = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const vec3 p = mesh_.position(r.loop[i]);
      const double angle = 2 * std::numbers::pi * done / length;
      const double radius = length / (2 * std::numbers::pi);
      loop.push_back(static_cast<std::uint32_t>(i));
      polygon.points.push_back(
        circle ? std::array{radius * std::cos(angle), radius * std::sin(angle)} : plane.flat(p));
      done += norm(mesh_.position(r.loop[(i + 1) % n]) - p);
    }
    return polygon;
  }

  expected<void> add_smooth_cap(const rim& r) {
    auto filling = host_.triangulate(unfolded(r, false), factor_ * r.mean_edge);
    const bool flattened = filling.has_value();
    if (!filling)
      filling = host_.triangulate(unfolded(r, true), factor_ * r.mean_edge);
    if (!filling)
      return fail(ec::non_planar_rim, r.name() + " is too bent to be closed",
                  "Select the whole hole up to a clean edge", r.name());
    std::vector<vec3> rim_points;
    for (const auto v : r.loop)
      rim_points.push_back(mesh_.position(v));
    auto points = lift_onto_rim(*filling, rim_points);
    cap c;
    c.outer = r.outer;
    if (flattened)
      continue_shape(r, *filling, points, c);
    std::vector<std::uint32_t> global;
    for (std::size_t i = 0; i < points.size(); ++i)
      global.push_back(i < r.loop.size() ? point_of(r.loop[i]) : add_point(points[i]));
    add_triangles(c, filling->triangles, global);
    plug_.caps.push_back(std::move(c));
    return {};
  }

  /// Where the surroundings lie on a quadric, the cap does, too.
  void continue_shape(const rim& r, const planar_filling& filling, std::vector<vec3>& points,
                      cap& c) const {
    const auto around =
      surrounding_points(mesh_, r.outer, {part_.facets.begin(), part_.facets.end()});
    const auto shape = fit_quadric(around);
    if (!shape)
      return;
    double off = 0;
    for (const auto& p : around)
      off = std::max(off, shape->distance(p));
    if (off > smooth_share * r.radius ||
        !lift_onto_quadric(filling, *shape, r.normal, r.radius, r.loop.size(), points))
      return;
    if (off <= same_share * r.radius)
      c.continues = only_surface(mesh_, c.outer);
  }

  const mesh_version& mesh_;
  const shell& part_;
  double factor_;
  services& host_;
  plug_surface plug_;
  std::unordered_map<vertex_id, std::uint32_t> index_;
};

}  // namespace

std::vector<vec3> surrounding_points(const mesh_version& mesh, const std::vector<facet_id>& facets,
                                     const std::unordered_set<facet_id>& barred) {
  std::unordered_set<facet_id> seen(facets.begin(), facets.end());
  std::vector<facet_id> ring(seen.begin(), seen.end());
  std::unordered_set<vertex_id> vertices;
  // Four steps over edges are about two rings over corners.
  for (int step = 0; step < 4; ++step) {
    std::vector<facet_id> next;
    for (const auto f : ring) {
      vertices.insert(mesh.facet(f).v.begin(), mesh.facet(f).v.end());
      for (int i = 0; i < 3; ++i) {
        const auto across = facet_across(mesh, f, i);
        if (!barred.contains(across) && seen.insert(across).second)
          next.push_back(across);
      }
    }
    ring = std::move(next);
  }
  std::vector<vertex_id> order(vertices.begin(), vertices.end());
  std::ranges::sort(order);
  std::vector<vec3> points;
  for (const auto v : order)
    points.push_back(mesh.position(v));
  return points;
}

expected<plug_surface> close_shell(const mesh_version& mesh, const shell& part,
                                   double spacing_factor, services& host) {
  return shell_closer(mesh, part, spacing_factor, host).close();
}

}  // namespace tedit::ops
