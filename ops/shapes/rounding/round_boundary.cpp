// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/round_boundary.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/place_text.hpp"
#include "ops/shapes/rounding/graded_fill.hpp"
#include "ops/shapes/rounding/round_loops.hpp"
#include "ops/shapes/rounding/wall_map.hpp"

namespace tedit::ops {

namespace {

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{a} << 32 | b;
}

class shell_maker {
public:
  shell_maker(const mesh_version& mesh, const round_plan& plan, const round_surface& made)
      : mesh_(mesh), plan_(plan), made_(made), points_(mesh, made, shell_) {}

  expected<round_shell> make(const round_cuts& cuts, const std::unordered_set<tet_id>& cavity,
                             services& host) {
    dropped_.insert(cuts.dropped.begin(), cuts.dropped.end());
    const auto pieces = find_pieces(mesh_, plan_, made_, cuts, cavity, points_, shell_.replaced);
    add_kept(cavity);
    shell_.kept = shell_.surface.triangles.size();
    for (const auto& part : pieces)
      if (auto ok = fill(part, host); !ok)
        return fail(ok.error());
    for (std::size_t i = 0; i < made_.triangles.size(); ++i) {
      const auto& t = made_.triangles[i];
      add_triangle({points_.of_rounded(t[0]), points_.of_rounded(t[1]), points_.of_rounded(t[2])},
                   std::nullopt, made_.chain[i]);
    }
    if (!closed())
      return fail(ec::invalid_argument, "the rounding of " + plan_.chains.front().name(mesh_) +
                                          " does not join the walls around it");
    return std::move(shell_);
  }

private:
  void add_triangle(const std::array<std::uint32_t, 3>& t, std::optional<surface_id> name,
                    std::size_t chain) {
    shell_.surface.triangles.push_back(t);
    shell_.names.push_back(name);
    shell_.chain.push_back(chain);
  }

  /// The cavity's walls against the tets that stay, and the boundary that stays in it.
  void add_kept(const std::unordered_set<tet_id>& cavity) {
    std::vector<tet_id> tets(cavity.begin(), cavity.end());
    std::ranges::sort(tets);
    for (const auto t : tets)
      for (int i = 0; i < 4; ++i) {
        const auto behind = mesh_.neighbours(t)[i];
        if (is_facet(behind) ? shell_.replaced.contains(behind & ~facet_flag)
                             : cavity.contains(behind))
          continue;
        const auto& v = mesh_.tet_at(t).v;
        const auto& order = tet_faces[i];
        shell_.surface.triangles.push_back({points_.of_vertex(v[order[0]]),
                                            points_.of_vertex(v[order[1]]),
                                            points_.of_vertex(v[order[2]])});
      }
  }

  expected<void> fill(const wall_piece& part, services& host) {
    const wall_map map(mesh_, part.shape, part.facets);
    planar_polygon polygon;
    std::vector<std::uint32_t> global;
    std::unordered_map<std::uint32_t, std::uint32_t> local;
    for (const auto& loop : part.loops) {
      auto& row = polygon.loops.emplace_back();
      for (const auto p : loop) {
        const auto [at, fresh] = local.try_emplace(p, static_cast<std::uint32_t>(global.size()));
        if (fresh) {
          global.push_back(p);
          polygon.points.push_back(map.flatten(points_[p]));
        }
        row.push_back(at->second);
      }
    }
    if (!has_room(polygon))
      return too_large(part);
    auto filling = host.triangulate(polygon, 0);
    if (!filling)
      return too_large(part);
    *filling = graded_fill(polygon, std::move(*filling));
    for (std::size_t i = polygon.points.size(); i < filling->points.size(); ++i)
      global.push_back(points_.add(map.lift(filling->points[i])));
    for (const auto& t : filling->triangles)
      add_triangle({global[t[0]], global[t[1]], global[t[2]]}, part.surface, 0);
    return {};
  }

  /// What is left of the piece must be an area: the loops' signed areas add up to more than
  /// nothing.
  [[nodiscard]] static bool has_room(const planar_polygon& polygon) {
    double area = 0;
    for (const auto& loop : polygon.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto& a = polygon.points[loop[i]];
        const auto& b = polygon.points[loop[(i + 1) % loop.size()]];
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
      }
    return area > 0;
  }

  [[nodiscard]] tl::unexpected<error> too_large(const wall_piece& part) const {
    const auto& v = mesh_.facet(part.facets.front()).v;
    vec3 at = mesh_.position(v[0]);
    for (const auto f : part.facets)
      for (const auto u : mesh_.facet(f).v)
        if (dropped_.contains(u))
          at = mesh_.position(u);
    return fail(ec::invalid_argument, "surface " + std::to_string(part.surface) +
                                        " has no room for the rounding at " + place_text(at));
  }

  [[nodiscard]] bool closed() const {
    std::unordered_map<std::uint64_t, int> edges;
    for (const auto& t : shell_.surface.triangles)
      for (int i = 0; i < 3; ++i) {
        const auto a = t[i];
        const auto b = t[(i + 1) % 3];
        edges[edge_key(std::min(a, b), std::max(a, b))] += a < b ? 1 : -1;
      }
    return std::ranges::all_of(edges, [](const auto& row) { return row.second == 0; });
  }

  const mesh_version& mesh_;
  const round_plan& plan_;
  const round_surface& made_;
  round_shell shell_;
  shell_points points_;
  std::unordered_set<vertex_id> dropped_;
};

}  // namespace

expected<round_shell> make_shell(const mesh_version& mesh, const round_plan& plan,
                                 const round_surface& made, const round_cuts& cuts,
                                 const std::unordered_set<tet_id>& cavity, services& host) {
  return shell_maker(mesh, plan, made).make(cuts, cavity, host);
}

}  // namespace tedit::ops
