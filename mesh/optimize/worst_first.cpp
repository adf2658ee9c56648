// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/optimize/worst_first.hpp"

#include <algorithm>
#include <limits>

#include "mesh/optimize/flips.hpp"
#include "mesh/optimize/star_quality.hpp"

namespace tedit {

namespace {

constexpr std::array<vec3, 14> compass{{{1, 0, 0},
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

constexpr int compass_rounds = 8;

bool beats(double after, double before) {
  return after > least_gain * before;
}

}  // namespace

worst_first::worst_first(work_mesh& mesh, const surface_guard& guard, double target,
                         move_counts& counts, bool worst_only)
    : mesh_(mesh),
      guard_(guard),
      target_(target),
      region_worst_(1),
      worst_only_(worst_only),
      counts_(counts) {
  for (std::uint32_t t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live(t))
      region_worst_ = std::min(region_worst_, mesh.quality(t));
}

double worst_first::badness(double q) const {
  constexpr double flat = 1e-12;  // Below this all are equally bad.
  return q < target_ ? target_ / std::max(q, flat) - 1 : 0;
}

double worst_first::badness_of(std::span<const std::uint32_t> tets) const {
  double sum = 0;
  for (const auto t : tets)
    sum += badness(mesh_.quality(t));
  return sum;
}

double worst_first::badness_after(const work_change& change) const {
  double sum = 0;
  for (const auto& corner : change.added)
    sum += badness(mesh_.quality_of(corner));
  return sum;
}

bool worst_first::is_gain(const work_change& change) const {
  return beats(change.worst, mesh_.worst(change.removed)) &&
         (worst_only_ || change.worst >= decent_quality ||
          badness_after(change) < badness_of(change.removed));
}

/// A strip of facets as thin as the tolerance closes one collapse after the other, and between two
/// of them what is left of it can be thinner than before: the whole must get better, and no tet
/// worse than the worst of the mesh was.
bool worst_first::is_zip_gain(const work_change& change) const {
  return change.worst >= region_worst_ &&
         least_gain * badness_after(change) < badness_of(change.removed);
}

vec3 best_place(const vertex_star& star, vec3 x, double step) {
  double best = star_worst(star, x);
  for (int round = 0; round < compass_rounds; ++round) {
    const vec3 centre = x;
    for (const auto& d : compass) {
      const vec3 trial = centre + (step / std::sqrt(dot(d, d))) * d;
      if (const double q = star_worst(star, trial, best); q > best) {
        best = q;
        x = trial;
      }
    }
    if (x == centre)
      step *= 0.5;
  }
  return x;
}

bool worst_first::mend(std::uint32_t t) {
  if (flip(t))
    return true;
  for (const auto v : std::array(mesh_.tet_at(t)))
    if (relocate(v))
      return true;
  return collapse(t);
}

// -- flips -----------------------------------------------------------------------------

bool worst_first::flip(std::uint32_t t) {
  double gain = 0;  // Of the worst tet of the best change so far.
  bool found = false;
  bool outside = false;
  const auto consider = [&](bool on_boundary) {
    if ((found && change_.worst <= gain) || !is_gain(change_))
      return;
    if (on_boundary && !guard_.admits(change_))
      return;
    gain = change_.worst;
    found = true;
    outside = on_boundary;
    std::swap(best_, change_);
  };
  // Every change takes t away: none is worth more thought that leaves something as bad.
  const double above = least_gain * mesh_.quality(t);
  const auto corner = mesh_.tet_at(t);
  for (int i = 0; i < 4; ++i) {
    if (face_flip(mesh_, t, i, std::max(above, gain), change_))
      consider(false);
    for (int j = i + 1; j < 4; ++j) {
      if (!mesh_.ring(t, corner[i], corner[j], longest_ring, ring_))
        continue;
      if (!ring_.closed && !guard_.active())
        continue;
      if (edge_removal(mesh_, ring_, corner[i], corner[j], std::max(above, gain), change_))
        consider(!ring_.closed);
    }
  }
  if (!found || !mesh_.replace(best_, fresh_))
    return false;
  ++(outside ? counts_.boundary_flips : counts_.flips);
  return true;
}

// -- moving vertices -----------------------------------------------------------------------

void worst_first::load_star(std::uint32_t v) {
  mesh_.star(v, star_);
  // The worst first: a trial that cannot win is given up early.
  std::ranges::sort(star_, {}, [&](std::uint32_t t) { return std::pair(mesh_.quality(t), t); });
  faces_.faces.clear();
  for (const auto t : star_) {
    const auto& c = mesh_.tet_at(t);
    faces_.add(mesh_.corners(t), static_cast<int>(std::ranges::find(c, v) - c.begin()));
  }
}

double worst_first::shortest_edge(std::uint32_t v) const {
  const vec3 x = mesh_.at(v);
  double result = std::numeric_limits<double>::max();
  for (const auto& face : faces_.faces)
    for (const auto& p : face)
      result = std::min(result, dot(p - x, p - x));
  return std::sqrt(result);
}

bool worst_first::relocate(std::uint32_t v) {
  if (mesh_.kind(v) == vertex_kind::fixed)
    return false;
  if (mesh_.kind(v) == vertex_kind::boundary)
    return guard_.active() && relocate_within_surface(v);
  load_star(v);
  const vec3 from = mesh_.at(v);
  const double before = star_worst(faces_, from);
  const vec3 to = best_place(faces_, from, 0.5 * shortest_edge(v));
  if (to == from || !beats(star_worst(faces_, to), before) || !move_star(v, to))
    return false;
  ++counts_.relocations;
  return true;
}

/// Moves v with the star loaded unless that turns a tet around or makes the star worse altogether.
bool worst_first::move_star(std::uint32_t v, vec3 to) {
  const vec3 from = mesh_.at(v);
  const double before = badness_of(star_);
  mesh_.move(v, to, star_);
  const auto positive = [&](auto t) { return mesh_.positive(mesh_.tet_at(t)); };
  const bool gain =
    worst_only_ || mesh_.worst(star_) >= decent_quality || badness_of(star_) < before;
  if (gain && std::ranges::all_of(star_, positive)) {
    mesh_.note_change(star_);
    return true;
  }
  mesh_.move(v, from, star_);
  return false;
}

// The same search along the directions that the surface leaves free.
bool worst_first::relocate_within_surface(std::uint32_t v) {
  load_star(v);
  facets_at(mesh_, v, star_, fan_);
  const auto directions = guard_.free_directions(v, fan_);
  if (directions.empty())
    return false;
  const vec3 from = mesh_.at(v);
  const double before = star_worst(faces_, from);
  double best = least_gain * before;
  double step = 0.5 * shortest_edge(v);
  vec3 to = from;
  double deviation = 0;
  for (int round = 0; round < compass_rounds; ++round) {
    const vec3 centre = to;
    for (const auto& d : directions)
      for (const double sign : {1.0, -1.0}) {
        const vec3 trial = centre + sign * step * d;
        const double q = star_worst(faces_, trial, best);
        double off = 0;
        if (!(q > best) || !guard_.admits_move(v, fan_, trial, off))
          continue;
        best = q;
        to = trial;
        deviation = off;
      }
    if (to == centre)
      step *= 0.5;
  }
  if (to == from || !move_star(v, to))
    return false;
  for (const auto& f : fan_)
    mesh_.set_deviation(f.facet, deviation);
  ++counts_.boundary_relocations;
  return true;
}

// -- fewer and more vertices -----------------------------------------------------------------

bool worst_first::plan_collapse(std::uint32_t v, std::uint32_t u, double above,
                                work_change& change) {
  change.added.clear();
  change.facets.clear();
  change.deviation = 0;
  change.worst = 1;
  for (const auto t : star_) {
    auto corner = mesh_.tet_at(t);
    if (std::ranges::count(corner, u))
      continue;
    std::ranges::replace(corner, v, u);
    change.worst = std::min(change.worst, mesh_.quality_of(corner));
    if (!(change.worst > above))
      return false;
    change.added.push_back(corner);
  }
  change.removed = star_;
  if (change.added.empty())
    return false;
  if (mesh_.kind(v) != vertex_kind::boundary)
    return is_gain(change);
  if (!is_zip_gain(change))
    return false;
  for (const auto& f : fan_)
    if (f.j != u && f.k != u)
      change.facets.push_back({{u, f.j, f.k}, mesh_.surface_of(f.facet)});
  return guard_.may_collapse(v, u, star_, fan_) && guard_.admits(change);
}

bool worst_first::collapse(std::uint32_t t) {
  double gain = 0;  // Badness that goes.
  bool found = false;
  bool outside = false;
  const auto corner = mesh_.tet_at(t);
  for (const auto v : corner) {
    const bool boundary = mesh_.kind(v) == vertex_kind::boundary;
    if (mesh_.kind(v) == vertex_kind::fixed || (boundary && !guard_.active()))
      continue;
    load_star(v);
    if (boundary)
      facets_at(mesh_, v, star_, fan_);
    const double above = boundary ? -1 : least_gain * mesh_.worst(star_);
    const double before = badness_of(star_);
    for (const auto u : corner) {
      if (u == v || !plan_collapse(v, u, above, change_))
        continue;
      const double less = before - badness_after(change_);
      if (found && less <= gain)
        continue;
      gain = less;
      found = true;
      outside = boundary;
      std::swap(best_, change_);
    }
  }
  if (!found || !mesh_.replace(best_, fresh_))
    return false;
  ++(outside ? counts_.boundary_collapses : counts_.collapses);
  return true;
}

bool worst_first::insert(std::uint32_t t) {
  const auto corner = mesh_.tet_at(t);
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      if (split(t, corner[i], corner[j]))
        return true;
  return false;
}

bool worst_first::split(std::uint32_t t, std::uint32_t a, std::uint32_t b) {
  if (!mesh_.ring(t, a, b, 2 * longest_ring, ring_) || (!ring_.closed && !guard_.active()))
    return false;
  // Where the new vertex would go: the best of points along the edge and, inside, towards the
  // link's centre.
  vec3 centre;
  for (const auto v : ring_.link)
    centre += mesh_.at(v) / static_cast<double>(ring_.link.size());
  faces_.faces.clear();
  for (const auto r : ring_.tets) {
    const auto& c = mesh_.tet_at(r);
    for (const auto end : {a, b})
      faces_.add(mesh_.corners(r), static_cast<int>(std::ranges::find(c, end) - c.begin()));
  }
  constexpr std::array<double, 6> into{0.0, 0.2, 0.4, 0.6, 0.8, 1.0};
  const std::size_t depths = ring_.closed ? into.size() : 1;
  double best = least_gain * mesh_.worst(ring_.tets);
  std::optional<vec3> place;
  for (const double along : {0.35, 0.5, 0.65})
    for (std::size_t depth = 0; depth < depths; ++depth) {
      const vec3 on_edge = (1 - along) * mesh_.at(a) + along * mesh_.at(b);
      const vec3 trial = on_edge + into[depth] * (centre - on_edge);
      if (const double q = star_worst(faces_, trial, best); q > best) {
        best = q;
        place = trial;
      }
    }
  if (!place)
    return false;
  const auto fresh =
    mesh_.add_vertex(*place, ring_.closed ? vertex_kind::interior : vertex_kind::boundary);
  change_.removed = ring_.tets;
  change_.added.clear();
  change_.facets.clear();
  change_.deviation = 0;
  for (const auto r : ring_.tets)
    for (const auto end : {a, b}) {
      auto half = mesh_.tet_at(r);
      std::ranges::replace(half, end, fresh);
      change_.added.push_back(half);
    }
  if (!ring_.closed)
    for (const auto& [facet, w] : {std::pair(ring_.first_facet, ring_.link.front()),
                                   std::pair(ring_.last_facet, ring_.link.back())})
      for (const auto end : {a, b})
        change_.facets.push_back({{fresh, end, w}, mesh_.surface_of(facet)});
  change_.worst = best;
  if (!is_gain(change_) || (!ring_.closed && !guard_.admits(change_)) ||
      !mesh_.replace(change_, fresh_)) {
    mesh_.drop_vertex();
    return false;
  }
  ++counts_.insertions;
  const auto counts = counts_;
  if (relocate(fresh))
    counts_ = counts;  // Part of the insertion.
  return true;
}

}  // namespace tedit
