// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/deform/deform_zone.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "mesh/facet_distance.hpp"
#include "mesh/facet_pages.hpp"
#include "mesh/features/wall_shape.hpp"

namespace tedit::ops {

namespace {

/// Sum of the area vectors by the sum of the areas: of a cylinder's wall that goes round by 140
/// degrees or more it is less. Bores, in one piece or two halves, go round; fillets do not.
constexpr double goes_round = 0.75;

/// Neighbours that are nowhere further off than this share of the reach are edges of what is
/// dragged, like chamfers: what lies behind them is a neighbour, too.
constexpr double edge_share = 0.25;

/// Cosine between the normals of what is dragged and of a flat wall: below, it is the other side of
/// a plate, and no neighbour by way of roundings.
constexpr double opposite = -0.87;

enum class wall_kind { free_form, flat, round };

wall_kind kind_of(const mesh_version& mesh, surface_id id) {
  const auto facets = facets_of(mesh, std::array{id});
  const auto shape = fit_wall(mesh, facets, {1e-3, true, true});
  if (!shape)
    return wall_kind::free_form;
  if (shape->type == wall_shape::kind::plane)
    return wall_kind::flat;
  vec3 sum;
  double area = 0;
  for (const auto f : facets) {
    const vec3 a = area_vector(mesh, mesh.facet(f));
    sum += a;
    area += norm(a);
  }
  return norm(sum) < goes_round * area ? wall_kind::round : wall_kind::free_form;
}

/// Which surfaces there are within reach, and which of them touch.
struct near_surfaces {
  std::map<surface_id, std::set<vertex_id>> vertices;  ///< Those within the box of the reach.
  std::map<vertex_id, std::set<surface_id>> at;

  near_surfaces(const mesh_version& mesh, const box& within) {
    for_each_facet_near(mesh, within, [&](facet_id f) {
      const auto& facet = mesh.facet(f);
      for (const auto v : facet.v) {
        vertices[facet.surface].insert(v);
        at[v].insert(facet.surface);
      }
    });
  }
};

class zone_finder {
public:
  zone_finder(const mesh_version& mesh, const drag_handle& handle, const zone_settings& settings)
      : mesh_(mesh),
        handle_(handle),
        settings_(settings),
        distance_of_(triangles()),
        near_(mesh, distance_of_.extent().grown(settings.reach)),
        state_(mesh.vertex_slots(), apart) {}

  expected<deform_zone> find(const execution& run) {
    if (auto ok = check_stay(); !ok)
      return fail(ok.error());
    deform_zone result;
    result.kept = kept_surfaces();
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the edit was cancelled");
    mark(result.kept);
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the edit was cancelled");
    keep_what_hangs_together();
    for (vertex_id v = 0; v < mesh_.vertex_slots(); ++v)
      if (state_[v] == free)
        result.free.push_back(v);
    for (tet_id t = 0; t < mesh_.tet_slots(); ++t)
      if (mesh_.is_live_tet(t) &&
          std::ranges::any_of(mesh_.tet_at(t).v, [&](vertex_id v) { return state_[v] != apart; }))
        result.tets.push_back(t);
    return result;
  }

private:
  enum state : std::uint8_t { apart, free, dragged };

  [[nodiscard]] std::vector<std::array<vec3, 3>> triangles() const {
    std::vector<std::array<vec3, 3>> result;
    for (const auto f : handle_.facets) {
      const auto& v = mesh_.facet(f).v;
      result.push_back({mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2])});
    }
    return result;
  }

  [[nodiscard]] std::set<surface_id> touching_handle() const {
    std::set<surface_id> result;
    for (const auto v : handle_.vertices)
      if (const auto here = near_.at.find(v); here != near_.at.end())
        result.insert(here->second.begin(), here->second.end());
    return result;
  }

  [[nodiscard]] expected<void> check_stay() const {
    const auto touching = touching_handle();
    for (const auto id : settings_.stay) {
      if (!mesh_.find_surface(id))
        return fail(ec::surface_not_found,
                    "surface " + std::to_string(id) + ", which is to stay, does not exist",
                    "List the surfaces with tedit info");
      if (touching.contains(id))
        return fail(ec::invalid_parameter,
                    "surface " + std::to_string(id) + " is to stay and touches what is dragged",
                    "Leave it out, or drag something else");
    }
    return {};
  }

