// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/support/local_moves.hpp"

#include <algorithm>
#include <limits>

#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

/// A change must beat the old worst by this factor, so that no two changes undo each other.
constexpr double margin = 1.001;

/// Rings longer than this are not worth triangulating.
constexpr std::size_t longest_ring = 7;

}  // namespace

double local_moves::quality(const tet& t) const {
  return radius_ratio(mesh_.position(t.v[0]), mesh_.position(t.v[1]), mesh_.position(t.v[2]),
                      mesh_.position(t.v[3]));
}

bool local_moves::positive(const tet& t) const {
  return orient3d(mesh_.position(t.v[0]), mesh_.position(t.v[1]), mesh_.position(t.v[2]),
                  mesh_.position(t.v[3])) > 0;
}

double local_moves::worst(const std::vector<tet_id>& tets) const {
  double result = 1;
  for (const auto t : tets)
    result = std::min(result, quality(mesh_.tet_at(t)));
  return result;
}

bool local_moves::apply(const proposal& change) {
  for (const auto& t : change.added)
    if (!positive(t))
      return false;
  cavity_change cavity;
  cavity.removed = change.removed;
  const auto region = mesh_.region_of(change.removed.front());
  for (const auto& t : change.added)
    cavity.added.push_back({t, region});
  const auto ids = mesh_.apply(cavity);
  if (!ids)
    return false;
  for (const auto t : change.removed)
    allowed_.erase(t);
  allowed_.insert(ids->begin(), ids->end());
  return true;
}

// -- flips ---------------------------------------------------------------------------

std::optional<local_moves::proposal> local_moves::face_flip(tet_id t, int face) const {
  const auto other = mesh_.neighbours(t)[face];
  if (is_facet(other) || !allowed_.contains(other) || mesh_.region_of(other) != mesh_.region_of(t))
    return std::nullopt;
  const auto& corner = mesh_.tet_at(t).v;
  const auto top = corner[face];
  const auto& row = mesh_.neighbours(other);
  const auto bottom = mesh_.tet_at(other).v[std::ranges::find(row, t) - row.begin()];
  const auto& order = tet_faces[face];
  proposal change;
  change.removed = {t, other};
  change.worst = 1;
  for (int i = 0; i < 3; ++i) {
    // Edge a-b of the face, seen from outside t, with both apices.
    const auto a = corner[order[i]];
    const auto b = corner[order[(i + 1) % 3]];
    change.added.push_back({{a, b, top, bottom}});
    change.worst = std::min(change.worst, quality(change.added.back()));
  }
  return change;
}

std::optional<local_moves::edge_ring> local_moves::interior_ring(vertex_id a, vertex_id b) const {
  const auto tets = mesh_.edge_ring(a, b);
  if (tets.size() < 3 || tets.size() > longest_ring)
    return std::nullopt;
  edge_ring ring;
  tet_id t = tets.front();
  const auto region = mesh_.region_of(t);
  // Walk around the edge: leave each tet by the face opposite the link vertex it was entered by.
  const auto link_of = [&](tet_id at) {
    std::array<vertex_id, 2> link{};
    int n = 0;
    for (const auto v : mesh_.tet_at(at).v)
      if (v != a && v != b)
        link[n++] = v;
    return link;
  };
  auto [from, to] = link_of(t);
  if (!positive({{a, b, from, to}}))
    std::swap(from, to);
  for (std::size_t steps = 0; steps < tets.size(); ++steps) {
    if (!allowed_.contains(t) || mesh_.region_of(t) != region)
      return std::nullopt;
    ring.tets.push_back(t);
    ring.link.push_back(from);
    const auto& corner = mesh_.tet_at(t).v;
    const auto behind = mesh_.neighbours(t)[std::ranges::find(corner, from) - corner.begin()];
    if (is_facet(behind))
      return std::nullopt;
    const auto [x, y] = link_of(behind);
    from = to;
    to = x == from ? y : x;
    t = behind;
  }
  if (t != ring.tets.front())
    return std::nullopt;
  return ring;
}

// Klincsek's dynamic programme: the triangulation of the link polygon whose worst tet is best.
std::optional<local_moves::proposal> local_moves::edge_removal(vertex_id a, vertex_id b) const {
  const auto ring = interior_ring(a, b);
  if (!ring)
    return std::nullopt;
  const auto& link = ring->link;
  const std::size_t n = link.size();
  std::array<std::array<double, longest_ring>, longest_ring> best{};
  std::array<std::array<std::size_t, longest_ring>, longest_ring> split{};
  for (std::size_t i = 0; i + 1 < n; ++i)
    best[i][i + 1] = 1;
  for (std::size_t width = 2; width < n; ++width) {
    for (std::size_t i = 0; i + width < n; ++i) {
      const std::size_t j = i + width;
      best[i][j] = -1;
      for (std::size_t k = i + 1; k < j; ++k) {
        const double q =
          std::min({best[i][k], best[k][j], quality({{link[i], link[k], link[j], b}}),
                    quality({{link[j], link[k], link[i], a}})});
        if (q > best[i][j]) {
          best[i][j] = q;
          split[i][j] = k;
        }
      }
    }
  }
  proposal change;
  change.removed = ring->tets;
  change.worst = best[0][n - 1];
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j < i + 2)
      continue;
    const auto k = split[i][j];
    change.added.push_back({{link[i], link[k], link[j], b}});
    change.added.push_back({{link[j], link[k], link[i], a}});
    open.emplace_back(i, k);
    open.emplace_back(k, j);
  }
  return change;
}

