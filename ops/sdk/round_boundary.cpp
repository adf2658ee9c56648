// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/sdk/round_boundary.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/features/rims.hpp"
#include "mesh/predicates.hpp"
#include "ops/sdk/graded_fill.hpp"
#include "ops/sdk/wall_map.hpp"

namespace tedit::ops {

namespace {

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{a} << 32 | b;
}

class shell_maker {
public:
  shell_maker(const mesh_version& mesh, const round_plan& plan, const round_surface& made,
              const round_cuts& cuts, const std::unordered_set<tet_id>& cavity)
      : mesh_(mesh), plan_(plan), made_(made), cuts_(cuts), cavity_(cavity) {
    dropped_.insert(cuts.dropped.begin(), cuts.dropped.end());
    for (std::size_t i = 0; i < plan.corners.size(); ++i)
      corner_at_[plan.corners[i].at] = i;
    for (std::size_t c = 0; c < plan.chains.size(); ++c) {
      const auto& path = plan.chains[c].path;
      for (std::size_t i = 0; i + (plan.chains[c].closed ? 0 : 1) < path.size(); ++i)
        chain_edges_[edge_key(path[i], path[(i + 1) % path.size()])] = c;
    }
    new_points_.assign(made.points.size(), no_id);
  }

  expected<round_shell> make(services& host) {
    collect_facets();
    add_kept();
    shell_.kept = shell_.surface.triangles.size();
    for (const auto& part : pieces_)
      if (auto ok = fill(part, host); !ok)
        return fail(ok.error());
    for (std::size_t i = 0; i < made_.triangles.size(); ++i) {
      const auto& t = made_.triangles[i];
      add_triangle({new_point(t[0]), new_point(t[1]), new_point(t[2])}, std::nullopt,
                   made_.chain[i]);
    }
    if (!closed())
      return fail(ec::invalid_argument,
                  "the rounding of " + plan_.chains.front().name(mesh_) +
                    " does not join the walls around it",
                  "Take a smaller radius, or select other edges");
    return std::move(shell_);
  }

private:
  struct loop_edge {
    vertex_id from, to;
    facet_id inner;
    facet_id across;
  };
  /// Facets of one surface that hang together inside the cavity and are triangulated anew.
  struct piece {
    surface_id surface = 0;
    std::vector<facet_id> facets;
  };

  // -- points -------------------------------------------------------------------------

  std::uint32_t add_point(vec3 p, vertex_id v) {
    shell_.surface.points.push_back(p);
    shell_.vertices.push_back(v);
    return static_cast<std::uint32_t>(shell_.surface.points.size() - 1);
  }

  std::uint32_t old_point(vertex_id v) {
    const auto [row, fresh] = old_points_.try_emplace(v, 0);
    if (fresh)
      row->second = add_point(mesh_.position(v), v);
    return row->second;
  }

  std::uint32_t new_point(std::uint32_t i) {
    if (new_points_[i] == no_id)
      new_points_[i] = add_point(made_.points[i], no_id);
    return new_points_[i];
  }

  void add_triangle(const std::array<std::uint32_t, 3>& t, std::optional<surface_id> name,
                    std::size_t chain) {
    shell_.surface.triangles.push_back(t);
    shell_.names.push_back(name);
    shell_.chain.push_back(chain);
  }

  // -- what stays ---------------------------------------------------------------------

  [[nodiscard]] bool changes(facet_id f) const {
    return std::ranges::any_of(mesh_.facet(f).v, [&](vertex_id v) {
      return dropped_.contains(v) || corner_at_.contains(v);
    });
  }

  /// The cavity's boundary facets, those of changed walls in pieces.
  void collect_facets() {
    for (const auto t : cavity_)
      for (const auto behind : mesh_.neighbours(t))
        if (is_facet(behind))
          facets_.push_back(behind & ~facet_flag);
    std::ranges::sort(facets_);
    const std::unordered_set<facet_id> inside(facets_.begin(), facets_.end());
    for (const auto seed : facets_) {
      if (!changes(seed) || !shell_.replaced.insert(seed).second)
        continue;
      auto& part = pieces_.emplace_back();
      part.surface = mesh_.facet(seed).surface;
      part.facets.push_back(seed);
      for (std::size_t next = 0; next < part.facets.size(); ++next)
        for (int i = 0; i < 3; ++i) {
          const auto across = facet_across(mesh_, part.facets[next], i);
          if (inside.contains(across) && mesh_.facet(across).surface == part.surface &&
              shell_.replaced.insert(across).second)
            part.facets.push_back(across);
        }
    }
  }

  /// The cavity's walls against the tets that stay, and the boundary that stays in it.
  void add_kept() {
    std::vector<tet_id> tets(cavity_.begin(), cavity_.end());
    std::ranges::sort(tets);
    for (const auto t : tets)
      for (int i = 0; i < 4; ++i) {
        const auto behind = mesh_.neighbours(t)[i];
        if (is_facet(behind) ? shell_.replaced.contains(behind & ~facet_flag)
                             : cavity_.contains(behind))
          continue;
        const auto& v = mesh_.tet_at(t).v;
        const auto& order = tet_faces[i];
        shell_.surface.triangles.push_back(
          {old_point(v[order[0]]), old_point(v[order[1]]), old_point(v[order[2]])});
      }
  }

