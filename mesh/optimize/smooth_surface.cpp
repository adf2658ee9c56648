// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/optimize/smooth_surface.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <unordered_map>
#include <unordered_set>

#include "mesh/optimize/star_quality.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

/// cot 3 deg: weights of thinner triangles would drown the others.
constexpr double largest_cot = 19.081136687728211;

constexpr int slide_halvings = 8;

double cot_at(vec3 corner, vec3 a, vec3 b) {
  const double sine = norm(cross(a - corner, b - corner));
  const double cosine = dot(a - corner, b - corner);
  if (!(sine > 0))
    return cosine > 0 ? largest_cot : -largest_cot;
  return std::clamp(cosine / sine, -largest_cot, largest_cot);
}

/// The vertices that may move with all that a step looks at, in local numbers: the builder's pages
/// and star walks would cost more than the steps.
class smoother {
public:
  smoother(const mesh_builder& mesh, const std::vector<surface_id>& surfaces)
      : mesh_(mesh), surfaces_(surfaces.begin(), surfaces.end()) {
    const auto around = gather_facets();
    for (const auto& [v, facets] : around)
      add_vertex(v, facets);
    start_ = at_;
  }

  [[nodiscard]] std::size_t movable() const { return stars_.size(); }

  /// Mean angle between the normals of facets of the surfaces that share an edge, rad.
  [[nodiscard]] double roughness() const {
    std::map<std::pair<vertex_id, vertex_id>, vec3> open;
    double sum = 0;
    std::size_t edges = 0;
    for (const auto f : facets_) {
      const auto& v = mesh_.facet(f).v;
      const vec3 normal = area_vector(place(v[0]), place(v[1]), place(v[2]));
      for (int i = 0; i < 3; ++i) {
        const auto key = std::minmax(v[i], v[(i + 1) % 3]);
        const auto [row, first] = open.emplace(key, normal);
        if (first)
          continue;
        sum += std::atan2(norm(cross(row->second, normal)), dot(row->second, normal));
        ++edges;
        open.erase(row);
      }
    }
    return edges > 0 ? sum / static_cast<double>(edges) : 0;
  }

  /// One step of one vertex; false when no length of it was admissible.
  [[nodiscard]] bool step(std::size_t n, double factor, double floor) {
    const auto& star = stars_[n];
    const vec3 from = at_[star.self];
    const vec3 along = factor * laplacian(star);
    if (along == vec3{})
      return true;
    double length = std::min(1.0, 0.9 * longest(star, along));
    const double least = std::min(floor, worst(star));
    for (int halving = 0; halving <= slide_halvings; ++halving, length *= 0.5) {
      at_[star.self] = from + length * along;
      if (worst(star) >= least && all_positive(star))
        return true;
    }
    at_[star.self] = from;
    return false;
  }

  void write(mesh_builder& target, smooth_report& report) const {
    for (const auto& star : stars_) {
      if (at_[star.self] == start_[star.self])
        continue;
      target.set_position(ids_[star.self], at_[star.self]);
      ++report.moved;
      report.largest_move = std::max(report.largest_move, norm(at_[star.self] - start_[star.self]));
    }
  }

private:
  struct vertex_star {
    std::uint32_t self = 0;
    std::vector<std::array<std::uint32_t, 4>> tets;
    std::vector<std::array<std::uint32_t, 2>> rim;  ///< The facets' edges opposite the vertex.
  };

  /// The facets of the surfaces around each vertex that has no others. Ascending, so that runs
  /// repeat.
  std::map<vertex_id, std::vector<facet_id>> gather_facets() {
    std::map<vertex_id, std::vector<facet_id>> around;
    std::vector<facet_id> others;
    for (facet_id f = 0; f < mesh_.facet_slots(); ++f) {
      if (!mesh_.is_live_facet(f))
        continue;
      if (!surfaces_.contains(mesh_.facet(f).surface)) {
        others.push_back(f);
        continue;
      }
      facets_.push_back(f);
      for (const auto v : mesh_.facet(f).v)
        around[v].push_back(f);
    }
    for (const auto f : others)
      for (const auto v : mesh_.facet(f).v)
        around.erase(v);
    return around;
  }

