// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/optimize/harmonic.hpp"

#include <algorithm>
#include <deque>

#include "base/guard.hpp"
#include "base/parallel.hpp"
#include "mesh/optimize/flips.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

/// Gains below this share of what is compared are rounding.
constexpr double least_share = 1e-9;

/// Vertices of one chunk of a parallel sweep: each costs some microseconds.
constexpr std::size_t sweep_chunk = 64;

constexpr int newton_steps = 2;
constexpr int halvings = 6;

/// Harmonic flips over a queue of tets whose surroundings changed.
class flipper {
public:
  flipper(work_mesh& mesh, const surface_guard& guard, double floor, move_counts& counts)
      : mesh_(mesh), guard_(guard), floor_(floor), counts_(counts) {
    waiting_.assign(mesh.tet_slots(), false);
    for (std::uint32_t t = 0; t < mesh.tet_slots(); ++t)
      push(t);
  }

  void run() {
    while (!queue_.empty()) {
      check_cancelled();
      const auto t = queue_.front();
      queue_.pop_front();
      waiting_[t] = false;
      if (!mesh_.is_live(t) || !(try_faces(t) || try_edges(t)))
        continue;
      for (const auto fresh : fresh_) {
        push(fresh);
        for (const auto beyond : mesh_.behind(fresh))
          if (!is_facet(beyond))
            push(beyond);
      }
    }
  }

private:
  void push(std::uint32_t t) {
    if (t >= waiting_.size())
      waiting_.resize(t + 1, false);
    if (!mesh_.is_live(t) || waiting_[t])
      return;
    waiting_[t] = true;
    queue_.push_back(t);
  }

  /// What no new tet may be worse than.
  [[nodiscard]] double least(const std::vector<std::uint32_t>& replaced) const {
    return std::min(floor_, mesh_.worst(replaced));
  }

  [[nodiscard]] double energy(const std::vector<std::array<std::uint32_t, 4>>& tets) const {
    double sum = 0;
    for (const auto& c : tets)
      sum += harmonic_energy({mesh_.at(c[0]), mesh_.at(c[1]), mesh_.at(c[2]), mesh_.at(c[3])});
    return sum;
  }

  [[nodiscard]] double energy_of(const std::vector<std::uint32_t>& tets) const {
    double sum = 0;
    for (const auto t : tets)
      sum += harmonic_energy(mesh_.corners(t));
    return sum;
  }

  bool make() {
    if (!mesh_.replace(change_, fresh_))
      return false;
    ++counts_.harmonic_flips;
    return true;
  }

  bool try_faces(std::uint32_t t) {
    const auto corner = mesh_.tet_at(t);
    for (int face = 0; face < 4; ++face) {
      const auto other = mesh_.behind(t)[face];
      if (is_facet(other))
        continue;
      const auto& row = mesh_.behind(other);
      const auto bottom = mesh_.tet_at(other)[std::ranges::find(row, t) - row.begin()];
      const auto& order = tet_faces[face];
      double scale = 0;
      const double weight = flip_weight(
        {mesh_.at(corner[order[0]]), mesh_.at(corner[order[1]]), mesh_.at(corner[order[2]])},
        mesh_.at(corner[face]), mesh_.at(bottom), scale);
      if (!(weight > least_share * scale))
        continue;
      const double above = std::min(floor_, std::min(mesh_.quality(t), mesh_.quality(other)));
      if (face_flip(mesh_, t, face, above, change_) && make())
        return true;
    }
    return false;
  }

  bool try_edges(std::uint32_t t) {
    const auto corner = mesh_.tet_at(t);
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) {
        const auto a = corner[i];
        const auto b = corner[j];
        if (!mesh_.ring(t, a, b, 4, ring_))
          continue;
        const bool gains = !ring_.closed            ? boundary_gain(a, b)
                           : ring_.tets.size() == 3 ? removal_gain(a, b)
                           : ring_.tets.size() == 4 ? swap_gain(a, b)
                                                    : false;
        if (gains && make())
          return true;
      }
    return false;
  }

  bool removal_gain(std::uint32_t a, std::uint32_t b) {
    const auto& w = ring_.link;
    double scale = 0;
    const double weight = flip_weight({mesh_.at(w[0]), mesh_.at(w[1]), mesh_.at(w[2])}, mesh_.at(a),
                                      mesh_.at(b), scale);
    return weight < -least_share * scale &&
           edge_removal(mesh_, ring_, a, b, least(ring_.tets), change_);
  }

  /// 4-4: over the better of the link's two diagonals.
  bool swap_gain(std::uint32_t a, std::uint32_t b) {
    const auto& w = ring_.link;
    const double above = least(ring_.tets);
    double best = (1 - least_share) * energy_of(ring_.tets);
    int chosen = -1;
    const auto tets_over = [&](int k) {
      // The diagonal w[k]-w[k+2] with the triangles (w[k], w[k+1], w[k+2]) and (w[k], w[k+2],
      // w[k+3]).
      const std::array<std::uint32_t, 4> p{w[k], w[k + 1], w[(k + 2) % 4], w[(k + 3) % 4]};
      change_.added = {
        {p[0], p[1], p[2], b}, {p[2], p[1], p[0], a}, {p[0], p[2], p[3], b}, {p[3], p[2], p[0], a}};
    };
    for (int k = 0; k < 2; ++k) {
      tets_over(k);
      const double sum = energy(change_.added);
      const bool good = std::ranges::all_of(
        change_.added, [&](const auto& c) { return mesh_.quality_of(c) > above; });
      if (!good || !(sum < best))
        continue;
      best = sum;
      chosen = k;
    }
    if (chosen < 0)
      return false;
    tets_over(chosen);
    change_.removed = ring_.tets;
    change_.facets.clear();
    change_.deviation = 0;
    return true;
  }

  /// 2-2: two facets of one surface.
  bool boundary_gain(std::uint32_t a, std::uint32_t b) {
    return guard_.active() && ring_.tets.size() == 2 &&
           edge_removal(mesh_, ring_, a, b, least(ring_.tets), change_) &&
           energy(change_.added) < (1 - least_share) * energy_of(ring_.tets) &&
           guard_.admits(change_);
  }

  work_mesh& mesh_;
  const surface_guard& guard_;
  double floor_;
  move_counts& counts_;
  std::deque<std::uint32_t> queue_;
  std::vector<bool> waiting_;
  work_change change_;
  work_ring ring_;
  std::vector<std::uint32_t> fresh_;
};