  // -- loops --------------------------------------------------------------------------

  [[nodiscard]] int edge_from(facet_id f, vertex_id v) const {
    const auto& c = mesh_.facet(f).v;
    return static_cast<int>(std::ranges::find(c, v) - c.begin());
  }

  /// The closed runs of edges around a piece; at a vertex where several meet the walk turns inside.
  [[nodiscard]] std::vector<std::vector<loop_edge>> loops_of(const piece& part) const {
    const std::unordered_set<facet_id> set(part.facets.begin(), part.facets.end());
    std::vector<std::vector<loop_edge>> loops;
    std::unordered_set<std::uint64_t> done;
    for (const auto seed : part.facets)
      for (int i = 0; i < 3; ++i) {
        if (set.contains(facet_across(mesh_, seed, i)))
          continue;
        std::vector<loop_edge> loop;
        auto f = seed;
        int edge = i;
        while (done.insert(edge_key(f, static_cast<std::uint32_t>(edge))).second) {
          const auto& v = mesh_.facet(f).v;
          const auto pivot = v[(edge + 1) % 3];
          loop.push_back({v[edge], pivot, f, facet_across(mesh_, f, edge)});
          edge = (edge + 1) % 3;
          for (auto across = facet_across(mesh_, f, edge); set.contains(across);
               across = facet_across(mesh_, f, edge)) {
            f = across;
            edge = edge_from(f, pivot);
          }
        }
        if (!loop.empty())
          loops.push_back(std::move(loop));
      }
    return loops;
  }

  /// The chain that an edge belongs to, or the number of chains.
  [[nodiscard]] std::size_t chain_of(const loop_edge& e) const {
    auto found = chain_edges_.find(edge_key(e.from, e.to));
    if (found == chain_edges_.end())
      found = chain_edges_.find(edge_key(e.to, e.from));
    return found == chain_edges_.end() ? plan_.chains.size() : found->second;
  }

  [[nodiscard]] bool grows(vertex_id v, surface_id own, const loop_edge& e) const {
    const auto other = mesh_.facet(e.across).surface;
    return cuts_.grown.contains({v, std::min(own, other), std::max(own, other)});
  }

  /// The rounded surface's border on a wall, in the direction of the wall's own edges.
  void add_border(std::size_t c, surface_id own, std::vector<std::uint32_t>& points) {
    const auto& rows = made_.strips[c].rows;
    if (plan_.chains[c].a == own)
      for (const auto& row : rows)
        points.push_back(new_point(row.front()));
    else
      for (auto row = rows.rbegin(); row != rows.rend(); ++row)
        points.push_back(new_point(row->back()));
  }

  /// The arc in the wall at which a chain ends, coming from the edge `e`.
  void add_arc(const round_corner& corner, const loop_edge& e, std::vector<std::uint32_t>& points) {
    const auto& end = corner.ends.front();
    const auto& rows = made_.strips[end.chain].rows;
    auto row = end.last ? rows.back() : rows.front();
    if (mesh_.facet(e.across).surface != plan_.chains[end.chain].a)
      std::ranges::reverse(row);
    for (const auto p : row)
      points.push_back(new_point(p));
  }

  void add_vertex(const loop_edge& in, const loop_edge& out, surface_id own,
                  std::vector<std::uint32_t>& points) {
    const auto v = in.to;
    const bool after_chain = chain_of(in) < plan_.chains.size();
    const bool before_chain = chain_of(out) < plan_.chains.size();
    const auto corner = corner_at_.find(v);
    if (corner == corner_at_.end()) {
      if (!dropped_.contains(v))
        points.push_back(old_point(v));
      return;
    }
    if (!after_chain && grows(v, own, in))
      points.push_back(old_point(v));
    if (!after_chain && !before_chain)
      add_arc(plan_.corners[corner->second], in, points);
    if (!before_chain && grows(v, own, out))
      points.push_back(old_point(v));
  }

  /// The loop as it is after the edit.
  std::vector<std::uint32_t> changed(std::vector<loop_edge> loop, surface_id own) {
    const auto none = plan_.chains.size();
    // Start where a run of chain edges starts, if the loop has more than one run.
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (chain_of(loop[i]) != chain_of(loop[(i + 1) % loop.size()])) {
        std::ranges::rotate(loop, loop.begin() + static_cast<std::ptrdiff_t>(i + 1));
        break;
      }
    std::vector<std::uint32_t> points;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto c = chain_of(loop[i]);
      if (c != none && (i == 0 || chain_of(loop[i - 1]) != c))
        add_border(c, own, points);
      const auto& next = loop[(i + 1) % loop.size()];
      if (c == none || chain_of(next) != c)
        add_vertex(loop[i], next, own, points);
    }
    points.erase(std::ranges::unique(points).begin(), points.end());
    while (points.size() > 1 && points.front() == points.back())
      points.pop_back();
    return points;
  }

  // -- walls --------------------------------------------------------------------------

