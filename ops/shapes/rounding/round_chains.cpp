// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/round_chains.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <unordered_map>

#include "mesh/features/known_wall.hpp"
#include "mesh/features/rims.hpp"
#include "mesh/place_text.hpp"

namespace tedit::ops {

namespace {

/// Walls that meet at less than this (rad) are smooth: there is nothing to round.
constexpr double smooth = 5 * std::numbers::pi / 180;

/// A mesh edge between two surfaces, in the direction of the smaller one's facet.
struct seam_edge {
  vertex_id from = no_id;
  vertex_id to = no_id;
  facet_id facet = no_id;
  surface_id a = 0;
  surface_id b = 0;
};

using surface_pair = std::pair<surface_id, surface_id>;

/// Also a cylinder whose corners are too few for `has_round_corners`, as a bore of six facets: who
/// picks its edge has seen that it is round. Nothing for free form.
std::optional<exact_wall> fitted_to(const mesh_version& mesh, std::span<const facet_id> facets) {
  const auto corners = corners_of(mesh, facets);
  if (auto known = known_wall(mesh, facets, corners); known && !known->free_form)
    return known;
  if (const auto coarse = fit_wall(corners.points, corners.triangles))
    return exact_wall{*coarse};
  auto exact = fit_exact(corners);
  return exact && has_round_corners(*exact, corners.points) ? exact : std::nullopt;
}

class chain_finder {
public:
  chain_finder(const mesh_version& mesh, const std::vector<surface_id>& surfaces, double side)
      : mesh_(mesh), picked_(surfaces.begin(), surfaces.end()) {
    plan_.side = side;
    for (facet_id f = 0; f < mesh.facet_slots(); ++f)
      if (mesh.is_live_facet(f))
        facets_[mesh.facet(f).surface].push_back(f);
  }

  expected<round_plan> find() {
    if (auto ok = collect_edges(); !ok)
      return fail(ok.error());
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (is_wanted(edges_[i]) && !used_[i])
        add_chain(i);
    if (plan_.chains.empty())
      return nothing();
    if (auto ok = find_corners(); !ok)
      return fail(ok.error());
    std::set<surface_id> used = picked_;
    for (const auto id : plan_.added)
      used.insert(id);
    plan_.used.assign(used.begin(), used.end());
    return std::move(plan_);
  }

private:
  [[nodiscard]] bool is_wanted(const seam_edge& e) const {
    return picked_.size() == 1 ? picked_.contains(e.a) || picked_.contains(e.b)
                               : picked_.contains(e.a) && picked_.contains(e.b);
  }

  [[nodiscard]] tl::unexpected<error> nothing() const {
    std::string list;
    for (const auto id : picked_)
      list += (list.empty() ? "" : ", ") + std::to_string(id);
    const bool inner = plan_.side > 0;
    return fail(ec::empty_selection,
                std::string(picked_.size() == 1 ? "surface " : "between surfaces ") + list +
                  (picked_.size() == 1 ? " has no " : " there is no ") +
                  (inner ? "concave edge (inner corner)" : "convex edge (outer edge)") +
                  " to be rounded",
                inner ? "Select two walls that meet at an inner corner, or use open for outer edges"
                      : "Select two walls that meet at an outer edge, or use close for inner "
                        "corners");
  }

  /// The shape of a surface, fitted when it is first asked for; null for free form.
  const exact_wall* shape_of(surface_id id) {
    if (const auto found = plan_.shapes.find(id); found != plan_.shapes.end())
      return &found->second;
    if (shapeless_.contains(id))
      return nullptr;
    const auto fitted = fitted_to(mesh_, facets_[id]);
    if (!fitted) {
      shapeless_.insert(id);
      return nullptr;
    }
    return &plan_.shapes.emplace(id, *fitted).first->second;
  }

  [[nodiscard]] static tl::unexpected<error> no_shape(surface_id id) {
    return fail(ec::invalid_argument,
                "surface " + std::to_string(id) +
                  " is neither a plane, a cylinder, a cone, a sphere nor a torus",
                "Select two walls that are; free form cannot be rounded by this version");
  }

  /// The turn of the outward normal over the edge, rad: above 0 at outer edges.
  [[nodiscard]] static double turn(vec3 along, vec3 na, vec3 nb) {
    return std::atan2(dot(along, cross(na, nb)), dot(na, nb));
  }

  [[nodiscard]] double exact_turn(const seam_edge& e) {
    const vec3 from = mesh_.position(e.from);
    const vec3 to = mesh_.position(e.to);
    const auto* a = shape_of(e.a);
    const auto* b = shape_of(e.b);
    return a && b ? turn(normalized(to - from), a->normal(0.5 * (from + to)),
                         b->normal(0.5 * (from + to)))
                  : 0;
  }

  [[nodiscard]] bool is_kind(double turned) const { return -plan_.side * turned > smooth; }

