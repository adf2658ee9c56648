// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/adapt/split_edges.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

#include "mesh/adapt/wall_places.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

/// Volume of a tet by the cube of the length that its edges may have, in the mean: measured, see
/// bench/FIGURES.md.
constexpr double volume_share = 0.0095;
/// No part has so many tets. Sizes below rounding end here, too.
constexpr double countless = 1e15;

/// A vertex goes onto its round wall where no tet comes out worse than this, or than before.
constexpr double least_quality = 0.1;

/// The longest first; of equal ones always the same.
struct edge {
  double length = 0;
  std::uint32_t a = 0;
  std::uint32_t b = 0;

  [[nodiscard]] bool operator<(const edge& other) const {
    return std::tuple(length, a, b) < std::tuple(other.length, other.a, other.b);
  }
};

double longest_edge(const std::array<vec3, 4>& p) {
  double longest = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      longest = std::max(longest, norm(p[i] - p[j]));
  return longest;
}

/// m: beyond it edges of that length are short enough.
double furthest(double size, double longest) {
  return std::max(0.0, longest - size) / size_growth;
}

/// The length that edges at a new vertex may have, m, by its place and the ends of the edge it is
/// on.
using size_rule = std::function<double(vec3 place, std::uint32_t a, std::uint32_t b)>;

class edge_splitter {
public:
  /// `sizes`: at each vertex slot, how long its edges may be, m; outlives the splitter and grows
  /// with the mesh.
  edge_splitter(const mesh_version& base, adapt_mesh& mesh, std::vector<double>& sizes,
                size_rule new_size, std::size_t most_tets, const execution& run)
      : mesh_(mesh),
        sizes_(sizes),
        new_size_(std::move(new_size)),
        most_tets_(most_tets),
        run_(run),
        walls_(base) {}

  expected<split_report> split_all() {
    for (std::uint32_t t = 0; t < mesh_.tet_slots(); ++t)
      if (mesh_.is_live(t))
        note_edges(mesh_.tet_at(t));
    for (std::size_t step = 0; !queue_.empty(); ++step) {
      if (step % 1024 == 0 && run_.cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      if (mesh_.tet_count() > most_tets_)
        return fail(ec::invalid_parameter,
                    "more than " + std::to_string(most_tets_) + " tets would come out",
                    "Take a larger size");
      const auto next = queue_.top();
      queue_.pop();
      mesh_.ring(next.a, next.b, ring_);
      if (!ring_.empty())
        split(longest_from(next));
    }
    return report_;
  }

private:
  void note_edges(const tet& corners) {
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        note(corners.v[i], corners.v[j]);
  }

  void note(std::uint32_t a, std::uint32_t b) {
    const double length = mesh_.length(a, b);
    if (length > std::min(sizes_[a], sizes_[b]))
      queue_.push({length, std::min(a, b), std::max(a, b)});
  }

  [[nodiscard]] edge longest_around() const {
    edge longest;
    for (const auto t : ring_) {
      const auto& v = mesh_.tet_at(t).v;
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j)
          longest = std::max(
            longest, edge{mesh_.length(v[i], v[j]), std::min(v[i], v[j]), std::max(v[i], v[j])});
    }
    return longest;
  }

  /// Over longer and longer edges to one that is the longest of all tets around; `ring_` is its.
  edge longest_from(edge e) {
    const auto first = e;
    for (;;) {
      const auto longest = longest_around();
      if (longest.a == e.a && longest.b == e.b)
        break;
      e = longest;
      mesh_.ring(e.a, e.b, ring_);
    }
    if (!(first.a == e.a && first.b == e.b))
      queue_.push(first);
    return e;
  }

  /// The walls whose triangles have the edge.
  std::vector<surface_id> walls_at(const edge& e) const {
    std::vector<surface_id> result;
    for (const auto t : ring_)
      for (const auto c : mesh_.tet_at(t).v)
        if (c != e.a && c != e.b)
          if (const auto* what = mesh_.skin_at({e.a, e.b, c});
              what && what->kind != skin_kind::border)
            result.push_back(what->surface);
    std::ranges::sort(result);
    result.erase(std::ranges::unique(result).begin(), result.end());
    return result;
  }

  [[nodiscard]] double worst_with(const edge& e, vec3 place) const {
    double worst = 1;
    for (const auto t : ring_)
      for (const auto end : {e.a, e.b}) {
        auto p = mesh_.corners(t);
        p[static_cast<std::size_t>(std::ranges::find(mesh_.tet_at(t).v, end) -
                                   mesh_.tet_at(t).v.begin())] = place;
        worst = std::min(worst, orient3d(p[0], p[1], p[2], p[3]) > 0 ? radius_ratio(p) : 0);
      }
    return worst;
  }

