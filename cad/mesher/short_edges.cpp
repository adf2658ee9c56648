// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "cad/mesher/surface_mesh.hpp"

namespace tedit::cad {

namespace {

using vertex = std::uint32_t;
using corners = std::array<vertex, 3>;

/// A triangle may turn by so much, in terms of the cosine (about 37 degrees).
constexpr double least_cosine = 0.8;
constexpr int most_sweeps = 12;

double quality(const vec3& a, const vec3& b, const vec3& c) {
  const double la = norm(b - c);
  const double lb = norm(c - a);
  const double lc = norm(a - b);
  const double product = la * lb * lc;
  const double twice_area = norm(cross(b - a, c - a));
  // 2 r / R = 16 A^2 / (abc (a + b + c)).
  return product > 0 ? 4 * twice_area * twice_area / (product * (la + lb + lc)) : 0;
}

class cleaner {
public:
  cleaner(surface_mesh& mesh, double most, double flat)
      : mesh_(mesh), most_(most), flat_(flat), of_(mesh.points.size()) {
    live_.assign(mesh.triangles.size(), true);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      link(t);
  }

  cleaning run() {
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      const auto before = done_.collapsed + done_.flipped;
      for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
        if (live_[t])
          mend(t);
      if (done_.collapsed + done_.flipped == before)
        break;
    }
    std::size_t at = 0;
    std::erase_if(mesh_.triangles, [&](const auto&) { return !live_[at++]; });
    return done_;
  }

private:
  const corners& corners_of(std::uint32_t t) const { return mesh_.triangles[t].v; }
  const vec3& point(vertex v) const { return mesh_.points[v]; }
  double quality_of(const corners& c) const {
    return quality(point(c[0]), point(c[1]), point(c[2]));
  }
  vec3 normal_of(const corners& c) const {
    const vec3 n = cross(point(c[1]) - point(c[0]), point(c[2]) - point(c[0]));
    const double size = norm(n);
    return size > 0 ? n / size : n;
  }

  void link(std::uint32_t t) {
    for (const auto v : corners_of(t))
      of_[v].push_back(t);
  }
  void unlink(std::uint32_t t) {
    for (const auto v : corners_of(t))
      std::erase(of_[v], t);
    live_[t] = false;
  }
  std::uint32_t add(const corners& c, int surface) {
    mesh_.triangles.push_back({c, surface});
    live_.push_back(true);
    const auto t = static_cast<std::uint32_t>(mesh_.triangles.size() - 1);
    link(t);
    return t;
  }

  static bool has(const corners& c, vertex v) { return c[0] == v || c[1] == v || c[2] == v; }
  static vertex opposite(const corners& c, vertex a, vertex b) {
    return c[0] != a && c[0] != b ? c[0] : c[1] != a && c[1] != b ? c[1] : c[2];
  }

  std::vector<std::uint32_t> around(vertex a, vertex b) const {
    std::vector<std::uint32_t> found;
    for (const auto t : of_[a])
      if (has(corners_of(t), b))
        found.push_back(t);
    return found;
  }

  std::set<vertex> neighbours(vertex v) const {
    std::set<vertex> found;
    for (const auto t : of_[v])
      for (const auto w : corners_of(t))
        if (w != v)
          found.insert(w);
    return found;
  }

  /// Where surfaces, or more than two triangles, meet.
  bool is_feature(vertex a, vertex b) const {
    const auto beside = around(a, b);
    return beside.size() != 2 ||
           mesh_.triangles[beside[0]].surface != mesh_.triangles[beside[1]].surface;
  }

  /// 0: within a face; 1: on a curve; 2: where curves end.
  int rank(vertex v) const {
    int features = 0;
    for (const auto w : neighbours(v))
      features += is_feature(v, w);
    return features == 0 ? 0 : features == 2 ? 1 : 2;
  }

  void mend(std::uint32_t t) {
    const auto c = corners_of(t);
    int longest = 0;
    int shortest = 0;
    std::array<double, 3> length{};
    for (int i = 0; i < 3; ++i) {
      length[i] = norm(point(c[(i + 1) % 3]) - point(c[i]));
      longest = length[i] > length[longest] ? i : longest;
      shortest = length[i] < length[shortest] ? i : shortest;
    }
    if (quality_of(c) >= flat_)
      return;
    if (length[shortest] < flat_ * length[longest] && length[shortest] <= most_ &&
        collapse(c[shortest], c[(shortest + 1) % 3]))
      return;
    if (!flip(t, c[longest], c[(longest + 1) % 3]))
      drop(t, c[longest], c[(longest + 1) % 3]);
  }

  /// The better of both ends stays; a corner rather than a curve, a curve rather than a face.
  bool collapse(vertex a, vertex b) {
    if (!keeps_shape(a, b))
      return false;
    const int rank_a = rank(a);
    const int rank_b = rank(b);
    const auto into_a = rank_a >= rank_b ? worst_after(b, a) : std::nullopt;
    const auto into_b = rank_b >= rank_a ? worst_after(a, b) : std::nullopt;
    if (!into_a && !into_b)
      return false;
    const bool to_a = into_a && (!into_b || *into_a >= *into_b);
    merge(to_a ? b : a, to_a ? a : b);
    return true;
  }

