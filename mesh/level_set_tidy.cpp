// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/level_set_tidy.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "mesh/level_set_freedom.hpp"
#include "mesh/optimize/star_quality.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

/// A change must beat the old worst by this factor, so that no two changes undo each other.
constexpr double margin = 1.001;

/// What was tried without success, and need not be again before a tet at one of its vertices has
/// changed: every try depends on nothing but the stars of those.
class vain_tries {
public:
  /// Of a vertex, or of the edge between two.
  [[nodiscard]] bool has(vertex_id a, vertex_id b) const {
    const auto found = tried_.find(key(a, b));
    return found != tried_.end() && changed_at(a) <= found->second &&
           changed_at(b) <= found->second;
  }
  void add(vertex_id a, vertex_id b) { tried_[key(a, b)] = clock_; }

  /// All corners of tets that are new or whose shape is another.
  void changed(const std::unordered_set<vertex_id>& corners) {
    ++clock_;
    for (const auto v : corners)
      changed_[v] = clock_;
  }

private:
  static std::uint64_t key(vertex_id a, vertex_id b) { return (std::uint64_t{a} << 32) | b; }
  [[nodiscard]] std::uint32_t changed_at(vertex_id v) const {
    const auto found = changed_.find(v);
    return found == changed_.end() ? 0 : found->second;
  }

  std::uint32_t clock_ = 0;
  std::unordered_map<vertex_id, std::uint32_t> changed_;
  std::unordered_map<std::uint64_t, std::uint32_t> tried_;
};

class tidier {
public:
  tidier(mesh_builder& mesh, std::unordered_set<tet_id> allowed, const tidy_settings& settings)
      : mesh_(mesh), allowed_(std::move(allowed)), settings_(settings) {}

  [[nodiscard]] const std::unordered_set<tet_id>& allowed() const { return allowed_; }

  /// Contracts the edge of t whose contraction is best, if one raises the worst tet around.
  bool contract(tet_id t) {
    contraction best;
    const auto corner = mesh_.tet_at(t).v;
    for (const auto from : corner) {
      if (std::ranges::all_of(corner, [&](auto to) { return to == from || vain_.has(from, to); }))
        continue;
      const auto star = mesh_.star(from);
      if (!all_allowed(star))
        continue;
      const auto freedom = freedom_of(mesh_, from, star);
      const double before = worst_of(star);
      const double tolerance = tolerance_at(from, star);
      for (const auto to : corner) {
        if (to == from || vain_.has(from, to))
          continue;
        const bool exact =
          freedom.dimensions > 0 && freedom.allows(mesh_.position(to) - mesh_.position(from));
        if (!exact &&
            !(may_merge(mesh_, from, to, star, tolerance) && only_their_edge_between(star, to)))
          continue;
        auto trial = contracted(star, from, to, exact, std::max(margin * before, best.worst));
        if (trial.worst > 0)
          best = std::move(trial);
      }
    }
    if (best.worst > 0)
      return apply(best.change);
    for (const auto from : corner)
      for (const auto to : corner)
        if (to != from)
          vain_.add(from, to);
    return false;
  }

  /// Moves one corner of t to where the worst tet around it is best.
  bool relocate_corner(tet_id t) {
    const auto corner = mesh_.tet_at(t).v;
    return std::ranges::any_of(corner, [&](vertex_id v) {
      if (vain_.has(v, v))
        return false;
      if (relocate(v))
        return true;
      vain_.add(v, v);
      return false;
    });
  }

private:
  struct contraction {
    cavity_change change;
    double worst = 0;
  };

  [[nodiscard]] bool all_allowed(const std::vector<tet_id>& star) const {
    return std::ranges::all_of(star, [&](tet_id t) { return allowed_.contains(t); });
  }

  [[nodiscard]] double tolerance_at(vertex_id v, const std::vector<tet_id>& star) const {
    if (!settings_.tolerance_of)
      return settings_.tolerance;
    double least = 1;
    for (const auto f : facets_at(mesh_, v, star))
      least = std::min(least, settings_.tolerance_of(mesh_.facet(f).surface));
    return least;
  }

  [[nodiscard]] double worst_of(const std::vector<tet_id>& star) const {
    double worst = 1;
    for (const auto t : star)
      worst = std::min(worst, quick_ratio(mesh_.corners(t)));
    return worst;
  }

