// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/pick_words.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace tedit::desktop {

namespace {

using edge_key = std::pair<vertex_id, vertex_id>;

edge_key edge_of(const client::surface_facet& facet, std::size_t i) {
  return std::minmax(facet.v[i], facet.v[(i + 1) % 3]);
}

double distance_to(vec3 p, vec3 a, vec3 b) {
  const double length = dot(b - a, b - a);
  const double t = length > 0 ? std::clamp(dot(p - a, b - a) / length, 0.0, 1.0) : 0;
  return norm(p - a - t * (b - a));
}

/// Edges of the wall within reach, by how far they are.
std::map<edge_key, double> edges_near(const client::surface_model& part, surface_id wall,
                                      const vec3& at, double reach) {
  std::map<edge_key, double> near;
  const auto& positions = part.positions();
  part.facets().for_each([&](auto, const client::surface_facet& facet) {
    for (std::size_t i = 0; i < 3 && facet.surface == wall; ++i) {
      const auto edge = edge_of(facet, i);
      const double far = distance_to(at, *positions.find(edge.first), *positions.find(edge.second));
      if (far <= reach)
        near[edge] = far;
    }
  });
  return near;
}

}  // namespace

std::string pick_words(const client::surface_model& part, surface_id wall, const vec3& at,
                       double reach) {
  const auto near = edges_near(part, wall, at, reach);
  std::optional<surface_id> other;
  double least = reach;
  part.facets().for_each([&](auto, const client::surface_facet& facet) {
    for (std::size_t i = 0; i < 3 && facet.surface != wall; ++i)
      if (const auto found = near.find(edge_of(facet, i));
          found != near.end() && found->second <= least) {
        least = found->second;
        other = facet.surface;
      }
  });
  return other ? "edge:" + std::to_string(wall) + "," + std::to_string(*other)
               : "surface:" + std::to_string(wall);
}

}  // namespace tedit::desktop