  /// Whether the surface is the same kind of surface when both ends are one (the link condition).
  bool keeps_shape(vertex a, vertex b) const {
    std::set<vertex> opposites;
    for (const auto t : around(a, b))
      opposites.insert(opposite(corners_of(t), a, b));
    const auto of_a = neighbours(a);
    for (const auto v : neighbours(b))
      if (v != a && of_a.contains(v) && !opposites.contains(v))
        return false;
    std::set<std::pair<vertex, vertex>> far;
    for (const auto t : of_[a])
      if (!has(corners_of(t), b))
        far.insert(far_edge(t, a));
    return std::ranges::none_of(of_[b], [&](std::uint32_t t) {
      return !has(corners_of(t), a) && far.contains(far_edge(t, b));
    });
  }

  std::pair<vertex, vertex> far_edge(std::uint32_t t, vertex v) const {
    const auto& c = corners_of(t);
    const vertex p = c[0] == v ? c[1] : c[0];
    return std::minmax(p, opposite(c, v, p));
  }

  /// The worst triangle around when `gone` moves to `kept`; nothing when one turns over or none
  /// gets better.
  std::optional<double> worst_after(vertex gone, vertex kept) const {
    double before = 1;
    double after = 1;
    for (const auto t : of_[gone]) {
      auto c = corners_of(t);
      const double q = quality_of(c);
      before = std::min(before, q);
      if (has(c, kept))
        continue;
      const vec3 was = normal_of(c);
      std::ranges::replace(c, gone, kept);
      after = std::min(after, quality_of(c));
      if (q > flat_ && dot(was, normal_of(c)) < least_cosine)
        return std::nullopt;
    }
    return after > before ? std::optional(after) : std::nullopt;
  }

  void merge(vertex gone, vertex kept) {
    done_.moved = std::max(done_.moved, norm(point(gone) - point(kept)));
    ++done_.collapsed;
    for (const auto t : std::vector(of_[gone])) {
      if (has(corners_of(t), kept)) {
        unlink(t);
        continue;
      }
      std::ranges::replace(mesh_.triangles[t].v, gone, kept);
      of_[kept].push_back(t);
    }
    of_[gone].clear();
  }

  /// The other diagonal of two triangles of one face.
  bool flip(std::uint32_t t, vertex a, vertex b) {
    const auto beside = around(a, b);
    if (beside.size() != 2 || is_feature(a, b))
      return false;
    const auto other = beside[0] == t ? beside[1] : beside[0];
    const vertex c = opposite(corners_of(t), a, b);
    const vertex d = opposite(corners_of(other), a, b);
    if (c == d || neighbours(c).contains(d))
      return false;
    const corners first{c, a, d};
    const corners second{d, b, c};
    const double before = std::min(quality_of(corners_of(t)), quality_of(corners_of(other)));
    const vec3 was = normal_of(corners_of(other));
    if (std::min(quality_of(first), quality_of(second)) <= before ||
        dot(was, normal_of(first)) < least_cosine || dot(was, normal_of(second)) < least_cosine)
      return false;
    const int surface = mesh_.triangles[t].surface;
    unlink(t);
    unlink(other);
    add(first, surface);
    add(second, surface);
    ++done_.flipped;
    return true;
  }

  /// A triangle whose corner lies as good as on its edge ab, where the edge must stay: those behind
  /// the edge are split at that corner, and the triangle is gone.
  bool drop(std::uint32_t t, vertex a, vertex b) {
    const vertex c = opposite(corners_of(t), a, b);
    const vec3 along = point(b) - point(a);
    const double height = norm(cross(along, point(c) - point(a))) / norm(along);
    if (height > most_ || height > flat_ * norm(along))
      return false;
    const auto beside = around(a, b);
    const auto of_c = neighbours(c);
    double before = 1;
    double after = 1;
    for (const auto other : beside) {
      before = std::min(before, quality_of(corners_of(other)));
      if (other == t)
        continue;
      const auto [first, second] = halves(other, a, b, c);
      after = std::min({after, quality_of(first), quality_of(second)});
      const vec3 was = normal_of(corners_of(other));
      if (of_c.contains(opposite(corners_of(other), a, b)) ||
          dot(was, normal_of(first)) < least_cosine || dot(was, normal_of(second)) < least_cosine)
        return false;
    }
    if (after <= before || beside.size() < 2)
      return false;
    for (const auto other : beside) {
      const int surface = mesh_.triangles[other].surface;
      const auto [first, second] = halves(other, a, b, c);
      unlink(other);
      if (other == t)
        continue;
      add(first, surface);
      add(second, surface);
    }
    done_.moved = std::max(done_.moved, height);
    ++done_.flipped;
    return true;
  }

  std::pair<corners, corners> halves(std::uint32_t t, vertex a, vertex b, vertex c) const {
    auto first = corners_of(t);
    auto second = first;
    std::ranges::replace(first, b, c);
    std::ranges::replace(second, a, c);
    return {first, second};
  }

  surface_mesh& mesh_;
  double most_;
  double flat_;
  std::vector<std::vector<std::uint32_t>> of_;  ///< Triangles of each point.
  std::vector<bool> live_;
  cleaning done_;
};

}  // namespace

cleaning clean_surface(surface_mesh& mesh, double most, double flat) {
  return cleaner(mesh, most, flat).run();
}

}  // namespace tedit::cad
