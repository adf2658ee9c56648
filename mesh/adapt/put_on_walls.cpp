// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/adapt/put_on_walls.hpp"

#include <algorithm>
#include <map>

#include "mesh/adapt/wall_demands.hpp"
#include "mesh/optimize/improve.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

/// What the worst tet around a vertex may become, where it was better.
constexpr double kept_quality = 0.1;
constexpr int rounds_of_mending = 3;
constexpr double parts_of_way[] = {1.0, 0.5, 0.25};

class wall_putter {
public:
  wall_putter(mesh_builder& mesh, const wall_finder& wall_at, const execution& run)
      : mesh_(mesh), wall_at_(wall_at), run_(run) {}

  expected<walls_report> put() {
    find_vertices();
    for (const auto& [v, demands] : at_)
      find_place(v, demands);
    auto open = all_at_once();
    for (int round = 0; !open.empty() && round <= rounds_of_mending; ++round) {
      if (run_.cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      if (round > 0)
        if (auto ok = make_room(open); !ok)
          return fail(ok.error());
      std::erase_if(open, [&](vertex_id v) { return goes(v); });
    }
    report_.moved = ways_.size() - open.size();
    report_.changed = std::ranges::any_of(
      ways_, [&](const auto& row) { return !(mesh_.position(row.first) == row.second.from); });
    for (const auto v : open)
      leave(v);
    return report_;
  }

private:
  struct way {
    vec3 from;
    vec3 to;
    double floor = 0;  ///< Of the tets around.
  };

  [[nodiscard]] bool is_new(vertex_id v) const {
    const auto& base = *mesh_.base();
    return v >= base.vertex_slots() || !base.is_live_vertex(v) ||
           !(base.position(v) == mesh_.position(v));
  }

  /// New vertices of the skin at round walls.
  void find_vertices() {
    std::map<vertex_id, std::vector<facet_id>> facets;
    for (const auto t : mesh_.touched())
      for (const auto n : mesh_.neighbours(t))
        if (is_facet(n))
          for (const auto v : mesh_.facet(n & ~facet_flag).v)
            if (is_new(v))
              facets[v].push_back(n & ~facet_flag);
    for (const auto& [v, around] : facets) {
      auto demands = demands_of(v, around);
      if (std::ranges::any_of(demands, [](const wall_demand& d) { return d.wall != nullptr; }))
        at_.emplace(v, std::move(demands));
    }
  }

  [[nodiscard]] vec3 area_of(facet_id f) const {
    const auto& v = mesh_.facet(f).v;
    return area_vector(mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2]));
  }

  [[nodiscard]] std::vector<wall_demand> demands_of(vertex_id v,
                                                    const std::vector<facet_id>& around) const {
    std::map<surface_id, std::vector<vec3>> planes;
    std::vector<wall_demand> result;
    for (const auto f : around)
      planes[mesh_.facet(f).surface].push_back(area_of(f));
    for (const auto& [id, areas] : planes)
      if (const auto* wall = wall_at_(id, mesh_.position(v)); wall && !wall->flat())
        result.push_back({wall, {}});
      else
        add_planes(areas, wall == nullptr, result);
    return result;
  }

  void find_place(vertex_id v, const std::vector<wall_demand>& demands) {
    const auto place = place_on_walls(demands, mesh_.position(v));
    if (place.is_there())
      return;
    off_[v] = place.before;
    if (!place.found || between_regions(v))
      leave(v);
    else
      ways_.emplace(v, way{mesh_.position(v), place.at, std::min(kept_quality, worst_around(v))});
  }

  void leave(vertex_id v) {
    ++report_.left;
    report_.furthest = std::max(report_.furthest, off_.at(v));
  }

  [[nodiscard]] bool between_regions(vertex_id v) const {
    const auto star = mesh_.star(v);
    return std::ranges::any_of(
      star, [&](tet_id t) { return mesh_.region_of(t) != mesh_.region_of(star.front()); });
  }

  [[nodiscard]] double worst_around(vertex_id v) const {
    double worst = 1;
    for (const auto t : mesh_.star(v))
      worst = std::min(worst, radius_ratio(mesh_.corners(t)));
    return worst;
  }

  [[nodiscard]] bool fits(tet_id t, double floor) const {
    const auto p = mesh_.corners(t);
    return orient3d(p[0], p[1], p[2], p[3]) > 0 && radius_ratio(p) >= floor;
  }

  /// Returns those that had to stay where they were.
  std::vector<vertex_id> all_at_once() {
    for (const auto& [v, way] : ways_)
      mesh_.set_position(v, way.to);
    std::vector<vertex_id> moved;
    for (const auto& [v, way] : ways_)
      moved.push_back(v);
    std::vector<vertex_id> stay;
    for (bool changed = true; changed;) {
      changed = false;
      std::erase_if(moved, [&](vertex_id v) {
        const auto& way = ways_.at(v);
        if (std::ranges::all_of(mesh_.star(v), [&](tet_id t) { return fits(t, way.floor); }))
          return false;
        mesh_.set_position(v, way.from);
        stay.push_back(v);
        changed = true;
        return true;
      });
    }
    std::ranges::sort(stay);
    return stay;
  }

  /// Moves a vertex as far as the tets around allow; true where that is the whole way.
  bool goes(vertex_id v) {
    const auto& way = ways_.at(v);
    const vec3 now = mesh_.position(v);
    const auto star = mesh_.star(v);
    for (const double share : parts_of_way) {
      mesh_.set_position(v, share == 1 ? way.to : now + share * (way.to - now));
      if (std::ranges::all_of(star, [&](tet_id t) { return fits(t, way.floor); }))
        return share == 1;
    }
    mesh_.set_position(v, now);
    return false;
  }

  expected<void> make_room(const std::vector<vertex_id>& open) {
    std::vector<tet_id> around;
    for (const auto v : open) {
      const auto star = mesh_.star(v);
      around.insert(around.end(), star.begin(), star.end());
    }
    std::ranges::sort(around);
    around.erase(std::ranges::unique(around).begin(), around.end());
    execution quiet;
    quiet.cancel = run_.cancel;
    if (const auto done = improve(mesh_, around, {}, quiet); !done)
      return fail(done.error());
    return {};
  }

  mesh_builder& mesh_;
  const wall_finder& wall_at_;
  const execution& run_;
  std::map<vertex_id, std::vector<wall_demand>> at_;
  std::map<vertex_id, way> ways_;
  std::map<vertex_id, double> off_;  ///< m: before anything was moved.
  walls_report report_;
};

}  // namespace

expected<walls_report> put_on_walls(mesh_builder& mesh, const wall_finder& wall_at,
                                    const execution& run) {
  return wall_putter(mesh, wall_at, run).put();
}

expected<walls_report> put_on_walls_of_base(mesh_builder& mesh,
                                            const std::function<bool(surface_id)>& has_moved,
                                            const execution& run) {
  std::map<surface_id, std::optional<exact_wall>> known;
  const auto wall_at = [&](surface_id id, vec3) -> const exact_wall* {
    if (has_moved(id))
      return nullptr;
    const auto [row, fresh] = known.try_emplace(id);
    if (fresh)
      row->second = fit_exact(*mesh.base(), facets_of(*mesh.base(), std::array{id}));
    return row->second ? &*row->second : nullptr;
  };
  return put_on_walls(mesh, wall_at, run);
}

}  // namespace tedit
