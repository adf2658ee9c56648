// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/adapt/settle_on_walls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <unordered_set>

#include "mesh/changes.hpp"
#include "mesh/features/known_wall.hpp"
#include "mesh/level_set_freedom.hpp"
#include "mesh/optimize/improve.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

/// Of a wall's radius: what is further off it has to move.
constexpr double off_wall = 1e-9;
/// And a vertex that was there before has left it.
constexpr double moved_off = 1e-6;
/// What lies further off a wall than its chords, by more than this share of that, is on another
/// wall: one that the edit has moved.
constexpr double beyond_chords = 0.1;
/// Of the longest edge around: vertices do not go further.
constexpr double longest_way_share = 0.5;
/// Planes whose normals differ by less are one.
constexpr double one_plane_cosine = 1 - 1e-9;
/// On the way a tet may become as bad as this; what is worse than that is mended.
constexpr double on_the_way = 0.03;
constexpr double mend_below = 0.3;
constexpr double least_step = 1.0 / 8;
/// Cosine: a facet turns by less.
constexpr double most_turn_cosine = 0.5;
/// So many times what is in the way is left where it is.
constexpr int most_rounds = 6;

/// A surface of the candidate as it was before, or as its corners are.
struct candidate_wall {
  std::optional<exact_wall> wall;
  bool is_known = false;  ///< Round, and where it was.
};

/// One vertex that goes.
struct settling {
  vertex_id v = no_id;
  vec3 from, to;
};

class settler {
public:
  settler(const mesh_version& base, const version_ptr& candidate, double floor,
          const execution& run, settling_vertices which)
      : base_(base),
        candidate_(*candidate),
        mesh_(candidate),
        floor_(floor),
        run_(run),
        which_(which) {}

  expected<std::optional<settled_edit>> run() {
    auto moves = find_moves();
    for (int round = 0; round < most_rounds && !moves.empty(); ++round) {
      if (auto ok = settle(moves); !ok)
        return fail(ok.error());
      if (in_the_way_.empty())
        return std::optional(settled_edit{mesh_.freeze(), mesh_.touched()});
      std::erase_if(moves, [&](const settling& one) { return in_the_way_.contains(one.v); });
      in_the_way_.clear();
      mesh_ = mesh_builder(mesh_.base());
    }
    return std::optional<settled_edit>();
  }

private:
  // -- what has to move ------------------------------------------------------------------------

  /// Not in the base, or in another place there.
  [[nodiscard]] bool is_changed(vertex_id v) const {
    return v >= base_.vertex_slots() || !base_.is_live_vertex(v) ||
           base_.position(v) != candidate_.position(v);
  }

  /// A vertex with a facet that it had before has moved: an operation may want it there. In a slot
  /// that was used again there is none.
  [[nodiscard]] bool may_go(vertex_id v) const {
    if (!is_changed(v))
      return false;
    if (which_ == settling_vertices::moved)
      return true;
    const auto facets = facets_at(mesh_, v, mesh_.star(v));
    return std::ranges::none_of(facets, [&](facet_id f) {
      return f < base_.facet_slots() && base_.is_live_facet(f) &&
             base_.facet(f).v == candidate_.facet(f).v;
    });
  }

  std::vector<settling> find_moves() {
    std::vector<settling> moves;
    for_each_dirty_slot(base_.data().positions, candidate_.data().positions, [&](std::uint32_t v) {
      if (v >= candidate_.vertex_slots() || !candidate_.is_live_vertex(v) || !may_go(v))
        return;
      if (const auto place = place_of(v))
        moves.push_back({v, candidate_.position(v), *place});
    });
    return moves;
  }

  /// Nothing where it may stay.
  std::optional<vec3> place_of(vertex_id v) {
    const auto star = mesh_.star(v);
    const auto facets = facets_at(mesh_, v, star);
    if (facets.empty() || std::ranges::none_of(facets, [&](facet_id f) {
          return may_be_round(mesh_.facet(f).surface);
        }))
      return std::nullopt;
    const vec3 at = mesh_.position(v);
    std::vector<wall_demand> demands;
    std::set<surface_id> seen;
    double off = 0;
    double longest = 0;
    for (const auto f : facets) {
      const auto& facet = mesh_.facet(f);
      for (const auto u : facet.v)
        longest = std::max(longest, norm(mesh_.position(u) - at));
      const auto& row = wall_of(facet.surface);
      if (row.wall && !row.wall->flat()) {
        if (seen.insert(facet.surface).second)
          demands.push_back({&*row.wall, {}, {}, false});
        if (row.is_known)
          off = std::max(off, std::abs(row.wall->distance(at)) / row.wall->radius_at(at));
        continue;
      }
      const vec3 normal = row.wall ? row.wall->shape.axis : normal_of(f);
      if (std::ranges::none_of(demands, [&](const wall_demand& d) {
            return !d.wall && std::abs(dot(d.normal, normal)) > one_plane_cosine;
          }))
        demands.push_back({nullptr, at, normal, !row.wall});
    }
    if (off <= off_wall || is_at_interface(star))
      return std::nullopt;
    const auto place = place_on_walls(demands, at);
    const double way = norm(place.at - at);
    const bool goes = place.found && place.after < place.before && way > off_wall * longest &&
                      way <= longest_way_share * longest;
    return goes ? std::optional(place.at) : std::nullopt;
  }