  [[nodiscard]] bool is_edge(surface_id id) const {
    return std::ranges::all_of(near_.vertices.at(id), [&](vertex_id v) {
      const double most = edge_share * settings_.reach;
      return distance_of_.is_within(mesh_.position(v), most);
    });
  }

  [[nodiscard]] bool is_other_side(surface_id id) const {
    const auto normal = handle_.normal();
    if (!normal || kind_of(mesh_, id) != wall_kind::flat)
      return false;
    vec3 area;
    for (const auto f : facets_of(mesh_, std::array{id}))
      area += area_vector(mesh_, mesh_.facet(f));
    return dot(normalized(area), *normal) < opposite;
  }

  /// Those that belong to the handle: what hangs together with it over surfaces that bend.
  [[nodiscard]] std::set<surface_id> neighbours() const {
    auto found = touching_handle();
    std::vector<surface_id> queue(found.begin(), found.end());
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const auto id = queue[next];
      if (kind_of(mesh_, id) != wall_kind::free_form && !is_edge(id))
        continue;
      for (const auto v : near_.vertices.at(id))
        for (const auto other : near_.at.at(v))
          if (!found.contains(other) && !is_other_side(other)) {
            found.insert(other);
            queue.push_back(other);
          }
    }
    return found;
  }

  [[nodiscard]] std::vector<surface_id> kept_surfaces() const {
    std::set<surface_id> kept(settings_.stay.begin(), settings_.stay.end());
    if (settings_.kept == kept_walls::none)
      return {kept.begin(), kept.end()};
    const auto own = neighbours();
    for (const auto& [id, vertices] : near_.vertices) {
      if (own.contains(id))
        continue;
      const auto kind = kind_of(mesh_, id);
      if (kind == wall_kind::round ||
          (kind == wall_kind::flat && settings_.kept == kept_walls::flat_and_round))
        kept.insert(id);
    }
    return {kept.begin(), kept.end()};
  }

  void mark(const std::vector<surface_id>& kept) {
    const box within = distance_of_.extent().grown(settings_.reach);
    for (vertex_id v = 0; v < mesh_.vertex_slots(); ++v) {
      if (!mesh_.is_live_vertex(v))
        continue;
      box at;
      at.add(mesh_.position(v));
      if (at.meets(within) && distance_of_.is_within(mesh_.position(v), settings_.reach))
        state_[v] = free;
    }
    for (const auto id : kept)
      if (const auto here = near_.vertices.find(id); here != near_.vertices.end())
        for (const auto v : here->second)
          state_[v] = apart;
    for (const auto v : handle_.vertices)
      state_[v] = dragged;
  }

  /// A part's other arm may be within reach, too: it is left alone.
  void keep_what_hangs_together() {
    std::vector<vertex_id> parent(mesh_.vertex_slots());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](vertex_id v) {
      while (parent[v] != v)
        v = parent[v] = parent[parent[v]];
      return v;
    };
    for (tet_id t = 0; t < mesh_.tet_slots(); ++t) {
      if (!mesh_.is_live_tet(t))
        continue;
      vertex_id first = no_id;
      for (const auto v : mesh_.tet_at(t).v)
        if (state_[v] != apart) {
          first = first == no_id ? v : first;
          const auto a = root(first);
          const auto b = root(v);
          parent[std::max(a, b)] = std::min(a, b);
        }
    }
    std::vector<std::uint8_t> held(mesh_.vertex_slots(), 0);
    for (const auto v : handle_.vertices)
      held[root(v)] = 1;
    for (vertex_id v = 0; v < mesh_.vertex_slots(); ++v)
      if (state_[v] == free && !held[root(v)])
        state_[v] = apart;
  }

  const mesh_version& mesh_;
  const drag_handle& handle_;
  const zone_settings& settings_;
  facet_distance distance_of_;
  near_surfaces near_;
  std::vector<state> state_;
};

}  // namespace

expected<deform_zone> zone_around(const mesh_version& mesh, const drag_handle& handle,
                                  const zone_settings& settings, const execution& run) {
  return zone_finder(mesh, handle, settings).find(run);
}

}  // namespace tedit::ops