  /// The corners of a star's tets and which of them is its middle.
  struct movable_star {
    std::vector<std::array<vec3, 4>> corners;
    std::vector<int> middle;

    /// The worst quality with the middle elsewhere; 0 as soon as it is no better than `beaten`. The
    /// tet that says so stands first from then on: it will say so of most places.
    [[nodiscard]] double worst_at(vec3 at, double beaten) {
      double worst = 1;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i][middle[i]] = at;
        worst = std::min(worst, quick_ratio(corners[i]));
        if (worst > beaten)
          continue;
        std::swap(corners[i], corners[0]);
        std::swap(middle[i], middle[0]);
        return 0;
      }
      return worst;
    }
  };

  [[nodiscard]] movable_star movable(const std::vector<tet_id>& star, vertex_id v) const {
    movable_star result;
    for (const auto t : star) {
      const auto& corner = mesh_.tet_at(t).v;
      result.corners.push_back(mesh_.corners(t));
      result.middle.push_back(static_cast<int>(std::ranges::find(corner, v) - corner.begin()));
    }
    return result;
  }

  [[nodiscard]] std::array<vec3, 4> places(const tet& t) const {
    return {mesh_.position(t.v[0]), mesh_.position(t.v[1]), mesh_.position(t.v[2]),
            mesh_.position(t.v[3])};
  }

  /// The link condition: every vertex next to both ends lies in a tet with both. Needed where the
  /// boundary moves, so that equal volume does not prove the new tets sound.
  [[nodiscard]] bool only_their_edge_between(const std::vector<tet_id>& star, vertex_id to) const {
    std::unordered_set<vertex_id> ring;
    std::unordered_set<vertex_id> link;
    for (const auto t : star) {
      const auto& v = mesh_.tet_at(t).v;
      link.insert(v.begin(), v.end());
      if (std::ranges::count(v, to))
        ring.insert(v.begin(), v.end());
    }
    for (const auto t : mesh_.star(to))
      for (const auto v : mesh_.tet_at(t).v)
        if (link.contains(v) && !ring.contains(v))
          return false;
    return true;
  }

  /// The star of `from` with `from` drawn to `to`; worst is 0 where that does not fill the same
  /// space with tets that are all better than `beaten`.
  [[nodiscard]] contraction contracted(const std::vector<tet_id>& star, vertex_id from,
                                       vertex_id to, bool exact, double beaten) const {
    contraction result;
    result.change.removed = star;
    double worst = 1;
    double total = 0;
    double volume = 0;
    for (const auto t : star) {
      const auto& v = mesh_.tet_at(t).v;
      total += signed_volume(mesh_.corners(t));
      if (std::ranges::count(v, to))
        continue;
      tet moved = mesh_.tet_at(t);
      std::ranges::replace(moved.v, from, to);
      const auto p = places(moved);
      worst = std::min(worst, quick_ratio(p));
      if (!(worst > beaten) || orient3d(p[0], p[1], p[2], p[3]) <= 0)
        return {};
      volume += signed_volume(p);
      result.change.added.push_back({moved, mesh_.region_of(t)});
      for (int i = 0; i < 4; ++i) {
        const auto behind = mesh_.neighbours(t)[i];
        if (v[i] == from || !is_facet(behind))
          continue;
        auto facet = mesh_.facet(behind & ~facet_flag);
        std::ranges::replace(facet.v, from, to);
        result.change.facets.push_back({facet.v, facet.surface});
      }
    }
    // Positive tets over the same outer faces fill the same space when their volume is the same.
    result.worst = !exact || std::abs(volume - total) <= 1e-9 * total ? worst : 0;
    return result;
  }

  void add_corners(const std::vector<tet_id>& tets, std::unordered_set<vertex_id>& to) const {
    for (const auto t : tets)
      to.insert(mesh_.tet_at(t).v.begin(), mesh_.tet_at(t).v.end());
  }

  bool apply(const cavity_change& change) {
    std::unordered_set<vertex_id> corners;
    add_corners(change.removed, corners);
    const auto ids = mesh_.apply(change);
    if (!ids)
      return false;
    add_corners(*ids, corners);
    vain_.changed(corners);
    for (const auto t : change.removed)
      allowed_.erase(t);
    allowed_.insert(ids->begin(), ids->end());
    return true;
  }

  /// Compass search, as the worst quality over a star is not smooth.
  bool relocate(vertex_id v) {
    const auto star = mesh_.star(v);
    if (!all_allowed(star))
      return false;
    const auto freedom = freedom_of(mesh_, v, star);
    if (freedom.dimensions == 0)
      return false;
    const vec3 start = mesh_.position(v);
    double step = 1e300;
    for (const auto t : star)
      for (const auto u : mesh_.tet_at(t).v)
        if (u != v)
          step = std::min(step, 0.5 * norm(mesh_.position(u) - start));
    const double before = worst_of(star);
    auto tried = movable(star, v);
    vec3 at = start;
    double best = before;
    for (int round = 0; round < 8; ++round) {
      const vec3 centre = at;
      for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
          for (int z = -1; z <= 1; ++z) {
            const vec3 d = freedom.project({1.0 * x, 1.0 * y, 1.0 * z});
            if (norm(d) < 0.3)
              continue;
            const vec3 trial = centre + step * normalized(d);
            if (const double q = tried.worst_at(trial, best); q > best)
              std::tie(best, at) = std::tuple(q, trial);
          }
      if (at == centre)
        step *= 0.5;
    }
    if (!(best > margin * before))
      return false;
    mesh_.set_position(v, at);
    const bool positive = std::ranges::all_of(star, [&](tet_id t) {
      const auto p = mesh_.corners(t);
      return orient3d(p[0], p[1], p[2], p[3]) > 0;
    });
    if (!positive) {
      mesh_.set_position(v, start);
      return false;
    }
    std::unordered_set<vertex_id> corners;
    add_corners(star, corners);
    vain_.changed(corners);
    return true;
  }

  mesh_builder& mesh_;
  std::unordered_set<tet_id> allowed_;
  const tidy_settings& settings_;
  vain_tries vain_;
};