  expected<void> fill(const piece& part, services& host) {
    const wall_map map(mesh_, plan_.shapes.at(part.surface), part.facets);
    planar_polygon polygon;
    std::vector<std::uint32_t> global;
    std::unordered_map<std::uint32_t, std::uint32_t> local;
    for (const auto& loop : loops_of(part)) {
      const auto points = changed(loop, part.surface);
      if (points.empty())
        continue;
      auto& row = polygon.loops.emplace_back();
      for (const auto p : points) {
        const auto [at, fresh] = local.try_emplace(p, static_cast<std::uint32_t>(global.size()));
        if (fresh) {
          global.push_back(p);
          polygon.points.push_back(map.flatten(shell_.surface.points[p]));
        }
        row.push_back(at->second);
      }
    }
    if (!has_room(polygon, part, map))
      return too_large(part);
    auto filling = host.triangulate(polygon, 0);
    if (!filling)
      return too_large(part);
    *filling = graded_fill(polygon, std::move(*filling));
    for (std::size_t i = polygon.points.size(); i < filling->points.size(); ++i)
      global.push_back(add_point(map.lift(filling->points[i]), no_id));
    for (const auto& t : filling->triangles)
      add_triangle({global[t[0]], global[t[1]], global[t[2]]}, part.surface, 0);
    return {};
  }

  /// What is left of the piece must be a proper area: the loops' signed areas add up to more than
  /// nothing, and the first of them goes round it.
  [[nodiscard]] bool has_room(const planar_polygon& polygon, const piece&, const wall_map&) const {
    double area = 0;
    for (const auto& loop : polygon.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto& a = polygon.points[loop[i]];
        const auto& b = polygon.points[loop[(i + 1) % loop.size()]];
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
      }
    return area > 0;
  }

  [[nodiscard]] tl::unexpected<error> too_large(const piece& part) const {
    const auto& v = mesh_.facet(part.facets.front()).v;
    vec3 at = mesh_.position(v[0]);
    for (const auto f : part.facets)
      for (const auto u : mesh_.facet(f).v)
        if (dropped_.contains(u))
          at = mesh_.position(u);
    return fail(ec::invalid_argument,
                "the rounding reaches " + length_name(made_.widest) + " onto surface " +
                  std::to_string(part.surface) + ", which has no room for that at " +
                  place_name(at),
                "Take a smaller radius");
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
  const round_cuts& cuts_;
  const std::unordered_set<tet_id>& cavity_;
  std::unordered_set<vertex_id> dropped_;
  std::unordered_map<vertex_id, std::size_t> corner_at_;
  std::unordered_map<std::uint64_t, std::size_t> chain_edges_;
  std::vector<facet_id> facets_;
  std::vector<piece> pieces_;
  std::unordered_map<vertex_id, std::uint32_t> old_points_;
  std::vector<std::uint32_t> new_points_;
  round_shell shell_;
};

struct box {
  vec3 low{1e300, 1e300, 1e300};
  vec3 high{-1e300, -1e300, -1e300};

  void add(vec3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  [[nodiscard]] bool meets(const box& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y &&
           low.z <= b.high.z && b.low.z <= high.z;
  }
};

box box_of(const std::array<vec3, 3>& points) {
  box result;
  for (const auto& p : points)
    result.add(p);
  return result;
}

}  // namespace

expected<round_shell> make_shell(const mesh_version& mesh, const round_plan& plan,
                                 const round_surface& made, const round_cuts& cuts,
                                 const std::unordered_set<tet_id>& cavity, services& host) {
  return shell_maker(mesh, plan, made, cuts, cavity).make(host);
}

expected<void> check_free(const mesh_version& mesh, const round_plan& plan,
                          const round_shell& shell) {
  const auto& points = shell.surface.points;
  struct placed {
    std::array<vec3, 3> p;
    std::array<std::uint32_t, 3> index;
    box extent;
  };
  std::vector<placed> fresh;
  box all;
  for (std::size_t i = shell.kept; i < shell.surface.triangles.size(); ++i) {
    const auto& t = shell.surface.triangles[i];
    placed one{{points[t[0]], points[t[1]], points[t[2]]}, t, {}};
    one.extent = box_of(one.p);
    for (const auto& p : one.p)
      all.add(p);
    fresh.push_back(one);
  }
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f) || shell.replaced.contains(f))
      continue;
    const auto& v = mesh.facet(f).v;
    const std::array<vec3, 3> p{mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
    const auto extent = box_of(p);
    if (!extent.meets(all))
      continue;
    for (const auto& one : fresh) {
      if (!one.extent.meets(extent) || std::ranges::any_of(one.index, [&](std::uint32_t k) {
            return shell.vertices[k] != no_id && std::ranges::count(v, shell.vertices[k]) > 0;
          }))
        continue;
      if (triangles_intersect(one.p, p))
        return fail(ec::cap_intersects,
                    "the rounding of " + plan.chains.front().name(mesh) +
                      " would run into surface " + std::to_string(mesh.facet(f).surface) + " at " +
                      place_name(p[0]),
                    "Take a smaller radius");
    }
  }
  return {};
}

}  // namespace tedit::ops
