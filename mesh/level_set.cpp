// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/level_set.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/level_set_freedom.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

struct crossed_edge {
  vertex_id a, b;  ///< a is the end nearer to the level.
  double at = 0;   ///< Where the level crosses, from a to b, in (0, 0.5].
  double length = 0;
};

/// Steps of the search for the level along an edge; each halves the interval at least.
constexpr int root_steps = 60;

class level_cutter {
public:
  level_cutter(mesh_builder& mesh, const level_set_settings& settings)
      : mesh_(mesh), settings_(settings) {}

  expected<level_set_cut> cut(const std::vector<tet_id>& region,
                              const std::function<double(vertex_id)>& value, const execution& run) {
    for (const auto t : region)
      for (const auto v : mesh_.tet_at(t).v)
        if (const auto [row, fresh] = result_.values.try_emplace(v, 0.0); fresh) {
          const double f = value(v);
          row->second = std::abs(f) <= settings_.zero ? 0 : f;
        }
    snap(crossings(region));
    auto edges = crossings(region);
    std::ranges::sort(edges, [](const crossed_edge& x, const crossed_edge& y) {
      return x.length != y.length ? x.length > y.length
                                  : std::minmax(x.a, x.b) < std::minmax(y.a, y.b);
    });
    for (const auto& edge : edges) {
      if (run.cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      const auto fresh = split_edge(mesh_, edge.a, edge.b, crossing(edge));
      if (!fresh)
        return fail(fresh.error());
      result_.values[*fresh] = 0;
      ++result_.splits;
    }
    for (const auto& [v, f] : result_.values)
      if (f == 0)
        result_.on_level.insert(v);
    return std::move(result_);
  }

private:
  [[nodiscard]] std::vector<crossed_edge> crossings(const std::vector<tet_id>& region) const {
    std::vector<crossed_edge> edges;
    std::unordered_set<std::uint64_t> seen;
    for (const auto t : region) {
      const auto& corner = mesh_.tet_at(t).v;
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j) {
          auto [a, b] = std::minmax(corner[i], corner[j]);
          const double fa = result_.values.at(a);
          const double fb = result_.values.at(b);
          if (!(fa < 0 && fb > 0) && !(fa > 0 && fb < 0))
            continue;
          if (!seen.insert(std::uint64_t{a} << 32 | b).second)
            continue;
          const double length = norm(mesh_.position(a) - mesh_.position(b));
          const double at = std::abs(fa) / (std::abs(fa) + std::abs(fb));
          edges.push_back(at <= 0.5 ? crossed_edge{a, b, at, length}
                                    : crossed_edge{b, a, 1 - at, length});
        }
    }
    return edges;
  }

  /// Where the level crosses the edge: by linear interpolation, then by bisection between points of
  /// both signs where the exact function is known.
  [[nodiscard]] vec3 crossing(const crossed_edge& edge) const {
    const vec3 a = mesh_.position(edge.a);
    const vec3 b = mesh_.position(edge.b);
    const auto point = [&](double t) { return a + t * (b - a); };
    double t = edge.at;
    if (!settings_.exact)
      return point(t);
    double low = 0;
    double high = 1;
    const bool rising = result_.values.at(edge.a) < 0;
    for (int step = 0; step < root_steps && high - low > 1e-15; ++step) {
      const double f = settings_.exact(point(t));
      if (f == 0)
        break;
      ((f < 0) == rising ? low : high) = t;
      t = 0.5 * (low + high);
    }
    // An end's value may differ in sign from the function's by its tolerance: stay inside the edge.
    return point(std::clamp(t, 1e-3, 1 - 1e-3));
  }

  /// Moves vertices that lie close beside the level onto it, the nearest first.
  void snap(std::vector<crossed_edge> edges) {
    std::erase_if(edges, [&](const crossed_edge& e) { return e.at >= settings_.snap; });
    std::ranges::sort(edges, [](const crossed_edge& x, const crossed_edge& y) {
      return std::tie(x.at, x.a, x.b) < std::tie(y.at, y.a, y.b);
    });
    for (const auto& edge : edges) {
      auto& f = result_.values.at(edge.a);
      if (f == 0 || result_.values.at(edge.b) == 0)
        continue;
      if (move_onto_level(edge)) {
        f = 0;
        ++result_.snaps;
      }
    }
  }

