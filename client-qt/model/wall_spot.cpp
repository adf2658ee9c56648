// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/wall_spot.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "client-qt/model/probes.hpp"
#include "client-qt/model/round_edges.hpp"

namespace tedit::desktop {

namespace {

using corners = std::array<vec3, 3>;

/// Twice the area, along the normal.
vec3 area_vector(const corners& c) {
  return cross(c[1] - c[0], c[2] - c[0]);
}

template <class Visit>
void each_facet(const client::surface_model& part, const std::vector<surface_id>& of,
                const Visit& visit) {
  part.facets().for_each([&](std::uint32_t, const client::surface_facet& facet) {
    if (!of.empty() && std::ranges::find(of, facet.surface) == of.end())
      return;
    corners c;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto* p = part.positions().find(facet.v[k]);
      if (!p)
        return;
      c[k] = *p;
    }
    visit(c);
  });
}

std::optional<wall_spot> nearest_spot(const client::surface_model& part, const vec3& to,
                                      const std::vector<surface_id>& of) {
  std::optional<wall_spot> best;
  double least = INFINITY;
  each_facet(part, of, [&](const corners& c) {
    const vec3 at = nearest_on(c, to);
    const double far = dot(at - to, at - to);
    if (far < least) {
      least = far;
      best = wall_spot{at, normalized(area_vector(c))};
    }
  });
  return best;
}

/// Edges that only one of some triangles has, and the points at their ends.
struct open_rims {
  std::vector<mesh_edge> edges;
  std::map<vertex_id, vec3> points;
};

open_rims rims_of(const client::surface_model& part, const std::vector<surface_id>& of) {
  open_rims result;
  std::set<mesh_edge> open;
  part.facets().for_each([&](std::uint32_t, const client::surface_facet& facet) {
    if (std::ranges::find(of, facet.surface) == of.end())
      return;
    for (std::size_t k = 0; k < 3; ++k) {
      const mesh_edge edge = std::minmax(facet.v[k], facet.v[(k + 1) % 3]);
      if (!open.insert(edge).second)
        open.erase(edge);
      if (const auto* p = part.positions().find(facet.v[k]))
        result.points[facet.v[k]] = *p;
    }
  });
  result.edges.assign(open.begin(), open.end());
  return result;
}

}  // namespace

std::optional<wall_spot> middle_of(const client::surface_model& part, surface_id surface) {
  vec3 sum;
  double area = 0;
  each_facet(part, {surface}, [&](const corners& c) {
    const double share = norm(area_vector(c));
    sum += share * (c[0] + c[1] + c[2]) / 3;
    area += share;
  });
  if (!(area > 0))
    return std::nullopt;
  return nearest_spot(part, sum / area, {surface});
}

std::optional<vec3> outward_at(const client::surface_model& part, const vec3& at,
                               const std::vector<surface_id>& of) {
  const auto spot = nearest_spot(part, at, of);
  return spot ? std::optional(spot->normal) : std::nullopt;
}

/// By its rims: the facets of a coarse bore look anywhere, its vertices are where they belong.
std::optional<round_wall> round_wall_of(const client::surface_model& part,
                                        const std::vector<surface_id>& surfaces) {
  const auto rims = rims_of(part, surfaces);
  std::optional<round_edge> rim;
  for (const auto& chain : chains_of(rims.edges)) {
    std::vector<vec3> points;
    for (const auto vertex : chain)
      points.push_back(rims.points.at(vertex));
    if (const auto found = round_edge_of(points); found && !rim)
      rim = found;
  }
  if (!rim)
    return std::nullopt;
  double low = 0;
  double high = 0;
  for (const auto& [vertex, p] : rims.points) {
    const double height = dot(p - rim->middle, rim->axis);
    const double off = norm(p - rim->middle - height * rim->axis) - rim->radius;
    if (std::abs(off) > 0.02 * rim->radius)
      return std::nullopt;
    low = std::min(low, height);
    high = std::max(high, height);
  }
  if (high - low < 0.02 * rim->radius)
    return std::nullopt;  // A disc.
  return round_wall{rim->middle + (low + high) / 2 * rim->axis, rim->axis, rim->radius,
                    (high - low) / 2};
}

}  // namespace tedit::desktop
