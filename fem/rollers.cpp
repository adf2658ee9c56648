// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/rollers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.hpp"
#include "fem/node_table.hpp"
#include "fem/polled.hpp"
#include "mesh/facet_pages.hpp"
#include "mesh/features/wall_shape.hpp"

namespace tedit::fem {

namespace {

/// Normals of two surfaces at a node are one direction up to this angle, or up to a little more
/// than what the facets of both turn by: six facets around a hole have 60 degrees where its halves
/// meet.
constexpr double same_direction = 20 * degree;
constexpr double most_at_a_seam = 70 * degree;
/// Of the angle between facets and the normal in their midst, the share by which that normal may be
/// off in the mean; 0.15 on coarse bores that are meshed without a pattern. At a rim there are
/// facets on one side only.
constexpr double uncertain_share = 0.2;
constexpr double uncertain_share_at_rim = 1;
constexpr double flat = 1e-4;  ///< Facets that turn by less, rad, are one plane.
/// Vertices lie on a shape within this share of its radius. A flat piece of surface has a radius of
/// up to 100 times its size: then its normals are known within `fitted_uncertainty`, a sine.
constexpr double roundness = 1e-6;
constexpr double fitted_uncertainty = 1e-3;

using triangle = surface_triangles::triangle;

/// What a surface says of one of its nodes.
struct node_normal {
  std::uint32_t node = 0;
  std::uint32_t surface = 0;  ///< Index into the surfaces.
  vec3 normal;                ///< As long as it weighs.
  double area = 0;
  bool at_rim = false;  ///< Of a surface whose shape is not known.
};

/// What is known of a surface as a whole.
struct surface_kind {
  bool fitted = false;  ///< A cylinder or a cone.
  double turning = 0;   ///< The largest angle between a facet and the normal at a node, rad.

  /// Of a normal, sine.
  [[nodiscard]] double uncertainty(bool at_rim) const {
    if (fitted)
      return fitted_uncertainty;
    if (turning <= flat)
      return 0;
    return std::sin(turning) * (at_rim ? uncertain_share_at_rim : uncertain_share);
  }
};

/// A direction whose bits stay when an edit changes some facets of the surface that it came from:
/// else all nodes there would count as changed.
vec3 without_noise(vec3 d) {
  constexpr double unit = 0x1p40;
  return {std::round(d.x * unit) / unit, std::round(d.y * unit) / unit,
          std::round(d.z * unit) / unit};
}

double angle_between(vec3 a, vec3 b) {
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

/// What the normal of a triangle weighs at its node i. At corners Max's weights. In the middle of
/// an edge: on a circle the normal between two chords is the sum of theirs, each over its length,
/// and a chord is as long as the triangle is high over the edge that stands between both.
double weight_of(const problem& p, const triangle& t, int i, vec3 area) {
  if (i >= 3)
    return 1 / dot(area, area);
  const vec3 a = p.nodes[t.nodes[(i + 1) % 3]] - p.nodes[t.nodes[i]];
  const vec3 b = p.nodes[t.nodes[(i + 2) % 3]] - p.nodes[t.nodes[i]];
  return 1 / (dot(a, a) * dot(b, b));
}

/// Marks the nodes on edges that only one of the triangles has.
void mark_rims(const std::vector<triangle>& list, node_table<node_normal>& at) {
  struct edge {
    std::array<std::uint32_t, 2> ends;
    std::uint32_t middle;
  };
  std::vector<edge> edges;
  for (const auto& t : list)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(t.nodes[i], t.nodes[(i + 1) % 3]);
      edges.push_back({{low, high}, t.nodes[t.count == 6 ? 3 + i : i]});
    }
  polled_sort(edges, [](const edge& a, const edge& b) { return a.ends < b.ends; });
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool again = (i > 0 && edges[i - 1].ends == edges[i].ends) ||
                       (i + 1 < edges.size() && edges[i + 1].ends == edges[i].ends);
    if (again)
      continue;
    for (const auto node : {edges[i].ends[0], edges[i].ends[1], edges[i].middle})
      at[node].at_rim = true;
  }
}

/// The cylinder or cone that a surface is; nothing for planes, too, whose facets say enough.
std::optional<wall_shape> round_shape(const mesh_version& mesh, surface_id id) {
  const auto facets = facets_of(mesh, std::span(&id, 1));
  if (facets.empty())
    return std::nullopt;
  auto shape = fit_wall(mesh, facets, {.roundness = roundness, .wide_facets = true, .cones = true});
  return shape && shape->type != wall_shape::kind::plane ? shape : std::nullopt;
}

/// Appends a surface's normals at its nodes.
surface_kind add_normals(const mesh_version& mesh, const problem& p,
                         const std::vector<triangle>& list, surface_id id, std::uint32_t surface,
                         std::vector<node_normal>& all) {
  node_table<node_normal> at(p);
  const auto add = [&](std::size_t i) {
    const vec3 area = area_of(p, list[i]);
    for (int k = 0; k < list[i].count; ++k) {
      auto& row = at[list[i].nodes[k]];
      row.area += norm(area);
      if (const double w = weight_of(p, list[i], k, area); std::isfinite(w))
        row.normal += w * area;
    }
  };
  polled_for(list.size(), add, triangles_between);
  surface_kind kind;
  const auto turn = [&](std::size_t i) {
    for (const auto node : list[i].all())
      kind.turning = std::max(kind.turning, angle_between(area_of(p, list[i]), at[node].normal));
  };
  polled_for(list.size(), turn, triangles_between);
  const auto shape = kind.turning > flat ? round_shape(mesh, id) : std::nullopt;
  if (shape)
    kind = {true, 0};
  else if (kind.turning > flat)
    mark_rims(list, at);
  for (auto [node, row] : at.rows()) {
    row.node = node;
    row.surface = surface;
    if (shape)
      row.normal = shape->normal(p.nodes[node]);
    all.push_back(row);
  }
  return kind;
}

/// The directions of one node: surfaces whose normals are alike there make one.
class direction_groups {
public:
  void add(const node_normal& row, surface_id surface, const surface_kind& kind) {
    auto* alike = find(row.normal, kind);
    if (!alike) {
      groups_.push_back({row.normal, kind, row.at_rim, {{surface, row.area}}});
      return;
    }
    alike->shares.push_back({surface, row.area});
    // Two surfaces that continue each other have facets on both sides.
    alike->at_rim = false;
    alike->kind.turning = std::max(alike->kind.turning, kind.turning);
    // The normal of a shape is better than any mean.
    if (alike->kind.fitted)
      return;
    alike->normal = kind.fitted ? row.normal : alike->normal + row.normal;
    alike->kind.fitted = kind.fitted;
  }