  void split(const edge& e) {
    const vec3 middle = 0.5 * (mesh_.at(e.a) + mesh_.at(e.b));
    vec3 place = middle;
    if (const auto walls = walls_at(e); !walls.empty())
      place = walls_.middle(mesh_.at(e.a), mesh_.at(e.b), walls);
    if (!(place == middle) && worst_with(e, place) < least_quality &&
        worst_with(e, place) < 0.5 * worst_with(e, middle))
      place = middle;
    const std::vector<std::uint32_t> ring = ring_;
    const auto fresh = mesh_.split(e.a, e.b, ring, place);
    sizes_.push_back(new_size_(place, e.a, e.b));
    ++report_.vertices;
    for (const auto t : mesh_.star(fresh))
      note_edges(mesh_.tet_at(t));
  }

  adapt_mesh& mesh_;
  std::vector<double>& sizes_;
  size_rule new_size_;
  std::size_t most_tets_;
  const execution& run_;
  wall_places walls_;
  std::priority_queue<edge> queue_;
  std::vector<std::uint32_t> ring_;
  split_report report_;
};

/// The integral of 1 / size^3 over a tet of volume 1 with these distances at its corners: by the
/// formula of Hermite and Genocchi six times the divided difference of the third antiderivative.
double mean_density(double size, std::array<double, 4> distance) {
  std::ranges::sort(distance);
  std::array<double, 4> u{};
  std::array<double, 4> f{};
  for (int i = 0; i < 4; ++i) {
    u[i] = size + size_growth * distance[i];
    // Differences of equal numbers are none.
    if (i > 0)
      u[i] = std::max(u[i], 1.01 * u[i - 1]);
    f[i] = std::log(u[i]) / 2;
  }
  for (int order = 1; order < 4; ++order)
    for (int i = 3; i >= order; --i)
      f[i] = (f[i] - f[i - 1]) / (u[i] - u[i - order]);
  return 6 * f[3];
}

}  // namespace

double tets_after_split(const mesh_version& mesh, const split_settings& settings) {
  double longest_of_all = 0;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t))
      longest_of_all = std::max(longest_of_all, longest_edge(mesh.corners(t)));
  const auto distance =
    pick_distance(mesh, settings.pick).at_vertices(mesh, furthest(settings.size, longest_of_all));
  double sum = 0;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    if (!mesh.is_live_tet(t))
      continue;
    const auto p = mesh.corners(t);
    std::array<double, 4> off{};
    for (int i = 0; i < 4; ++i)
      off[i] = distance[mesh.tet_at(t).v[i]];
    // A ball may lie inside a tet, away from its corners.
    if (settings.pick.at)
      for (auto& d : off)
        d = std::max(0.0, d - longest_edge(p) / 2);
    const double pieces =
      std::abs(signed_volume(p)) / volume_share * mean_density(settings.size, off);
    if (!(pieces < countless))
      return countless;
    sum += std::max(1.0, pieces);
  }
  return sum;
}

expected<split_report> split_edges(const mesh_version& base, adapt_mesh& mesh,
                                   const split_settings& settings, const execution& run) {
  double longest = 0;
  for (std::uint32_t t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live(t))
      longest = std::max(longest, longest_edge(mesh.corners(t)));
  const double far = furthest(settings.size, longest);
  const pick_distance off(base, settings.pick);
  const auto size_at = [&](double distance) { return settings.size + size_growth * distance; };
  std::vector<double> distance = off.at_vertices(base, far);
  std::vector<double> sizes;
  for (const auto d : distance)
    sizes.push_back(size_at(d));
  const auto new_size = [&](vec3 place, std::uint32_t a, std::uint32_t b) {
    const double bound =
      std::min(distance[a] + norm(place - mesh.at(a)), distance[b] + norm(place - mesh.at(b)));
    distance.push_back(off(place, std::min(far, bound * (1 + 1e-9))));
    return size_at(distance.back());
  };
  // What was expected is right within a factor, so that there is some room.
  return edge_splitter(base, mesh, sizes, new_size, settings.most_tets + settings.most_tets / 2,
                       run)
    .split_all();
}

expected<split_report> split_edges(const mesh_version& base, adapt_mesh& mesh,
                                   std::vector<double> sizes, std::size_t most_tets,
                                   const execution& run) {
  const auto between = [&](vec3, std::uint32_t a, std::uint32_t b) {
    return 0.5 * (sizes[a] + sizes[b]);
  };
  return edge_splitter(base, mesh, sizes, between, most_tets, run).split_all();
}

}  // namespace tedit
