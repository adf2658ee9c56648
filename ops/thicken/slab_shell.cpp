// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/thicken/slab_shell.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <unordered_set>

#include "mesh/level_set.hpp"
#include "mesh/level_set_freedom.hpp"
#include "ops/shapes/new_triangles.hpp"

namespace tedit::ops {

namespace {

/// A neighbour that looks down on the patch by more than this (cosine) is no wall but a roof.
constexpr double roof = -0.5;
/// Behind a convex edge that bends by more a rising neighbour ends, rad.
constexpr double most_bend = std::numbers::pi / 6;
/// The same where another surface begins beside it, which does not touch the patch, rad.
constexpr double least_bend = std::numbers::pi / 180;
/// Edges that rise less, m per m, run along the patch.
constexpr double level_slope = 1e-3;

std::uint64_t edge_key(vertex_id a, vertex_id b) {
  return std::uint64_t{a} << 32 | b;
}

/// The boundary around a patch, with heights above it.
class patch_surroundings {
public:
  patch_surroundings(const mesh_builder& mesh, const surface_patch& patch, double height)
      : mesh_(mesh), patch_(patch), height_(height), zero_(1e-7 * patch.mean_edge) {}

  /// Height above the patch less the slab's: below zero inside the slab.
  [[nodiscard]] double above_top(vertex_id v) const {
    const double f = -patch_.depth(mesh_.position(v)) - height_;
    return std::abs(f) <= zero_ ? 0 : f;
  }

  /// The facet whose edge goes from a to b.
  [[nodiscard]] facet_id left_of(vertex_id a, vertex_id b) const {
    const auto found = left_among(facets_at(mesh_, a, mesh_.star(a)), a, b);
    // A star is one fan; where two touch in a vertex the other end may know.
    return found == no_id ? left_among(facets_at(mesh_, b, mesh_.star(b)), a, b) : found;
  }

  /// The facets of rising neighbours that reach into the slab, without crossing a convex edge:
  /// behind one the neighbour turns away from the slab.
  [[nodiscard]] std::vector<facet_id> rising() const {
    std::vector<facet_id> found;
    std::unordered_set<facet_id> seen;
    const auto visit = [&](facet_id f) {
      if (f == no_id || mesh_.facet(f).surface == patch_.surface || !seen.insert(f).second)
        return;
      const auto& v = mesh_.facet(f).v;
      const auto inside = [&](vertex_id u) { return above_top(u) < 0; };
      const auto higher = [&](vertex_id u) { return height(u) > zero_; };
      if (std::ranges::any_of(v, inside) && std::ranges::any_of(v, higher))
        found.push_back(f);
    };
    std::unordered_set<surface_id> beside;
    for (const auto& edge : patch_.border)
      if (!edge.convex()) {
        visit(edge.outer);
        beside.insert(mesh_.facet(edge.outer).surface);
      }
    for (std::size_t next = 0; next < found.size(); ++next)
      for (int i = 0; i < 3; ++i) {
        const auto& v = mesh_.facet(found[next]).v;
        const auto across = left_of(v[(i + 1) % 3], v[i]);
        if (across == no_id)
          continue;
        const double bend = bend_at(found[next], across, v[i], v[(i + 1) % 3]);
        // A wall that ends sideways at a rounding: the slab ends with it.
        const bool ends = bend > least_bend && !beside.contains(mesh_.facet(across).surface) &&
                          !level(v[i], v[(i + 1) % 3]);
        if (!ends && bend <= most_bend)
          visit(across);
      }
    return found;
  }

  [[nodiscard]] double zero() const { return zero_; }

private:
  [[nodiscard]] facet_id left_among(const std::vector<facet_id>& facets, vertex_id a,
                                    vertex_id b) const {
    facet_id result = no_id;
    for (const auto f : facets)
      for (int i = 0; i < 3; ++i)
        if (mesh_.facet(f).v[i] == a && mesh_.facet(f).v[(i + 1) % 3] == b)
          result = result == no_id ? f : std::max(result, f);
    return result;
  }

  [[nodiscard]] vec3 normal(facet_id f) const {
    const auto& v = mesh_.facet(f).v;
    return normalized(
      area_vector(mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2])));
  }

  /// By how much the boundary turns away from the slab at the edge, rad.
  [[nodiscard]] double bend_at(facet_id f, facet_id g, vertex_id a, vertex_id b) const {
    const vec3 along = normalized(mesh_.position(b) - mesh_.position(a));
    return std::atan2(dot(along, cross(normal(f), normal(g))), dot(normal(f), normal(g)));
  }

  /// Does the edge run along the patch, at one height above it?
  [[nodiscard]] bool level(vertex_id a, vertex_id b) const {
    return std::abs(height(a) - height(b)) <=
           level_slope * norm(mesh_.position(a) - mesh_.position(b));
  }

