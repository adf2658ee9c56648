// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/round_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "client-qt/model/circle_fit.hpp"

namespace tedit::desktop {

namespace {

constexpr double least_arc = 80 * std::numbers::pi / 180;
constexpr double most_turn = 75 * std::numbers::pi / 180;
constexpr std::size_t least_edges = 4;

/// How far each edge goes around the middle: none so far as the sides of a polygon do, all together
/// far enough.
bool is_round(const std::vector<std::array<double, 2>>& points, const plane_circle& circle) {
  double turned = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double chord =
      std::hypot(points[i + 1][0] - points[i][0], points[i + 1][1] - points[i][1]);
    const double turn = 2 * std::asin(std::min(1.0, chord / (2 * circle.radius)));
    if (turn > most_turn)
      return false;
    turned += turn;
  }
  return turned >= least_arc;
}

}  // namespace

std::vector<std::vector<vertex_id>> chains_of(const std::vector<mesh_edge>& edges) {
  std::map<vertex_id, std::vector<vertex_id>> next;
  for (const auto& [a, b] : edges) {
    next[a].push_back(b);
    next[b].push_back(a);
  }
  std::vector<std::vector<vertex_id>> result;
  std::set<vertex_id> seen;
  const auto walk = [&](vertex_id from) {
    std::vector<vertex_id> chain{from};
    seen.insert(from);
    for (bool on = true; on;) {
      on = false;
      for (const auto to : next[chain.back()])
        if (seen.insert(to).second) {
          chain.push_back(to);
          on = true;
          break;
        }
    }
    const auto& ends = next[chain.back()];
    if (chain.size() > 2 && std::ranges::find(ends, from) != ends.end())
      chain.push_back(from);
    result.push_back(std::move(chain));
  };
  for (const auto& [vertex, ends] : next)  // Ends first, then what is closed.
    if (ends.size() != 2 && !seen.contains(vertex))
      walk(vertex);
  for (const auto& [vertex, ends] : next)
    if (!seen.contains(vertex))
      walk(vertex);
  return result;
}

std::optional<round_edge> round_edge_of(const std::vector<vec3>& chain) {
  if (chain.size() < least_edges + 1)
    return std::nullopt;
  vec3 area;
  for (std::size_t i = 1; i + 1 < chain.size(); ++i)
    area += cross(chain[i] - chain[0], chain[i + 1] - chain[0]);
  const vec3 z = normalized(area);
  if (norm(z) < 0.5)
    return std::nullopt;
  const auto [x, y] = across(z);
  std::vector<std::array<double, 2>> flat;
  double low = INFINITY;
  double high = -INFINITY;
  for (const auto& p : chain) {
    flat.push_back({dot(p - chain[0], x), dot(p - chain[0], y)});
    low = std::min(low, dot(p - chain[0], z));
    high = std::max(high, dot(p - chain[0], z));
  }
  const auto circle = fit_circle(flat);
  const double tolerance = circle ? 0.01 * circle->radius : 0;
  if (!circle || circle->worst > tolerance || high - low > tolerance || !is_round(flat, *circle))
    return std::nullopt;
  return round_edge{chain[0] + circle->middle[0] * x + circle->middle[1] * y + (low + high) / 2 * z,
                    z, circle->radius};
}

}  // namespace tedit::desktop
