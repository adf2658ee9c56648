// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/fill_hole/caps.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tedit::ops {

namespace {

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

class shell_closer {
public:
  shell_closer(const mesh_version& mesh, const shell& part) : mesh_(mesh), part_(part) {
    for (const auto f : part.facets) {
      const auto& v = mesh.facet(f).v;
      // Turned: the plug lies on the other side.
      plug_.surface.triangles.push_back({point_of(v[0]), point_of(v[2]), point_of(v[1])});
    }
    plug_.shell_triangles = plug_.surface.triangles.size();
  }

  expected<plug_surface> close(double spacing_factor, services& host) {
    for (const auto& r : part_.rims)
      if (!r.planar())
        return fail(ec::non_planar_rim,
                    r.name() + " is not flat (it leaves its plane by " +
                      std::to_string(1e3 * r.deviation) + " mm)",
                    "Only holes with flat rims can be filled by this version", r.name());
    for (const auto& group : group_by_plane(part_.rims))
      if (auto ok = add_caps(group, spacing_factor, host); !ok)
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
    const auto [at, fresh] =
      index_.emplace(v, static_cast<std::uint32_t>(plug_.surface.points.size()));
    if (fresh) {
      plug_.surface.points.push_back(mesh_.position(v));
      plug_.vertices.push_back(v);
    }
    return at->second;
  }

  expected<void> add_caps(const rim_group& group, double spacing_factor, services& host) {
    const vec3 n = group.normal;
    const vec3 helper = std::abs(n.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
    const vec3 u = normalized(cross(helper, n));
    const vec3 w = cross(n, u);
    planar_polygon polygon;
    std::vector<std::uint32_t> global;  // polygon point -> plug point
    double spacing = 0;
    for (const auto i : group.rims) {
      auto& loop = polygon.loops.emplace_back();
      for (const auto v : part_.rims[i].loop) {
        const vec3 d = mesh_.position(v) - group.origin;
        loop.push_back(static_cast<std::uint32_t>(polygon.points.size()));
        polygon.points.push_back({dot(d, u), dot(d, w)});
        global.push_back(point_of(v));
      }
      spacing += part_.rims[i].mean_edge / static_cast<double>(group.rims.size());
    }
    auto filling = host.triangulate(polygon, spacing_factor * spacing);
    if (!filling)
      return fail(filling.error());
    for (std::size_t i = polygon.points.size(); i < filling->points.size(); ++i) {
      const auto& p = filling->points[i];
      global.push_back(static_cast<std::uint32_t>(plug_.surface.points.size()));
      plug_.surface.points.push_back(group.origin + p[0] * u + p[1] * w);
      plug_.vertices.push_back(no_id);
    }
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
    std::unordered_map<std::uint32_t, std::size_t> cap_of;
    for (const auto& t : filling.triangles) {
      const auto [at, fresh] = cap_of.emplace(find(t[0]), plug_.caps.size());
      if (fresh)
        plug_.caps.push_back({group.normal, {}, {}});
      const std::array<std::uint32_t, 3> triangle{global[t[0]], global[t[1]], global[t[2]]};
      plug_.caps[at->second].triangles.push_back(triangle);
      plug_.surface.triangles.push_back(triangle);
    }
    std::uint32_t first = 0;
    for (const auto i : group.rims) {
      if (const auto found = cap_of.find(find(first)); found != cap_of.end())
        plug_.caps[found->second].rims.push_back(i);
      first += static_cast<std::uint32_t>(part_.rims[i].loop.size());
    }
  }

  const mesh_version& mesh_;
  const shell& part_;
  plug_surface plug_;
  std::unordered_map<vertex_id, std::uint32_t> index_;
};

}  // namespace

expected<plug_surface> close_shell(const mesh_version& mesh, const shell& part,
                                   double spacing_factor, services& host) {
  return shell_closer(mesh, part).close(spacing_factor, host);
}

}  // namespace tedit::ops