  [[nodiscard]] double height(vertex_id v) const { return -patch_.depth(mesh_.position(v)); }

  const mesh_builder& mesh_;
  const surface_patch& patch_;
  double height_;
  double zero_;
};

class shell_builder {
public:
  shell_builder(const mesh_builder& mesh, const surface_patch& patch, double height)
      : mesh_(mesh), patch_(patch), height_(height), around_(mesh, patch, height) {
    const vec3 n = patch.normal;
    const vec3 helper = std::abs(n.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
    u_ = normalized(cross(helper, n));
    w_ = cross(n, u_);
    layers_ = std::max(1, static_cast<int>(std::lround(height / patch.mean_edge)));
  }

  expected<slab_shell> build(services& host) {
    shell_.covered = patch_.facets;
    for (const auto f : around_.rising()) {
      const auto& v = mesh_.facet(f).v;
      const vec3 n =
        normalized(area_vector(mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2])));
      if (dot(n, patch_.normal) < roof)
        return fail(ec::cap_intersects,
                    "the slab would run into surface " + std::to_string(mesh_.facet(f).surface) +
                      ", which hangs over surface " + std::to_string(patch_.surface));
      shell_.covered.push_back(f);
    }
    for (const auto f : shell_.covered) {
      const auto& v = mesh_.facet(f).v;
      shell_.surface.triangles.push_back({point_of(v[0]), point_of(v[2]), point_of(v[1])});
    }
    collect_rim();
    for (const auto& edge : rim_)
      add_side(edge);
    if (auto ok = add_cap(host); !ok)
      return fail(ok.error());
    if (!closed())
      return fail(ec::not_a_hole, "the space above surface " + std::to_string(patch_.surface) +
                                    " is not bounded by sides that go straight up");
    return std::move(shell_);
  }

