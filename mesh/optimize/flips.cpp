// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/optimize/flips.hpp"

#include <algorithm>

namespace tedit {

namespace {

/// The best triangulation of a link polygon w[0..n-1]: best[i][j] is the worst q of the tets over
/// the part between w[i] and w[j], split[i][j] the third corner of the triangle at w[i]-w[j].
struct polygon_table {
  static constexpr std::size_t most = longest_ring + 1;
  std::array<std::array<double, most>, most> best{};
  std::array<std::array<std::size_t, most>, most> split{};
};

/// Parts that are not better than `above` are not looked at any further.
void fill(const work_mesh& mesh, const std::vector<std::uint32_t>& w, std::uint32_t a,
          std::uint32_t b, double above, polygon_table& table) {
  const std::size_t n = w.size();
  for (std::size_t i = 0; i + 1 < n; ++i)
    table.best[i][i + 1] = 1;
  for (std::size_t width = 2; width < n; ++width)
    for (std::size_t i = 0; i + width < n; ++i) {
      const std::size_t j = i + width;
      double& best = table.best[i][j];
      best = -1;
      for (std::size_t k = i + 1; k < j; ++k) {
        const double least = std::max(best, above);
        double q = std::min(table.best[i][k], table.best[k][j]);
        if (!(q > least))
          continue;
        q = std::min(q, mesh.quality_of({w[i], w[k], w[j], b}));
        if (!(q > least))
          continue;
        q = std::min(q, mesh.quality_of({w[j], w[k], w[i], a}));
        if (!(q > least))
          continue;
        best = q;
        table.split[i][j] = k;
      }
    }
}

bool are_neighbours(const work_mesh& mesh, std::uint32_t u, std::uint32_t v) {
  std::vector<std::uint32_t> star;
  mesh.star(u, star);
  return std::ranges::any_of(
    star, [&](std::uint32_t t) { return std::ranges::count(mesh.tet_at(t), v) > 0; });
}

/// A tet of two facets comes off when the rest of the part stays behind its other faces.
bool can_peel(const work_mesh& mesh, std::uint32_t t, std::uint32_t u, std::uint32_t v) {
  const auto facets = std::ranges::count_if(mesh.behind(t), is_facet);
  if (facets != 2)
    return false;
  // The edge opposite becomes boundary: it must not be one yet.
  work_ring ring;
  return mesh.ring(t, u, v, 64, ring) && ring.closed;
}

}  // namespace

bool face_flip(const work_mesh& mesh, std::uint32_t t, int face, double above,
               work_change& change) {
  const auto other = mesh.behind(t)[face];
  if (is_facet(other))
    return false;
  const auto& corner = mesh.tet_at(t);
  const auto top = corner[face];
  const auto& row = mesh.behind(other);
  const auto bottom = mesh.tet_at(other)[std::ranges::find(row, t) - row.begin()];
  const auto& order = tet_faces[face];
  change.added.clear();
  change.worst = 1;
  for (int i = 0; i < 3; ++i) {
    // Edge a-b of the face, seen from outside t, with both apices.
    change.added.push_back({corner[order[i]], corner[order[(i + 1) % 3]], top, bottom});
    change.worst = std::min(change.worst, mesh.quality_of(change.added.back()));
    if (!(change.worst > above))
      return false;
  }
  change.removed.assign({t, other});
  change.facets.clear();
  change.deviation = 0;
  return true;
}

bool edge_removal(const work_mesh& mesh, const work_ring& ring, std::uint32_t a, std::uint32_t b,
                  double above, work_change& change) {
  const auto& w = ring.link;
  const std::size_t n = w.size();
  if (ring.closed && n < 3)
    return false;
  if (!ring.closed && mesh.surface_of(ring.first_facet) != mesh.surface_of(ring.last_facet))
    return false;
  change.removed = ring.tets;
  change.added.clear();
  change.facets.clear();
  change.deviation = 0;
  change.worst = 1;
  if (n > 2) {
    polygon_table table;
    fill(mesh, w, a, b, above, table);
    change.worst = table.best[0][n - 1];
    if (!(change.worst > above))
      return false;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, n - 1}};
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (j < i + 2)
        continue;
      const auto k = table.split[i][j];
      change.added.push_back({w[i], w[k], w[j], b});
      change.added.push_back({w[j], w[k], w[i], a});
      open.emplace_back(i, k);
      open.emplace_back(k, j);
    }
  }
  if (ring.closed)
    return true;
  if (n == 2 ? !can_peel(mesh, ring.tets[0], w[0], w[1]) : are_neighbours(mesh, w[0], w[n - 1]))
    return false;
  const auto surface = mesh.surface_of(ring.first_facet);
  change.facets = {{{w[0], w[n - 1], a}, surface}, {{w[0], w[n - 1], b}, surface}};
  return true;
}

}  // namespace tedit