  [[nodiscard]] bool leaves_sheet(const crossed_edge& edge) const {
    return std::ranges::any_of(settings_.sheets, [&](const auto* sheet) {
      return sheet->contains(edge.a) && !sheet->contains(edge.b);
    });
  }

  bool move_onto_level(const crossed_edge& edge) {
    const vec3 before = mesh_.position(edge.a);
    const auto star = mesh_.star(edge.a);
    if (leaves_sheet(edge) ||
        !freedom_of(mesh_, edge.a, star).allows(mesh_.position(edge.b) - before))
      return false;
    const double worst = worst_of(star);
    mesh_.set_position(edge.a, crossing(edge));
    const bool good = std::ranges::all_of(star, [&](tet_id t) {
      const auto c = mesh_.corners(t);
      return orient3d(c[0], c[1], c[2], c[3]) > 0;
    });
    if (good && worst_of(star) >= std::min(settings_.floor, worst))
      return true;
    mesh_.set_position(edge.a, before);
    return false;
  }

  [[nodiscard]] double worst_of(const std::vector<tet_id>& star) const {
    double worst = 1;
    for (const auto t : star)
      worst = std::min(worst, radius_ratio(mesh_.corners(t)));
    return worst;
  }

  mesh_builder& mesh_;
  const level_set_settings& settings_;
  level_set_cut result_;
};

template <std::size_t N>
bool holds_edge(const std::array<vertex_id, N>& v, vertex_id a, vertex_id b) {
  return std::ranges::count(v, a) > 0 && std::ranges::count(v, b) > 0;
}

template <std::size_t N>
std::array<vertex_id, N> replaced(std::array<vertex_id, N> v, vertex_id from, vertex_id to) {
  std::ranges::replace(v, from, to);
  return v;
}

/// Interface facets live in one dense list: those at the edge are cut in two as the tets are.
void split_interfaces(mesh_builder& mesh, vertex_id a, vertex_id b, vertex_id middle) {
  std::vector<interface_facet> rows;
  std::vector<interface_facet> halves;
  const auto& interfaces = mesh.interfaces();
  bool changed = false;
  for (std::size_t i = 0; i < interfaces.size(); ++i)
    changed = changed || holds_edge(interfaces[i].v, a, b);
  if (!changed)
    return;
  for (auto row : interfaces.to_vector()) {
    if (holds_edge(row.v, a, b)) {
      halves.push_back(row);
      halves.back().v = replaced(row.v, a, middle);
      row.v = replaced(row.v, b, middle);
    }
    rows.push_back(row);
  }
  rows.insert(rows.end(), halves.begin(), halves.end());
  mesh.set_interfaces(rows);
}

}  // namespace

expected<level_set_cut> split_at_level(mesh_builder& mesh, const std::vector<tet_id>& region,
                                       const std::function<double(vertex_id)>& value,
                                       const level_set_settings& settings, const execution& run) {
  return level_cutter(mesh, settings).cut(region, value, run);
}

expected<vertex_id> split_edge(mesh_builder& mesh, vertex_id a, vertex_id b, vec3 at) {
  const auto middle = mesh.add_vertex(at);
  cavity_change change;
  change.removed = mesh.edge_ring(a, b);
  bool between_regions = false;
  for (const auto t : change.removed) {
    const auto region = mesh.region_of(t);
    between_regions = between_regions || region != mesh.region_of(change.removed.front());
    for (const auto end : {a, b}) {
      const tet half{replaced(mesh.tet_at(t).v, end, middle)};
      const auto& v = half.v;
      if (orient3d(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]),
                   mesh.position(v[3])) <= 0)
        return fail(ec::degenerate_tet,
                    "tet " + std::to_string(t) + " is too flat to be cut (radius ratio " +
                      std::to_string(radius_ratio(mesh.corners(t))) + ")",
                    "Improve the mesh there first", "tet " + std::to_string(t));
      change.added.push_back({half, region});
    }
    for (const auto behind : mesh.neighbours(t)) {
      if (!is_facet(behind))
        continue;
      const auto& facet = mesh.facet(behind & ~facet_flag);
      if (holds_edge(facet.v, a, b))
        for (const auto end : {a, b})
          change.facets.push_back({replaced(facet.v, end, middle), facet.surface});
    }
  }
  if (const auto added = mesh.apply(change); !added)
    return fail(added.error());
  if (between_regions)
    split_interfaces(mesh, a, b, middle);
  return middle;
}

}  // namespace tedit