  /// All edges of the kind, by the facets; those that are wanted also by the exact shapes.
  expected<void> collect_edges() {
    for (facet_id f = 0; f < mesh_.facet_slots(); ++f) {
      if (!mesh_.is_live_facet(f))
        continue;
      const auto& facet = mesh_.facet(f);
      for (int i = 0; i < 3; ++i) {
        const auto g = facet_across(mesh_, f, i);
        const seam_edge e{facet.v[i], facet.v[(i + 1) % 3], f, facet.surface,
                          mesh_.facet(g).surface};
        if (e.a >= e.b)
          continue;
        const vec3 along = normalized(mesh_.position(e.to) - mesh_.position(e.from));
        const vec3 nf = normalized(area_vector(mesh_, facet));
        const vec3 ng = normalized(area_vector(mesh_, mesh_.facet(g)));
        if (-plan_.side * turn(along, nf, ng) <= 0)
          continue;
        if (is_wanted(e) && is_kind(turn(along, nf, ng)))
          for (const auto id : {e.a, e.b})
            if (!shape_of(id))
              return no_shape(id);
        add_edge(e);
      }
    }
    used_.assign(edges_.size(), false);
    return {};
  }

  void add_edge(const seam_edge& e) {
    const auto* a = plan_.shapes.contains(e.a) || is_wanted(e) ? shape_of(e.a) : nullptr;
    const auto* b = plan_.shapes.contains(e.b) || is_wanted(e) ? shape_of(e.b) : nullptr;
    if (is_wanted(e) && (!a || !b))
      return;
    if (a && b) {
      if (!is_kind(exact_turn(e)))
        return;
    }
    from_[e.from].push_back(edges_.size());
    to_[e.to].push_back(edges_.size());
    edges_.push_back(e);
  }

  /// The one edge of the same pair that goes on at a vertex around which no third surface lies.
  [[nodiscard]] std::size_t next_edge(const seam_edge& e, vertex_id v, bool forward) const {
    if (fan_at(mesh_, e.facet, v).sectors.size() != 2)
      return edges_.size();
    const auto& table = forward ? from_ : to_;
    const auto found = table.find(v);
    if (found != table.end())
      for (const auto i : found->second)
        if (edges_[i].a == e.a && edges_[i].b == e.b)
          return i;
    return edges_.size();
  }

  void add_chain(std::size_t first) {
    round_chain chain;
    chain.a = edges_[first].a;
    chain.b = edges_[first].b;
    std::vector<std::size_t> run{first};
    used_[first] = true;
    for (auto i = next_edge(edges_[first], edges_[first].to, true); i < edges_.size();
         i = next_edge(edges_[i], edges_[i].to, true)) {
      if (i == first) {
        chain.closed = true;
        break;
      }
      used_[i] = true;
      run.push_back(i);
    }
    if (!chain.closed)
      for (auto i = next_edge(edges_[first], edges_[first].from, false); i < edges_.size();
           i = next_edge(edges_[i], edges_[i].from, false)) {
        used_[i] = true;
        run.insert(run.begin(), i);
      }
    for (const auto i : run) {
      chain.path.push_back(edges_[i].from);
      chain.mean_edge += norm(mesh_.position(edges_[i].to) - mesh_.position(edges_[i].from)) /
                         static_cast<double>(run.size());
    }
    if (!chain.closed)
      chain.path.push_back(edges_[run.back()].to);
    end_facets_.push_back({edges_[run.front()].facet, edges_[run.back()].facet});
    plan_.chains.push_back(std::move(chain));
  }

  [[nodiscard]] vertex_id end_vertex(const chain_end& e) const {
    const auto& path = plan_.chains[e.chain].path;
    return e.last ? path.back() : path.front();
  }

  /// Chains found on the way, as smooth continuations, come last in the list: it grows.
  expected<void> find_corners() {
    std::map<vertex_id, std::size_t> at;
    for (std::size_t c = 0; c < plan_.chains.size(); ++c) {
      if (plan_.chains[c].closed)
        continue;
      for (const bool last : {false, true}) {
        const chain_end end{c, last};
        const auto v = end_vertex(end);
        const auto [row, fresh] = at.try_emplace(v, plan_.corners.size());
        if (fresh) {
          plan_.corners.push_back({{}, v, fan_at(mesh_, end_facets_[c][last], v), {}});
          if (auto ok = follow(c, plan_.corners.back().fan, v); !ok)
            return ok;
        }
        plan_.corners[row->second].ends.push_back(end);
      }
    }
    for (auto& corner : plan_.corners)
      if (auto ok = classify(corner); !ok)
        return ok;
    return {};
  }

  [[nodiscard]] static surface_id third(const surface_fan& fan, const round_chain& chain) {
    for (const auto s : fan.sectors)
      if (s != chain.a && s != chain.b)
        return s;
    return chain.a;
  }