  /// One that is new need not be asked, unless its tool has said what it is.
  [[nodiscard]] bool may_be_round(surface_id id) const {
    using kind = surface_geometry::kind;
    if (const auto* row = base_.find_surface(id))
      return row->geometry.type != kind::plane;
    const auto* row = candidate_.find_surface(id);
    return row && row->geometry.type != kind::plane && row->geometry.type != kind::none;
  }

  [[nodiscard]] bool is_at_interface(const std::vector<tet_id>& star) const {
    return std::ranges::any_of(
      star, [&](tet_id t) { return mesh_.region_of(t) != mesh_.region_of(star.front()); });
  }

  [[nodiscard]] vec3 normal_of(facet_id f) const {
    const auto& v = mesh_.facet(f).v;
    return normalized(
      area_vector(mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2])));
  }

  const candidate_wall& wall_of(surface_id id) {
    const auto [row, fresh] = walls_.try_emplace(id);
    if (!fresh)
      return row->second;
    const auto now = facets_of(candidate_, std::array{id});
    const auto before =
      may_be_round(id) ? facets_of(base_, std::array{id}) : std::vector<facet_id>();
    const bool is_made = before.empty();
    auto known = is_made ? wall_of_tool(id, now) : wall_before(id, before);
    if (known &&
        is_where_it_is_said(*known, is_made ? candidate_ : base_, is_made ? now : before, now))
      row->second = {std::move(known), true};
    else
      row->second.wall = fit_exact(corners_of(candidate_, now));
    return row->second;
  }

  /// What a tool has said of a surface that was not there.
  [[nodiscard]] std::optional<exact_wall> wall_of_tool(surface_id id,
                                                       const std::vector<facet_id>& facets) const {
    if (base_.find_surface(id))
      return std::nullopt;
    return stated_wall(candidate_.find_surface(id)->geometry, corners_of(candidate_, facets));
  }

  /// Round walls that the CAD model has, and those that an earlier edit has made of it: their
  /// corners say exactly what they are.
  [[nodiscard]] std::optional<exact_wall> wall_before(surface_id id,
                                                      const std::vector<facet_id>& facets) const {
    const auto corners = corners_of(base_, facets);
    if (base_.find_surface(id)->geometry.type != surface_geometry::kind::none)
      return known_wall(base_, facets, corners);
    auto fitted = fit_exact(corners);
    if (!fitted || fitted->flat() || !has_round_corners(*fitted, corners.points))
      return std::nullopt;
    const bool is_exact = std::ranges::all_of(corners.points, [&](vec3 p) {
      return std::abs(fitted->distance(p)) <= off_wall * fitted->radius_at(p);
    });
    return is_exact ? fitted : std::nullopt;
  }

  /// Are new corners no further off the wall than the chords of some of its facets?
  [[nodiscard]] bool is_where_it_is_said(const exact_wall& wall, const mesh_version& mesh,
                                         const std::vector<facet_id>& facets,
                                         const std::vector<facet_id>& now) const {
    double chords = wall.vague;
    for (const auto f : facets) {
      const auto& v = mesh.facet(f).v;
      const std::array p{mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
      for (int k = 0; k < 3; ++k)
        chords = std::max(chords, std::abs(wall.distance(0.5 * (p[k] + p[(k + 1) % 3]))));
      chords = std::max(chords, std::abs(wall.distance((p[0] + p[1] + p[2]) / 3)));
    }
    const double near = (1 + beyond_chords) * chords;
    const auto is_there = [&](vertex_id v) {
      if (!is_changed(v))
        return true;
      const vec3 p = candidate_.position(v);
      const double off = std::abs(wall.distance(p));
      return off <= std::max(wall.vague, moved_off * wall.radius_at(p)) ||
             (off <= near && may_go(v));
    };
    return std::ranges::all_of(
      now, [&](facet_id f) { return std::ranges::all_of(candidate_.facet(f).v, is_there); });
  }

  // -- moving ----------------------------------------------------------------------------------

  /// All of them, in as few steps as go; those that do not fit are noted.
  expected<void> settle(const std::vector<settling>& moves) {
    double reached = 0;
    double step = 1;
    while (reached < 1) {
      if (run_.cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      step = std::min(step, 1 - reached);
      const bool is_last = step == 1 - reached;
      auto bad = move(moves, is_last ? 1 : reached + step);
      if (!bad.empty()) {
        place(moves, reached);
        if (0.5 * step < least_step) {
          in_the_way_ = std::move(bad);
          return {};
        }
        step *= 0.5;
        continue;
      }
      reached = is_last ? 1 : reached + step;
      if (auto ok = mend(moves); !ok)
        return fail(ok.error());
      step *= 2;
    }
    note_worse(moves);
    return {};
  }

  /// Those at tets that stayed worse than the floor, and than all at these vertices were.
  void note_worse(const std::vector<settling>& moves) {
    const mesh_builder before(mesh_.base());
    const double allowed = std::min(floor_, worst_of(before, tets_at(before, moves)));
    for (const auto& one : moves)
      if (worst_of(mesh_, mesh_.star(one.v)) < allowed)
        in_the_way_.insert(one.v);
  }

  void place(const std::vector<settling>& moves, double share) {
    for (const auto& one : moves)
      mesh_.set_position(one.v, share == 1 ? one.to : one.from + share * (one.to - one.from));
  }

  /// Returns those whose tets or facets are worse for it than they may be.
  std::unordered_set<vertex_id> move(const std::vector<settling>& moves, double share) {
    std::unordered_set<vertex_id> moving;
    std::map<tet_id, double> before;
    std::map<facet_id, vec3> normals;
    for (const auto& one : moves) {
      moving.insert(one.v);
      const auto star = mesh_.star(one.v);
      for (const auto t : star)
        if (!before.contains(t))
          before.emplace(t, radius_ratio(mesh_.corners(t)));
      for (const auto f : facets_at(mesh_, one.v, star))
        if (!normals.contains(f))
          normals.emplace(f, normal_of(f));
    }
    place(moves, share);
    std::unordered_set<vertex_id> bad;
    const auto blame = [&](const auto& corners) {
      for (const auto v : corners)
        if (moving.contains(v))
          bad.insert(v);
    };
    for (const auto& [t, was] : before) {
      const auto p = mesh_.corners(t);
      if (orient3d(p[0], p[1], p[2], p[3]) <= 0 || radius_ratio(p) < std::min(on_the_way, was))
        blame(mesh_.tet_at(t).v);
    }
    for (const auto& [f, was] : normals)
      if (!(dot(normal_of(f), was) > most_turn_cosine))
        blame(mesh_.facet(f).v);
    return bad;
  }

  /// The tets at what moves, ascending.
  [[nodiscard]] static std::vector<tet_id> tets_at(const mesh_builder& mesh,
                                                   const std::vector<settling>& moves) {
    std::set<tet_id> tets;
    for (const auto& one : moves)
      for (const auto t : mesh.star(one.v))
        tets.insert(t);
    return {tets.begin(), tets.end()};
  }

  [[nodiscard]] static double worst_of(const mesh_builder& mesh, const std::vector<tet_id>& tets) {
    double worst = 1;
    for (const auto t : tets)
      worst = std::min(worst, radius_ratio(mesh.corners(t)));
    return worst;
  }

  expected<void> mend(const std::vector<settling>& moves) {
    const auto region = tets_at(mesh_, moves);
    if (worst_of(mesh_, region) >= mend_below)
      return {};
    improve_settings settings;
    settings.rings = 1;
    settings.sweeps = 3;
    if (const auto done = improve(mesh_, region, settings, run_); !done)
      return fail(done.error());
    return {};
  }

  const mesh_version& base_;
  const mesh_version& candidate_;
  mesh_builder mesh_;
  double floor_;
  const execution& run_;
  settling_vertices which_;
  std::map<surface_id, candidate_wall> walls_;
  std::unordered_set<vertex_id> in_the_way_;
};

}  // namespace

expected<std::optional<settled_edit>> settle_on_walls(const mesh_version& base,
                                                      const version_ptr& candidate, double floor,
                                                      const execution& run,
                                                      settling_vertices which) {
  if (!has_geometries(base))
    return std::optional<settled_edit>();
  return settler(base, candidate, floor, run, which).run();
}

}  // namespace tedit
