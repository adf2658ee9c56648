// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/round_loops.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/features/rims.hpp"

namespace tedit::ops {

namespace {

/// Edges may grow by this share of the distance from fine ones, and be longer by this factor.
constexpr double growth = 0.5;
constexpr double too_long = 1.6;

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{a} << 32 | b;
}

class piece_finder {
public:
  piece_finder(const mesh_version& mesh, const round_plan& plan, const round_surface& made,
               const round_cuts& cuts, const std::unordered_set<tet_id>& cavity,
               shell_points& points, std::unordered_set<facet_id>& replaced)
      : mesh_(mesh), plan_(plan), made_(made), cuts_(cuts), points_(points), replaced_(replaced) {
    dropped_.insert(cuts.dropped.begin(), cuts.dropped.end());
    for (std::size_t i = 0; i < plan.corners.size(); ++i)
      corner_at_[plan.corners[i].at] = i;
    for (std::size_t c = 0; c < plan.chains.size(); ++c) {
      const auto& path = plan.chains[c].path;
      for (std::size_t i = 0; i + (plan.chains[c].closed ? 0 : 1) < path.size(); ++i)
        chain_edges_[edge_key(path[i], path[(i + 1) % path.size()])] = c;
    }
    for (const auto t : cavity)
      for (const auto behind : mesh.neighbours(t))
        if (is_facet(behind))
          inside_.insert(behind & ~facet_flag);
  }

  std::vector<wall_piece> find() {
    std::vector<facet_id> facets(inside_.begin(), inside_.end());
    std::ranges::sort(facets);
    for (const auto f : facets)
      if (changes(f) && !replaced_.contains(f))
        add_piece(f, plan_.shapes.at(mesh_.facet(f).surface));
    measure();
    for (std::size_t next = 0; next < pieces_.size(); ++next)
      take_in_neighbours(pieces_[next]);
    split_edges();
    return std::move(pieces_);
  }

private:
  struct loop_edge {
    vertex_id from, to;
    facet_id inner;
    facet_id across;
  };

  [[nodiscard]] bool changes(facet_id f) const {
    return std::ranges::any_of(mesh_.facet(f).v, [&](vertex_id v) {
      return dropped_.contains(v) || corner_at_.contains(v);
    });
  }

  void add_piece(facet_id seed, const exact_wall& shape) {
    wall_piece part;
    part.surface = mesh_.facet(seed).surface;
    part.shape = shape;
    part.facets.push_back(seed);
    replaced_.insert(seed);
    for (std::size_t next = 0; next < part.facets.size(); ++next)
      for (int i = 0; i < 3; ++i) {
        const auto across = facet_across(mesh_, part.facets[next], i);
        if (inside_.contains(across) && mesh_.facet(across).surface == part.surface &&
            replaced_.insert(across).second)
          part.facets.push_back(across);
      }
    for (const auto& loop : loops_of(part)) {
      auto out = changed(loop, part.surface);
      if (!out.empty())
        part.loops.push_back(std::move(out));
      for (const auto& e : loop)
        across_[edge_key(e.from, e.to)] = e.across;
    }
    pieces_.push_back(std::move(part));
  }

  // -- fine and coarse ----------------------------------------------------------------