std::unordered_set<tet_id> with_rings(const mesh_builder& mesh, const std::vector<tet_id>& region,
                                      int rings) {
  std::unordered_set<tet_id> result(region.begin(), region.end());
  for (int ring = 0; ring < rings; ++ring) {
    std::unordered_set<vertex_id> corners;
    for (const auto t : result)
      corners.insert(mesh.tet_at(t).v.begin(), mesh.tet_at(t).v.end());
    for (const auto v : corners)
      for (const auto t : mesh.star(v))
        result.insert(t);
  }
  return result;
}

std::vector<std::pair<double, tet_id>> worst_first(const mesh_builder& mesh,
                                                   const std::unordered_set<tet_id>& tets,
                                                   double below) {
  std::vector<std::pair<double, tet_id>> bad;
  for (const auto t : tets)
    if (const double q = radius_ratio(mesh.corners(t)); q < below)
      bad.emplace_back(q, t);
  std::ranges::sort(bad);
  return bad;
}

double worst_of(const mesh_builder& mesh, const std::unordered_set<tet_id>& tets) {
  double worst = 1;
  for (const auto t : tets)
    worst = std::min(worst, radius_ratio(mesh.corners(t)));
  return worst;
}

}  // namespace

expected<tidy_report> tidy_cut(mesh_builder& mesh, const std::vector<tet_id>& region,
                               const tidy_settings& settings, const execution& run) {
  tidier moves(mesh, with_rings(mesh, region, settings.rings), settings);
  tidy_report report;
  report.min_before = worst_of(mesh, moves.allowed());
  for (int sweep = 0; sweep < settings.sweeps; ++sweep) {
    bool changed = false;
    for (const auto& [q, t] : worst_first(mesh, moves.allowed(), settings.target)) {
      if (run.cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      if (!moves.allowed().contains(t) || radius_ratio(mesh.corners(t)) != q)
        continue;
      if (moves.contract(t)) {
        ++report.collapses;
        changed = true;
      } else if (moves.relocate_corner(t)) {
        ++report.relocations;
        changed = true;
      }
    }
    if (!changed)
      break;
  }
  report.min_after = worst_of(mesh, moves.allowed());
  return report;
}

}  // namespace tedit