  /// Adds a vertex unless regions meet at it or its tets form more than one fan.
  void add_vertex(vertex_id v, const std::vector<facet_id>& facets) {
    const auto tets = mesh_.star(v);
    const std::unordered_set<tet_id> fan(tets.begin(), tets.end());
    const auto elsewhere = [&](facet_id f) { return !fan.contains(mesh_.facet(f).tet); };
    const auto other_region = [&](tet_id t) {
      return mesh_.region_of(t) != mesh_.region_of(tets.front());
    };
    if (std::ranges::any_of(facets, elsewhere) || std::ranges::any_of(tets, other_region))
      return;
    vertex_star star;
    star.self = local(v);
    for (const auto t : tets) {
      const auto& c = mesh_.tet_at(t).v;
      star.tets.push_back({local(c[0]), local(c[1]), local(c[2]), local(c[3])});
    }
    for (const auto f : facets) {
      const auto& c = mesh_.facet(f).v;
      const auto at = std::ranges::find(c, v) - c.begin();
      star.rim.push_back({local(c[(at + 1) % 3]), local(c[(at + 2) % 3])});
    }
    stars_.push_back(std::move(star));
  }

  std::uint32_t local(vertex_id v) {
    const auto [row, fresh] = numbers_.emplace(v, static_cast<std::uint32_t>(ids_.size()));
    if (fresh) {
      ids_.push_back(v);
      at_.push_back(mesh_.position(v));
    }
    return row->second;
  }

  [[nodiscard]] vec3 place(vertex_id v) const {
    const auto row = numbers_.find(v);
    return row == numbers_.end() ? mesh_.position(v) : at_[row->second];
  }

  [[nodiscard]] vec3 laplacian(const vertex_star& star) const {
    const vec3 x = at_[star.self];
    vec3 sum;
    vec3 plain;
    double weights = 0;
    for (const auto& [j, k] : star.rim) {
      const double to_j = 0.5 * cot_at(at_[k], x, at_[j]);
      const double to_k = 0.5 * cot_at(at_[j], x, at_[k]);
      sum += to_j * (at_[j] - x) + to_k * (at_[k] - x);
      plain += 0.5 * (at_[j] - x) + 0.5 * (at_[k] - x);
      weights += to_j + to_k;
    }
    // Obtuse triangles can turn the sum around: then every neighbour counts the same.
    return weights > 0 ? sum / weights : plain / static_cast<double>(star.rim.size());
  }

  [[nodiscard]] std::array<vec3, 4> corners(const std::array<std::uint32_t, 4>& tet) const {
    return {at_[tet[0]], at_[tet[1]], at_[tet[2]], at_[tet[3]]};
  }

  /// Along the direction, in its lengths, until the first tet is flat.
  [[nodiscard]] double longest(const vertex_star& star, vec3 along) const {
    double result = std::numeric_limits<double>::infinity();
    for (const auto& tet : star.tets) {
      auto p = corners(tet);
      const double before = signed_volume(p);
      p[std::ranges::find(tet, star.self) - tet.begin()] += along;
      const double fall = before - signed_volume(p);
      if (fall > 0)
        result = std::min(result, before / fall);
    }
    return result;
  }

  [[nodiscard]] double worst(const vertex_star& star) const {
    double result = 1;
    for (const auto& tet : star.tets)
      result = std::min(result, quick_ratio(corners(tet)));
    return result;
  }

  [[nodiscard]] bool all_positive(const vertex_star& star) const {
    return std::ranges::all_of(star.tets, [&](const auto& tet) {
      const auto p = corners(tet);
      return orient3d(p[0], p[1], p[2], p[3]) > 0;
    });
  }

  const mesh_builder& mesh_;
  std::unordered_set<surface_id> surfaces_;
  std::vector<facet_id> facets_;
  std::unordered_map<vertex_id, std::uint32_t> numbers_;
  std::vector<vertex_id> ids_;
  std::vector<vec3> at_;
  std::vector<vec3> start_;
  std::vector<vertex_star> stars_;
};

}  // namespace

expected<smooth_report> smooth_surface(mesh_builder& mesh, const std::vector<surface_id>& surfaces,
                                       const smooth_settings& settings, const execution& run) {
  smoother work(mesh, surfaces);
  smooth_report report;
  report.movable = work.movable();
  report.roughness_before = work.roughness();
  const double forward = settings.keep_volume ? 0.5 : 1;
  const double backward = settings.keep_volume ? -0.53 : 1;
  for (int half = 0; half < 2 * settings.sweeps; ++half) {
    const bool back = half % 2 == 1;
    for (std::size_t i = 0; i < work.movable(); ++i) {
      if (run.cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      const auto n = back ? work.movable() - 1 - i : i;
      if (!work.step(n, back ? backward : forward, settings.quality_floor))
        ++report.refused;
    }
  }
  report.roughness_after = work.roughness();
  work.write(mesh, report);
  return report;
}

}  // namespace tedit
