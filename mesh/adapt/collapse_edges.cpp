// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/adapt/collapse_edges.hpp"

#include <algorithm>
#include <map>
#include <queue>
#include <set>

#include "mesh/optimize/surface_guard.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

constexpr double decent = 0.2;

using skin_list = std::vector<adapt_mesh::skin_triangle>;

/// The shortest first; of equal ones always the same.
struct short_edge {
  double length = 0;
  std::uint32_t a = 0;
  std::uint32_t b = 0;

  [[nodiscard]] bool operator<(const short_edge& other) const {
    return std::tuple(other.length, other.a, other.b) < std::tuple(length, a, b);
  }
};

/// The other ends of the edges at v over which its wall changes, or that have more than two
/// triangles.
std::set<std::uint32_t> crease_ends(const skin_list& around) {
  std::map<std::uint32_t, std::vector<skin>> at;
  for (const auto& triangle : around)
    for (const auto u : {triangle.v[1], triangle.v[2]})
      at[u].push_back(triangle.what);
  std::set<std::uint32_t> result;
  for (const auto& [u, walls] : at)
    if (walls.size() != 2 || !walls[0].same_wall(walls[1]))
      result.insert(u);
  return result;
}

class edge_collapser {
public:
  edge_collapser(const mesh_version& base, adapt_mesh& mesh, const collapse_settings& settings,
                 const execution& run)
      : mesh_(mesh), settings_(settings), run_(run) {
    for (const auto d : pick_distance(base, settings.pick).at_vertices(base, 2 * settings.depth))
      may_go_.push_back(d <= settings.depth);
  }

  expected<collapse_report> collapse_all() {
    for (std::uint32_t t = 0; t < mesh_.tet_slots(); ++t)
      if (mesh_.is_live(t))
        note_edges(mesh_.tet_at(t));
    for (std::size_t step = 0; !queue_.empty(); ++step) {
      if (step % 256 == 0 && run_.cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      const auto next = queue_.top();
      queue_.pop();
      if (!(mesh_.star(next.a).empty() || mesh_.star(next.b).empty()) && is_edge(next) &&
          !try_contract(next.a, next.b))
        (void)try_contract(next.b, next.a);
    }
    return report_;
  }

private:
  void note_edges(const tet& corners) {
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) {
        const auto [a, b] = std::minmax(corners.v[i], corners.v[j]);
        const double length = mesh_.length(a, b);
        if (length < settings_.size && (may_go_[a] || may_go_[b]) && noted_.insert({a, b}).second)
          queue_.push({length, a, b});
      }
  }

  [[nodiscard]] bool is_edge(const short_edge& e) {
    noted_.erase({e.a, e.b});
    mesh_.ring(e.a, e.b, ring_);
    return !ring_.empty();
  }

  bool try_contract(std::uint32_t from, std::uint32_t to) {
    if (!may_go_[from] || !goes_along_skin(from, to) || !tets_are_good(from, to) ||
        !links_meet_in_edge(from, to))
      return false;
    const auto deviation = deviation_of(to);
    if (!deviation)
      return false;
    report_.deviation = std::max(report_.deviation, *deviation);
    ++report_.vertices;
    mesh_.contract(from, to, *deviation);
    for (const auto t : mesh_.star(to))
      note_edges(mesh_.tet_at(t));
    return true;
  }

  /// Inside the part anywhere, on a wall within it, on an edge of two walls along it; corners stay.
  bool goes_along_skin(std::uint32_t from, std::uint32_t to) {
    mesh_.skin_around(from, around_);
    if (around_.empty())
      return true;
    const auto over = std::ranges::count_if(
      around_, [&](const auto& triangle) { return triangle.v[1] == to || triangle.v[2] == to; });
    const auto creases = crease_ends(around_);
    if (creases.empty())
      return over == 2;
    return creases.size() == 2 && creases.contains(to);
  }

  bool tets_are_good(std::uint32_t from, std::uint32_t to) const {
    double before = 1;
    double after = 1;
    for (const auto t : mesh_.star(from)) {
      auto p = mesh_.corners(t);
      before = std::min(before, radius_ratio(p));
      const auto& v = mesh_.tet_at(t).v;
      if (std::ranges::count(v, to))
        continue;
      for (int i = 0; i < 4; ++i)
        if (v[i] == from)
          p[i] = mesh_.at(to);
        else if (mesh_.length(v[i], to) > settings_.size)
          return false;
      after = std::min(after, radius_ratio(p));
      if (after < decent && after < before)
        return false;
      if (orient3d(p[0], p[1], p[2], p[3]) <= 0)
        return false;
    }
    return after >= std::min(decent, before);
  }