bool local_moves::flip(tet_id t) {
  std::optional<proposal> best;
  const auto consider = [&](std::optional<proposal> change) {
    if (change && change->worst > margin * worst(change->removed) &&
        (!best || change->worst > best->worst))
      best = std::move(change);
  };
  const auto corner = mesh_.tet_at(t).v;
  for (int i = 0; i < 4; ++i) {
    consider(face_flip(t, i));
    for (int j = i + 1; j < 4; ++j)
      consider(edge_removal(corner[i], corner[j]));
  }
  return best && apply(*best);
}

// -- moving vertices -------------------------------------------------------------------

std::vector<tet_id> local_moves::movable_star(vertex_id v) const {
  auto star = mesh_.star(v);
  const auto region = mesh_.region_of(star.front());
  for (const auto t : star) {
    if (!allowed_.contains(t) || mesh_.region_of(t) != region)
      return {};
    for (int i = 0; i < 4; ++i)
      if (mesh_.tet_at(t).v[i] != v && is_facet(mesh_.neighbours(t)[i]))
        return {};
  }
  return star;
}

double local_moves::worst_with(const std::vector<tet_id>& star, vertex_id v, vec3 at) const {
  double result = 1;
  for (const auto t : star) {
    const auto& corner = mesh_.tet_at(t).v;
    std::array<vec3, 4> p;
    for (int i = 0; i < 4; ++i)
      p[i] = corner[i] == v ? at : mesh_.position(corner[i]);
    result = std::min(result, radius_ratio(p));
  }
  return result;
}

/// Compass search: the worst quality over a star is not smooth, and a handful of steps is enough.
bool local_moves::relocate(vertex_id v) {
  const auto star = movable_star(v);
  if (star.empty())
    return false;
  const vec3 start = mesh_.position(v);
  double step = std::numeric_limits<double>::max();
  for (const auto t : star)
    for (const auto u : mesh_.tet_at(t).v)
      if (u != v)
        step = std::min(step, norm(mesh_.position(u) - start));
  const double before = worst_with(star, v, start);
  vec3 at = start;
  double best = before;
  constexpr std::array<vec3, 14> directions{{{1, 0, 0},
                                             {-1, 0, 0},
                                             {0, 1, 0},
                                             {0, -1, 0},
                                             {0, 0, 1},
                                             {0, 0, -1},
                                             {1, 1, 1},
                                             {1, 1, -1},
                                             {1, -1, 1},
                                             {1, -1, -1},
                                             {-1, 1, 1},
                                             {-1, 1, -1},
                                             {-1, -1, 1},
                                             {-1, -1, -1}}};
  step *= 0.5;
  for (int round = 0; round < 8; ++round) {
    const vec3 centre = at;
    for (const auto& d : directions) {
      const vec3 trial = centre + (step / norm(d)) * d;
      if (const double q = worst_with(star, v, trial); q > best) {
        best = q;
        at = trial;
      }
    }
    if (at == centre)
      step *= 0.5;
  }
  if (!(best > margin * before) && !(before == 0 && best > 0))
    return false;
  mesh_.set_position(v, at);
  for (const auto t : star) {
    if (positive(mesh_.tet_at(t)))
      continue;
    mesh_.set_position(v, start);
    return false;
  }
  return true;
}

bool local_moves::relocate_corner(tet_id t) {
  const auto corner = mesh_.tet_at(t).v;
  return std::ranges::any_of(corner, [&](vertex_id v) { return relocate(v); });
}

bool local_moves::insert_vertex(tet_id t) {
  const auto corner = mesh_.tet_at(t).v;
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const auto a = corner[i];
      const auto b = corner[j];
      const auto ring = interior_ring(a, b);
      if (!ring)
        continue;
      const double before = worst(ring->tets);
      // Where the new vertex would go: the best of points along the edge and towards the link's
      // centre.
      vec3 centre;
      for (const auto v : ring->link)
        centre += mesh_.position(v) / static_cast<double>(ring->link.size());
      const auto score = [&](vec3 at) {
        double result = 1;
        for (const auto r : ring->tets)
          for (const auto end : {a, b}) {
            std::array<vec3, 4> p;
            for (int c = 0; c < 4; ++c)
              p[c] = mesh_.tet_at(r).v[c] == end ? at : mesh_.position(mesh_.tet_at(r).v[c]);
            result = std::min(result, radius_ratio(p));
          }
        return result;
      };
      vec3 best_at;
      double best = 0;
      for (const double along : {0.35, 0.5, 0.65})
        for (const double inward : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
          const vec3 on_edge = (1 - along) * mesh_.position(a) + along * mesh_.position(b);
          const vec3 at = on_edge + inward * (centre - on_edge);
          if (const double q = score(at); q > best)
            std::tie(best, best_at) = std::tuple(q, at);
        }
      if (!(best > margin * before))
        continue;
      const auto fresh = mesh_.add_vertex(best_at);
      proposal change;
      change.removed = ring->tets;
      for (const auto r : ring->tets)
        for (const auto end : {a, b}) {
          tet half = mesh_.tet_at(r);
          std::ranges::replace(half.v, end, fresh);
          change.added.push_back(half);
        }
      if (apply(change)) {
        (void)relocate(fresh);
        return true;
      }
    }
  }
  return false;
}

}  // namespace tedit