  /// Takes up the chain that goes on smoothly at the end of another one.
  expected<void> follow(std::size_t c, const surface_fan& fan, vertex_id v) {
    if (fan.sectors.size() != 3)
      return {};
    const auto chain = plan_.chains[c];
    const auto other = third(fan, chain);
    const vec3 p = mesh_.position(v);
    for (const auto stays : {chain.a, chain.b}) {
      const auto ends = stays == chain.a ? chain.b : chain.a;
      const auto* tangent = shape_of(other);
      if (!tangent || !is_smooth(tangent->normal(p), plan_.shapes.at(ends).normal(p)))
        continue;
      const surface_pair pair = std::minmax(stays, other);
      for (std::size_t i = 0; i < edges_.size(); ++i)
        if (!used_[i] && edges_[i].a == pair.first && edges_[i].b == pair.second &&
            (edges_[i].from == v || edges_[i].to == v) && is_kind(exact_turn(edges_[i]))) {
          add_chain(i);
          if (!picked_.contains(other) && !std::ranges::count(plan_.added, other))
            plan_.added.push_back(other);
        }
    }
    return {};
  }

  [[nodiscard]] static bool is_smooth(vec3 n1, vec3 n2) {
    return std::atan2(norm(cross(n1, n2)), dot(n1, n2)) <= smooth;
  }

  expected<void> classify(round_corner& corner) {
    const auto& fan = corner.fan;
    const vec3 p = mesh_.position(corner.at);
    const auto& chain = plan_.chains[corner.ends.front().chain];
    const std::set<surface_id> distinct(fan.sectors.begin(), fan.sectors.end());
    if (fan.sectors.size() != 3 || distinct.size() != 3)
      return fail(ec::invalid_argument,
                  chain.name(mesh_) + " ends where " + std::to_string(fan.sectors.size()) +
                    " surfaces meet at " + place_text(p) +
                    (fan.sectors.size() == 2 ? ": it runs out there"
                                             : "; only corners of three can be rounded"),
                  "Select other edges");
    for (const auto s : fan.sectors)
      if (!shape_of(s))
        return no_shape(s);
    if (corner.ends.size() == 1) {
      corner.type = round_corner::kind::wall;
      const vec3 n = plan_.shapes.at(third(fan, chain)).normal(p);
      for (const auto s : {chain.a, chain.b})
        if (is_smooth(n, plan_.shapes.at(s).normal(p)))
          return fail(ec::invalid_argument,
                      chain.name(mesh_) + " runs out at " + place_text(p) + ", where surface " +
                        std::to_string(third(fan, chain)) + " goes on smoothly",
                      "Select other edges");
    } else if (corner.ends.size() == 2) {
      std::vector<surface_id> outer;
      for (const auto& e : corner.ends)
        for (const auto s : {plan_.chains[e.chain].a, plan_.chains[e.chain].b})
          if (const auto& o = plan_.chains[corner.ends[&e == &corner.ends[0]].chain];
              s != o.a && s != o.b)
            outer.push_back(s);
      corner.type = outer.size() == 2 && is_smooth(plan_.shapes.at(outer[0]).normal(p),
                                                   plan_.shapes.at(outer[1]).normal(p))
                      ? round_corner::kind::smooth
                      : round_corner::kind::mitre;
    } else {
      corner.type = round_corner::kind::ball;
    }
    return {};
  }

  const mesh_version& mesh_;
  std::set<surface_id> picked_;
  round_plan plan_;
  std::map<surface_id, std::vector<facet_id>> facets_;
  std::set<surface_id> shapeless_;
  std::vector<seam_edge> edges_;
  std::vector<bool> used_;
  std::unordered_map<vertex_id, std::vector<std::size_t>> from_, to_;
  std::vector<std::array<facet_id, 2>> end_facets_;
};

}  // namespace

std::string round_chain::name(const mesh_version& mesh) const {
  return "the edge between surfaces " + std::to_string(a) + " and " + std::to_string(b) + " at " +
         place_text(mesh.position(path[path.size() / 2]));
}

bool surface_fan::has(surface_id s) const {
  return std::ranges::count(sectors, s) > 0;
}

surface_fan fan_at(const mesh_version& mesh, facet_id f, vertex_id v) {
  surface_fan fan;
  std::vector<std::pair<surface_id, vertex_id>>
    turns;  // A facet's surface, and the edge it leaves by.
  auto g = f;
  do {
    const auto& c = mesh.facet(g).v;
    const int i = static_cast<int>(std::ranges::find(c, v) - c.begin());
    turns.emplace_back(mesh.facet(g).surface, c[(i + 1) % 3]);
    g = facet_across(mesh, g, i);
  } while (g != f);
  for (std::size_t i = 0; i < turns.size(); ++i)
    if (turns[i].first != turns[(i + 1) % turns.size()].first) {
      fan.sectors.push_back(turns[i].first);
      fan.rays.push_back(turns[i].second);
    }
  if (fan.sectors.empty())
    fan.sectors.push_back(turns.front().first);
  return fan;
}

expected<round_plan> find_chains(const mesh_version& mesh, const std::vector<surface_id>& surfaces,
                                 double side) {
  return chain_finder(mesh, surfaces, side).find();
}

}  // namespace tedit::ops
