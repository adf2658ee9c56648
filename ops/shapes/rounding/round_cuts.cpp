// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "mesh/features/rims.hpp"
#include "mesh/place_text.hpp"
#include "ops/shapes/rounding/round_boundary.hpp"

namespace tedit::ops {

namespace {

/// A rounding's end on the exact walls may be so far off the mesh's edge between them, whose edges
/// are chords where a wall is round, as a share of what it takes of that: what the walls have
/// around is triangulated anew.
constexpr double most_off = 0.3;

class edge_cutter {
public:
  edge_cutter(const mesh_version& mesh, const round_plan& plan, const round_surface& made)
      : mesh_(mesh), plan_(plan), made_(made) {}

  expected<round_cuts> cut() {
    for (const auto& corner : plan_.corners) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto s1 = corner.fan.sectors[i];
        const auto s2 = corner.fan.sectors[(i + 1) % 3];
        if (is_chain(corner, s1, s2))
          continue;
        if (auto ok = cut_ray(corner, corner.fan.rays[i], s1, s2); !ok)
          return fail(ok.error());
      }
    }
    // A vertex from which an edge grows on stays; it is the chains' end all the same.
    std::set<vertex_id> standing;
    for (const auto& [v, s1, s2] : result_.grown)
      standing.insert(v);
    for (const auto& chain : plan_.chains)
      for (const auto v : chain.path)
        if (!standing.contains(v))
          taken_.insert(v);
    result_.dropped.assign(taken_.begin(), taken_.end());
    return std::move(result_);
  }

private:
  [[nodiscard]] bool is_chain(const round_corner& corner, surface_id s1, surface_id s2) const {
    return std::ranges::any_of(corner.ends, [&](const chain_end& e) {
      const auto& chain = plan_.chains[e.chain];
      return std::minmax(s1, s2) == std::minmax(chain.a, chain.b);
    });
  }

  /// The new end of the edge between two walls: where the rounding of a chain at the corner touches
  /// the one of them that is its own.
  [[nodiscard]] vec3 new_end(const round_corner& corner, surface_id s1, surface_id s2) const {
    for (const auto& e : corner.ends) {
      const auto& chain = plan_.chains[e.chain];
      const auto& rows = made_.strips[e.chain].rows;
      const auto& row = e.last ? rows.back() : rows.front();
      if (chain.a == s1 || chain.a == s2)
        return made_.points[row.front()];
      if (chain.b == s1 || chain.b == s2)
        return made_.points[row.back()];
    }
    return mesh_.position(corner.at);
  }

  [[nodiscard]] facet_id facet_of(vertex_id v) const {
    for (const auto t : tets_around(mesh_, std::vector{v}))
      for (int i = 0; i < 4; ++i)
        if (mesh_.tet_at(t).v[i] != v && is_facet(mesh_.neighbours(t)[i]))
          return mesh_.neighbours(t)[i] & ~facet_flag;
    return no_id;
  }

  /// The vertex after `v` on the edge between two walls, coming from `before`; no_id at its end.
  [[nodiscard]] vertex_id next_on(vertex_id before, vertex_id v) const {
    const auto fan = fan_at(mesh_, facet_of(v), v);
    if (fan.rays.size() != 2)
      return no_id;
    return fan.rays[fan.rays[0] == before];
  }

  [[nodiscard]] static double distance_to(vec3 p, vec3 a, vec3 b) {
    const double t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
    return norm(p - a - t * (b - a));
  }

  expected<void> cut_ray(const round_corner& corner, vertex_id first, surface_id s1,
                         surface_id s2) {
    const vec3 from = mesh_.position(corner.at);
    const vec3 to = new_end(corner, s1, s2);
    const double length = norm(to - from);
    const vec3 ahead = mesh_.position(first) - from;
    if (dot(to - from, ahead) < 0) {
      result_.grown.insert({corner.at, std::min(s1, s2), std::max(s1, s2)});
      return {};
    }
    double whole = 0;
    double off = length;
    vertex_id last = corner.at;
    for (auto [before, v] = std::pair(corner.at, first); v != no_id;) {
      const double step = norm(mesh_.position(v) - mesh_.position(before));
      // What stays must not leave an edge far shorter than the new ones.
      const auto next = next_on(before, v);
      if (next != no_id && whole + step < length + 0.4 * std::min(step, made_.arc_step))
        taken_.insert(v);
      whole += step;
      off = std::min(off, distance_to(to, mesh_.position(before), mesh_.position(v)));
      last = v;
      before = std::exchange(v, next);
    }
    auto& used = used_[{std::minmax(s1, s2), std::minmax(corner.at, last)}];
    used += length;
    const auto& chain = plan_.chains[corner.ends.front().chain];
    if (used > whole - 0.1 * made_.arc_step)
      return fail(ec::invalid_argument, "rounding " + chain.name(mesh_) + " takes " +
                                          length_name(length) + " of the edge between surfaces " +
                                          std::to_string(s1) + " and " + std::to_string(s2) +
                                          ", which is only " + length_name(whole) + " long, at " +
                                          place_text(from));
    if (off > most_off * length)
      return fail(ec::invalid_argument,
                  "the rounding of " + chain.name(mesh_) + " leaves the edge between surfaces " +
                    std::to_string(s1) + " and " + std::to_string(s2) + " by " + length_name(off) +
                    " at " + place_text(to),
                  "Select other edges");
    return {};
  }

  const mesh_version& mesh_;
  const round_plan& plan_;
  const round_surface& made_;
  std::set<vertex_id> taken_;
  /// How much of each edge, between its walls and its ends, has been taken, m.
  std::map<std::pair<std::pair<surface_id, surface_id>, std::pair<vertex_id, vertex_id>>, double>
    used_;
  round_cuts result_;
};

}  // namespace

expected<round_cuts> cut_edges(const mesh_version& mesh, const round_plan& plan,
                               const round_surface& made) {
  return edge_cutter(mesh, plan, made).cut();
}

}  // namespace tedit::ops
