// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/edge_nodes.hpp"

#include <algorithm>
#include <cstdio>

namespace tedit {

namespace {

/// Gmsh reference manual, node ordering of tetrahedra: the corners of each edge.
constexpr std::array<std::array<int, 2>, 6> edge_corners{
  {{0, 1}, {1, 2}, {2, 0}, {3, 0}, {3, 2}, {3, 1}}};

/// Rounding of a file that writes seven digits moves no node further, by the length of its edge.
constexpr double straight = 1e-5;

/// Distance of a node from the places on the straight edge where it may be.
double distance_off(vec3 node, vec3 a, vec3 b, std::uint32_t per_edge) {
  double off = 1e300;
  for (std::uint32_t i = 1; i <= per_edge; ++i)
    off = std::min(off, norm(node - (a + (static_cast<double>(i) / (per_edge + 1)) * (b - a))));
  return off;
}

/// The nodes that lie off, each counted once, and the one that is furthest.
struct bent_edges {
  std::size_t count = 0;
  double furthest = 0;
  double share = 0;  ///< Of its edge's length.
  vec3 at;
};

std::string text_of(const bent_edges& bent) {
  char text[200];
  std::snprintf(
    text, sizeof(text),
    "; %zu of these nodes lie off the straight edge, by up to %.3g (%.2g %% of the edge) "
    "at (%.4g, %.4g, %.4g) in the file's unit: the curved shape is lost",
    bent.count, bent.furthest, 100 * bent.share, bent.at.x, bent.at.y, bent.at.z);
  return text;
}

}  // namespace

void edge_nodes::add(std::size_t tet, int per_edge, const std::uint64_t* numbers) {
  rows_.push_back({static_cast<std::uint32_t>(tet), static_cast<std::uint32_t>(per_edge)});
  numbers_.insert(numbers_.end(), numbers, numbers + 6 * per_edge);
}

std::string edge_nodes::describe(
  const std::vector<tet>& tets, const std::vector<vec3>& positions,
  const std::function<std::optional<vertex_id>(std::uint64_t)>& find) const {
  bent_edges bent;
  std::vector<bool> seen(positions.size(), false);
  const auto* number = numbers_.data();
  for (const auto& [t, per_edge] : rows_)
    for (const auto& [from, to] : edge_corners) {
      const vec3 a = positions[tets[t].v[static_cast<std::size_t>(from)]];
      const vec3 b = positions[tets[t].v[static_cast<std::size_t>(to)]];
      for (std::uint32_t i = 0; i < per_edge; ++i) {
        const auto node = find(*number++);
        if (!node || seen[*node])
          continue;
        seen[*node] = true;
        const double length = norm(b - a);
        const double off = distance_off(positions[*node], a, b, per_edge);
        if (!(off > straight * length))
          continue;
        ++bent.count;
        if (off > bent.furthest)
          bent = {bent.count, off, length > 0 ? off / length : 0, positions[*node]};
      }
    }
  return std::to_string(rows_.size()) +
         " tets have nodes on their edges; they are read as straight tets of their four corners" +
         (bent.count > 0 ? text_of(bent) : "");
}

}  // namespace tedit