  void finish(std::uint32_t node, std::vector<roller_direction>& result) {
    for (auto& g : groups_)
      if (norm(g.normal) > 0)
        result.push_back({node, without_noise(normalized(g.normal)), g.kind.uncertainty(g.at_rim),
                          std::move(g.shares)});
    groups_.clear();
  }

private:
  struct group {
    vec3 normal;
    surface_kind kind;
    bool at_rim = false;
    std::vector<roller_direction::share> shares;
  };

  group* find(vec3 normal, const surface_kind& kind) {
    for (auto& g : groups_) {
      const double seam = std::min(1.3 * (g.kind.turning + kind.turning), most_at_a_seam);
      if (angle_between(g.normal, normal) <= std::max(same_direction, seam))
        return &g;
    }
    return nullptr;
  }

  std::vector<group> groups_;
};

}  // namespace

std::vector<roller_direction> roller_directions(const mesh_version& mesh, const problem& p,
                                                const surface_triangles& triangles,
                                                std::span<const surface_id> surfaces) {
  std::vector<node_normal> rows;
  std::vector<surface_kind> kinds;
  for (std::uint32_t s = 0; s < surfaces.size(); ++s)
    kinds.push_back(add_normals(mesh, p, triangles.of(surfaces[s]), surfaces[s], s, rows));
  polled_sort(rows, [](const node_normal& a, const node_normal& b) {
    return std::pair(a.node, a.surface) < std::pair(b.node, b.surface);
  });
  std::vector<roller_direction> result;
  direction_groups groups;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    groups.add(rows[i], surfaces[rows[i].surface], kinds[rows[i].surface]);
    if (i + 1 == rows.size() || rows[i + 1].node != rows[i].node)
      groups.finish(rows[i].node, result);
  }
  return result;
}

}  // namespace tedit::fem