private:
  struct rim_edge {
    vertex_id a, b;
    facet_id outer;
  };
  using column = std::vector<std::uint32_t>;  ///< Points above each other, lowest first.

  std::uint32_t point_of(vertex_id v) {
    const auto [at, fresh] =
      index_.emplace(v, static_cast<std::uint32_t>(shell_.surface.points.size()));
    if (fresh) {
      shell_.surface.points.push_back(mesh_.position(v));
      shell_.vertices.push_back(v);
    }
    return at->second;
  }

  std::uint32_t new_point(vec3 p) {
    shell_.surface.points.push_back(p);
    shell_.vertices.push_back(no_id);
    return static_cast<std::uint32_t>(shell_.surface.points.size() - 1);
  }

  [[nodiscard]] double level(std::uint32_t point) const {
    return -patch_.depth(shell_.surface.points[point]);
  }

  void collect_rim() {
    std::unordered_set<std::uint64_t> own;
    for (const auto f : shell_.covered)
      for (int i = 0; i < 3; ++i)
        own.insert(edge_key(mesh_.facet(f).v[i], mesh_.facet(f).v[(i + 1) % 3]));
    for (const auto f : shell_.covered)
      for (int i = 0; i < 3; ++i) {
        const auto a = mesh_.facet(f).v[i];
        const auto b = mesh_.facet(f).v[(i + 1) % 3];
        if (!own.contains(edge_key(b, a)))
          rim_.push_back({a, b, around_.left_of(b, a)});
      }
    for (const auto& edge : rim_)
      add_to_column(edge.a);
    for (auto& points : columns_)
      complete(points);
  }

  /// Rim vertices above each other share a column.
  void add_to_column(vertex_id v) {
    if (column_of_.contains(v))
      return;
    const auto point = point_of(v);
    const vec3 p = mesh_.position(v);
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const vec3 d = shell_.surface.points[columns_[c].front()] - p;
      if (norm(d - dot(d, patch_.normal) * patch_.normal) > 10 * around_.zero())
        continue;
      columns_[c].push_back(point);
      column_of_[v] = c;
      return;
    }
    column_of_[v] = columns_.size();
    columns_.push_back({point});
  }

  void complete(column& points) {
    std::ranges::sort(points, {}, [&](std::uint32_t p) { return level(p); });
    const double last = level(points.back());
    if (last >= height_ - around_.zero())
      return;
    const vec3 base = shell_.surface.points[points.back()];
    const int steps =
      std::max(1, static_cast<int>(std::lround(layers_ * (height_ - last) / height_)));
    for (int k = 1; k <= steps; ++k)
      points.push_back(new_point(base + ((height_ - last) * k / steps) * patch_.normal));
  }

  /// The strip of triangles between the columns over an edge, the lower step first.
  void add_side(const rim_edge& edge) {
    const auto& left = columns_[column_of_.at(edge.a)];
    const auto& right = columns_[column_of_.at(edge.b)];
    if (&left == &right)
      return;
    auto i = static_cast<std::size_t>(std::ranges::find(left, index_.at(edge.a)) - left.begin());
    auto j = static_cast<std::size_t>(std::ranges::find(right, index_.at(edge.b)) - right.begin());
    while (i + 1 < left.size() || j + 1 < right.size()) {
      const bool go_left =
        j + 1 == right.size() || (i + 1 < left.size() && level(left[i + 1]) <= level(right[j + 1]));
      const auto next = go_left ? left[i + 1] : right[j + 1];
      shell_.surface.triangles.push_back({left[i], right[j], next});
      shell_.neighbour.push_back(edge.outer);
      ++(go_left ? i : j);
    }
  }

  expected<void> add_cap(services& host) {
    std::map<std::uint32_t, std::uint32_t> next;
    for (const auto& edge : rim_) {
      const auto from = columns_[column_of_.at(edge.a)].back();
      const auto to = columns_[column_of_.at(edge.b)].back();
      if (from != to && !next.emplace(from, to).second)
        return fail(ec::not_a_hole,
                    "the border of surface " + std::to_string(patch_.surface) + " touches itself",
                    "Select a surface with a simple border");
    }
    planar_polygon polygon;
    std::vector<std::uint32_t> global;
    while (!next.empty()) {
      auto& loop = polygon.loops.emplace_back();
      for (auto row = next.begin(); row != next.end();) {
        const vec3 d = shell_.surface.points[row->first] - patch_.origin;
        loop.push_back(static_cast<std::uint32_t>(polygon.points.size()));
        polygon.points.push_back({dot(d, u_), dot(d, w_)});
        global.push_back(row->first);
        const auto to = row->second;
        next.erase(row);
        row = next.find(to);
      }
    }
    auto filling = host.triangulate(polygon, patch_.mean_edge);
    if (!filling)
      return fail(filling.error());
    for (std::size_t i = polygon.points.size(); i < filling->points.size(); ++i) {
      const auto& p = filling->points[i];
      global.push_back(new_point(patch_.origin + p[0] * u_ + p[1] * w_ + height_ * patch_.normal));
    }
    shell_.cap_first = shell_.surface.triangles.size();
    for (const auto& t : filling->triangles)
      shell_.surface.triangles.push_back({global[t[0]], global[t[1]], global[t[2]]});
    return {};
  }

  [[nodiscard]] bool closed() const {
    std::unordered_set<std::uint64_t> edges;
    for (const auto& t : shell_.surface.triangles)
      for (int i = 0; i < 3; ++i)
        if (!edges.insert(edge_key(t[i], t[(i + 1) % 3])).second)
          return false;
    return std::ranges::all_of(edges,
                               [&](std::uint64_t e) { return edges.contains(e << 32 | e >> 32); });
  }

  const mesh_builder& mesh_;
  const surface_patch& patch_;
  double height_;
  patch_surroundings around_;
  vec3 u_, w_;
  int layers_ = 1;
  slab_shell shell_;
  std::vector<rim_edge> rim_;
  std::unordered_map<vertex_id, std::uint32_t> index_;
  std::unordered_map<vertex_id, std::size_t> column_of_;
  std::vector<column> columns_;
};

}  // namespace

expected<void> split_rising_neighbours(mesh_builder& mesh, const surface_patch& patch,
                                       double height, const execution& run) {
  const patch_surroundings around(mesh, patch, height);
  std::vector<tet_id> region;
  for (const auto f : around.rising())
    region.push_back(mesh.facet(f).tet);
  std::ranges::sort(region);
  const auto last = std::ranges::unique(region);
  region.erase(last.begin(), last.end());
  level_set_settings settings;
  settings.zero = around.zero();
  const auto done = split_at_level(
    mesh, region, [&](vertex_id v) { return around.above_top(v); }, settings, run);
  if (!done)
    return fail(done.error());
  return {};
}

expected<slab_shell> make_slab_shell(const mesh_builder& mesh, const surface_patch& patch,
                                     double height, services& host) {
  return shell_builder(mesh, patch, height).build(host);
}

expected<void> check_free(const mesh_builder& mesh, const slab_shell& shell) {
  const std::unordered_set<facet_id> covered(shell.covered.begin(), shell.covered.end());
  const new_triangles made(shell.surface, shell.vertices, shell.covered.size());
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f) || covered.contains(f))
      continue;
    const auto& v = mesh.facet(f).v;
    if (made.meet(v, {mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])}))
      return fail(ec::cap_intersects,
                  "the slab would run into surface " + std::to_string(mesh.facet(f).surface));
  }
  return {};
}

}  // namespace tedit::ops