  /// The link condition: what both ends see, they see over a tet, or on the skin a triangle, of
  /// their edge.
  bool links_meet_in_edge(std::uint32_t from, std::uint32_t to) {
    std::set<std::uint32_t> near;
    std::set<std::uint32_t> shared;
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::set<std::pair<std::uint32_t, std::uint32_t>> shared_edges;
    each_link_edge(from, [&](std::uint32_t a, std::uint32_t b) {
      near.insert({a, b});
      edges.insert(std::minmax(a, b));
    });
    for (const auto t : ring_of(from, to)) {
      std::vector<std::uint32_t> rest;
      for (const auto v : mesh_.tet_at(t).v)
        if (v != from && v != to)
          rest.push_back(v);
      shared.insert(rest.begin(), rest.end());
      shared_edges.insert(std::minmax(rest[0], rest[1]));
    }
    bool good = true;
    each_link_edge(to, [&](std::uint32_t a, std::uint32_t b) {
      for (const auto v : {a, b})
        good = good && (v == from || !near.contains(v) || shared.contains(v));
      if (a != from && b != from)
        good =
          good && (!edges.contains(std::minmax(a, b)) || shared_edges.contains(std::minmax(a, b)));
    });
    return good && skin_links_meet(from, to);
  }

  template <class Visit>
  void each_link_edge(std::uint32_t v, const Visit& visit) const {
    for (const auto t : mesh_.star(v)) {
      const auto& c = mesh_.tet_at(t).v;
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j)
          if (c[i] != v && c[j] != v)
            visit(c[i], c[j]);
    }
  }

  const std::vector<std::uint32_t>& ring_of(std::uint32_t a, std::uint32_t b) {
    mesh_.ring(a, b, ring_);
    return ring_;
  }

  bool skin_links_meet(std::uint32_t from, std::uint32_t to) {
    if (around_.empty())
      return true;
    std::set<std::uint32_t> near;
    std::set<std::uint32_t> shared;
    for (const auto& triangle : around_) {
      const auto [v, j, k] = triangle.v;
      near.insert({j, k});
      if (j == to || k == to)
        shared.insert(j == to ? k : j);
    }
    mesh_.skin_around(to, other_);
    for (const auto& triangle : other_)
      for (const auto u : {triangle.v[1], triangle.v[2]})
        if (u != from && near.contains(u) && !shared.contains(u))
          return false;
    return true;
  }

  /// m, of the skin in `around_` when its middle is drawn to `to`; nothing where that is too far or
  /// a wall would go.
  std::optional<double> deviation_of(std::uint32_t to) const {
    struct patch {
      skin what;
      std::vector<triangle> before;
      std::vector<triangle> after;
    };
    std::vector<patch> patches;
    double result = 0;
    for (const auto& one : around_) {
      auto p = std::ranges::find_if(
        patches, [&](const patch& known) { return known.what.same_wall(one.what); });
      if (p == patches.end())
        p = patches.insert(patches.end(), {one.what, {}, {}});
      const auto [v, j, k] = one.v;
      p->before.push_back({mesh_.at(v), mesh_.at(j), mesh_.at(k)});
      if (j != to && k != to)
        p->after.push_back({mesh_.at(to), mesh_.at(j), mesh_.at(k)});
      result = std::max(result, one.what.deviation);
    }
    double moved = 0;
    for (const auto& p : patches) {
      if (p.after.empty())
        return std::nullopt;
      moved = std::max(moved, patch_distance(p.before, p.after));
    }
    result += moved;
    return result <= settings_.tolerance || around_.empty() ? std::optional(result) : std::nullopt;
  }

  adapt_mesh& mesh_;
  const collapse_settings& settings_;
  const execution& run_;
  std::vector<bool> may_go_;  ///< By vertex.
  std::priority_queue<short_edge> queue_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> noted_;
  std::vector<std::uint32_t> ring_;
  skin_list around_;
  skin_list other_;
  collapse_report report_;
};

}  // namespace

expected<collapse_report> collapse_edges(const mesh_version& base, adapt_mesh& mesh,
                                         const collapse_settings& settings, const execution& run) {
  return edge_collapser(base, mesh, settings, run).collapse_all();
}

}  // namespace tedit