  /// The rounded surface's and the borders' edge lengths, at their points.
  void measure() {
    const auto add = [&](std::uint32_t a, std::uint32_t b) {
      const double length = norm(points_[a] - points_[b]);
      for (const auto i : {a, b}) {
        const auto row = sizes_.try_emplace(i, length).first;
        row->second = std::min(row->second, length);
      }
    };
    for (const auto& part : pieces_)
      for (const auto& loop : part.loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
          add(loop[i], loop[(i + 1) % loop.size()]);
  }

  [[nodiscard]] double size_at(vec3 p) const {
    double size = 1e300;
    for (const auto& [i, length] : sizes_)
      size = std::min(size, length + growth * norm(points_[i] - p));
    return size;
  }

  [[nodiscard]] bool is_long(std::uint32_t a, std::uint32_t b) const {
    return norm(points_[a] - points_[b]) > too_long * size_at(0.5 * (points_[a] + points_[b]));
  }

  /// Flat walls inside the cavity across edges that are too long.
  void take_in_neighbours(const wall_piece& part) {
    std::vector<facet_id> seeds;
    for (const auto& loop : part.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto a = points_.vertex(loop[i]);
        const auto b = points_.vertex(loop[(i + 1) % loop.size()]);
        const auto found = across_.find(edge_key(a, b));
        if (a != no_id && b != no_id && found != across_.end() && inside_.contains(found->second) &&
            mesh_.facet(found->second).surface != part.surface &&
            is_long(loop[i], loop[(i + 1) % loop.size()]))
          seeds.push_back(found->second);
      }
    for (const auto f : seeds) {
      if (replaced_.contains(f))
        continue;
      const auto surface = mesh_.facet(f).surface;
      // A flat wall stays as it is under new triangles; a coarse round one would not.
      const auto shape = fit_wall(mesh_, facets_of(mesh_, std::vector{surface}));
      if (shape && shape->type == wall_shape::kind::plane)
        add_piece(f, exact_wall{*shape});
    }
  }

  /// Halves the edges that two pieces share as long as they are too long.
  void split_edges() {
    std::unordered_set<std::uint64_t> all;
    for (const auto& part : pieces_)
      for (const auto& loop : part.loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
          all.insert(edge_key(loop[i], loop[(i + 1) % loop.size()]));
    for (auto& part : pieces_)
      for (auto& loop : part.loops) {
        std::vector<std::uint32_t> out;
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const auto a = loop[i];
          const auto b = loop[(i + 1) % loop.size()];
          out.push_back(a);
          if (all.contains(edge_key(b, a)))
            split(a, b, out);
        }
        loop = std::move(out);
      }
  }

  void split(std::uint32_t a, std::uint32_t b, std::vector<std::uint32_t>& out) {
    const auto key = edge_key(std::min(a, b), std::max(a, b));
    auto found = middles_.find(key);
    if (found == middles_.end()) {
      const auto middle = is_long(a, b) ? points_.add(0.5 * (points_[a] + points_[b])) : no_id;
      found = middles_.emplace(key, middle).first;
    }
    const auto middle = found->second;
    if (middle == no_id)
      return;
    split(a, middle, out);
    out.push_back(middle);
    split(middle, b, out);
  }

  // -- loops --------------------------------------------------------------------------

  [[nodiscard]] int edge_from(facet_id f, vertex_id v) const {
    const auto& c = mesh_.facet(f).v;
    return static_cast<int>(std::ranges::find(c, v) - c.begin());
  }

  /// The closed runs of edges around a piece; at a vertex where several meet the walk turns inside.
  [[nodiscard]] std::vector<std::vector<loop_edge>> loops_of(const wall_piece& part) const {
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
  void add_border(std::size_t c, surface_id own, std::vector<std::uint32_t>& out) {
    const auto& rows = made_.strips[c].rows;
    if (plan_.chains[c].a == own)
      for (const auto& row : rows)
        out.push_back(points_.of_rounded(row.front()));
    else
      for (auto row = rows.rbegin(); row != rows.rend(); ++row)
        out.push_back(points_.of_rounded(row->back()));
  }

  /// The arc in the wall at which a chain ends, coming from the edge `e`.
  void add_arc(const round_corner& corner, const loop_edge& e, std::vector<std::uint32_t>& out) {
    const auto& end = corner.ends.front();
    const auto& rows = made_.strips[end.chain].rows;
    auto row = end.last ? rows.back() : rows.front();
    if (mesh_.facet(e.across).surface != plan_.chains[end.chain].a)
      std::ranges::reverse(row);
    for (const auto p : row)
      out.push_back(points_.of_rounded(p));
  }

  void add_vertex(const loop_edge& in, const loop_edge& out, surface_id own,
                  std::vector<std::uint32_t>& border) {
    const auto v = in.to;
    const bool after_chain = chain_of(in) < plan_.chains.size();
    const bool before_chain = chain_of(out) < plan_.chains.size();
    const auto corner = corner_at_.find(v);
    if (corner == corner_at_.end()) {
      if (!dropped_.contains(v))
        border.push_back(points_.of_vertex(v));
      return;
    }
    if (!after_chain && grows(v, own, in))
      border.push_back(points_.of_vertex(v));
    if (!after_chain && !before_chain)
      add_arc(plan_.corners[corner->second], in, border);
    if (!before_chain && grows(v, own, out))
      border.push_back(points_.of_vertex(v));
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
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto c = chain_of(loop[i]);
      if (c != none && (i == 0 || chain_of(loop[i - 1]) != c))
        add_border(c, own, out);
      const auto& next = loop[(i + 1) % loop.size()];
      if (c == none || chain_of(next) != c)
        add_vertex(loop[i], next, own, out);
    }
    out.erase(std::ranges::unique(out).begin(), out.end());
    while (out.size() > 1 && out.front() == out.back())
      out.pop_back();
    return out;
  }

  const mesh_version& mesh_;
  const round_plan& plan_;
  const round_surface& made_;
  const round_cuts& cuts_;
  shell_points& points_;
  std::unordered_set<facet_id>& replaced_;
  std::unordered_set<vertex_id> dropped_;
  std::unordered_map<vertex_id, std::size_t> corner_at_;
  std::unordered_map<std::uint64_t, std::size_t> chain_edges_;
  std::unordered_set<facet_id> inside_;
  std::vector<wall_piece> pieces_;
  std::unordered_map<std::uint64_t, facet_id> across_;  ///< By mesh vertices.
  std::map<std::uint32_t, double> sizes_;
  std::unordered_map<std::uint64_t, std::uint32_t> middles_;
};

}  // namespace

std::uint32_t shell_points::add(vec3 p, vertex_id v) {
  shell_.surface.points.push_back(p);
  shell_.vertices.push_back(v);
  return static_cast<std::uint32_t>(shell_.surface.points.size() - 1);
}

std::uint32_t shell_points::of_vertex(vertex_id v) {
  const auto [row, fresh] = vertices_.try_emplace(v, 0);
  if (fresh)
    row->second = add(mesh_.position(v), v);
  return row->second;
}

std::uint32_t shell_points::of_rounded(std::uint32_t i) {
  if (rounded_[i] == no_id)
    rounded_[i] = add(made_.points[i]);
  return rounded_[i];
}

std::vector<wall_piece> find_pieces(const mesh_version& mesh, const round_plan& plan,
                                    const round_surface& made, const round_cuts& cuts,
                                    const std::unordered_set<tet_id>& cavity, shell_points& points,
                                    std::unordered_set<facet_id>& replaced) {
  return piece_finder(mesh, plan, made, cuts, cavity, points, replaced).find();
}

}  // namespace tedit::ops