/// The tets around each interior vertex, and the vertices by colour.
struct coloured_stars {
  std::vector<std::uint32_t> first;  ///< By vertex; into `tets`.
  std::vector<std::uint32_t> tets;
  std::vector<std::vector<std::uint32_t>> colours;

  explicit coloured_stars(const work_mesh& mesh) {
    first.assign(mesh.vertices() + 1, 0);
    const auto each = [&](auto&& visit) {
      for (std::uint32_t t = 0; t < mesh.tet_slots(); ++t)
        if (mesh.is_live(t))
          for (const auto v : mesh.tet_at(t))
            if (mesh.kind(v) == vertex_kind::interior)
              visit(v, t);
    };
    each([&](std::uint32_t v, std::uint32_t) { ++first[v + 1]; });
    for (std::uint32_t v = 0; v < mesh.vertices(); ++v)
      first[v + 1] += first[v];
    tets.resize(first.back());
    auto next = first;
    each([&](std::uint32_t v, std::uint32_t t) { tets[next[v]++] = t; });
    paint(mesh);
  }

  [[nodiscard]] std::span<const std::uint32_t> star(std::uint32_t v) const {
    return std::span(tets).subspan(first[v], first[v + 1] - first[v]);
  }

private:
  /// Each vertex in turn takes the first colour that no neighbour has.
  void paint(const work_mesh& mesh) {
    constexpr std::uint8_t none = 255;
    std::vector<std::uint8_t> colour(mesh.vertices(), none);
    for (std::uint32_t v = 0; v < mesh.vertices(); ++v) {
      if (first[v + 1] == first[v])
        continue;
      std::array<bool, none> taken{};
      for (const auto t : star(v))
        for (const auto u : mesh.tet_at(t))
          if (colour[u] != none)
            taken[colour[u]] = true;
      const auto free = std::ranges::find(taken, false) - taken.begin();
      if (free >= none)
        continue;  // A vertex with 255 coloured neighbours stays.
      colour[v] = static_cast<std::uint8_t>(free);
      colours.resize(std::max<std::size_t>(colours.size(), free + 1));
      colours[free].push_back(v);
    }
  }
};

/// One vertex; true when it moved.
bool relocate_one(work_mesh& mesh, std::uint32_t v, std::span<const std::uint32_t> tets,
                  double floor, vertex_star& star) {
  star.faces.clear();
  for (const auto t : tets) {
    const auto& c = mesh.tet_at(t);
    star.add(mesh.corners(t), static_cast<int>(std::ranges::find(c, v) - c.begin()));
  }
  const vec3 from = mesh.at(v);
  const vec3 along = star_minimum(star, from, newton_steps) - from;
  // Steps that change nothing worth mentioning would go on for ever.
  const double size = norm(star.faces.front()[0] - from);
  if (!(norm(along) > 1e-4 * size))
    return false;
  const double least = std::min(floor, mesh.worst(tets));
  double length = 1;
  for (int halving = 0; halving < halvings; ++halving, length *= 0.5) {
    const vec3 to = from + length * along;
    if (star_worst(star, to, least) < least)
      continue;
    mesh.move(v, to, tets);
    if (std::ranges::all_of(tets, [&](auto t) { return mesh.positive(mesh.tet_at(t)); }))
      return true;
    mesh.move(v, from, tets);
  }
  return false;
}

}  // namespace

void flip_to_harmonic(work_mesh& mesh, const surface_guard& guard, double floor,
                      move_counts& counts) {
  flipper(mesh, guard, floor, counts).run();
}

double relocate_to_harmonic(work_mesh& mesh, double floor, move_counts& counts) {
  const coloured_stars stars(mesh);
  const double energy = parallel_sum(mesh.tet_slots(), [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (auto t = static_cast<std::uint32_t>(first); t < last; ++t)
      if (mesh.is_live(t))
        sum += harmonic_energy(mesh.corners(t));
    return sum;
  });
  for (const auto& colour : stars.colours) {
    std::vector<std::size_t> moved((colour.size() + sweep_chunk - 1) / sweep_chunk, 0);
    parallel_for(
      colour.size(),
      [&](std::size_t first, std::size_t last, std::size_t chunk) {
        vertex_star star;
        for (std::size_t i = first; i < last; ++i)
          moved[chunk] += relocate_one(mesh, colour[i], stars.star(colour[i]), floor, star);
      },
      sweep_chunk);
    for (const auto n : moved)
      counts.harmonic_relocations += n;
  }
  return energy;
}

}  // namespace tedit
