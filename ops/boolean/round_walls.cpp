// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/round_walls.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

namespace tedit::ops {

namespace {

/// A tool has at least 16 edges a turn where it is meant to be round, and its corners are on the
/// wall to rounding, as a share of the radius: those of a file are not.
constexpr double widest_tool_gap = 25 * std::numbers::pi / 180;
constexpr double exact_corner = 1e-10;

bool is_meant_round(const exact_wall& wall, const facet_corners& corners, bool is_part) {
  if (is_part)
    return has_round_corners(wall, corners.points);
  const bool exact = std::ranges::all_of(corners.points, [&](vec3 p) {
    return std::abs(wall.distance(p)) <= exact_corner * wall.radius_at(p);
  });
  return exact &&
         (wall.sphere_radius > 0 || gaps_around(wall.shape, corners.points)[1] <= widest_tool_gap);
}

}  // namespace

const exact_wall* round_walls::wall::nearest(vec3 p) const {
  const auto found = std::ranges::min_element(
    round, {}, [&](const exact_wall& one) { return std::abs(one.distance(p)); });
  return found == round.end() ? nullptr : &*found;
}

const round_walls::wall& round_walls::behind(const surface_labels& labels, std::int32_t label) {
  if (label == surface_labels::shell)
    return unknown_;
  if (labels.is_tool(label))
    return of_tool(labels.tool_face(label));
  const auto& row = labels.part[static_cast<std::size_t>(label)];
  return row.between || !row.id ? unknown_ : of_part(*row.id);
}

bool round_walls::are_known(const std::vector<facet_id>& facets) {
  std::set<surface_id> ids;
  for (const auto f : facets)
    ids.insert(part_.facet(f).surface);
  // Where there is no CAD model nothing needs to be fitted for that.
  return has_geometries(part_) && std::ranges::all_of(ids, [&](surface_id id) {
           return std::ranges::all_of(of_part(id).round, &exact_wall::is_known);
         });
}

std::vector<surface_geometry> round_walls::tool_geometries() {
  std::vector<surface_geometry> result;
  for (std::size_t face = 0; face < tool_.names.size(); ++face) {
    result.push_back(tool_.geometry(face));
    if (const auto& round = of_tool(face).round;
        round.size() == 1 && result.back().type == surface_geometry::kind::none)
      result.back() = geometry_of(round.front());
  }
  return result;
}

bool round_walls::has_chord(surface_id id, const std::array<vec3, 3>& facet, const box& near,
                            double most_off) {
  const auto& wall = of_part(id);
  for (int k = 0; k < 3; ++k) {
    const std::array edge{facet[k], facet[(k + 1) % 3]};
    const vec3 middle = 0.5 * (edge[0] + edge[1]);
    if (const auto* round = wall.nearest(middle);
        round && std::abs(round->distance(middle)) > most_off && near.meets(box_of(edge)))
      return true;
  }
  return false;
}

const round_walls::wall& round_walls::of_part(surface_id id) {
  const auto [row, fresh] = part_walls_.try_emplace(id);
  if (fresh) {
    const auto facets = facets_of(part_, std::array{id});
    const auto corners = corners_of(part_, facets);
    add(row->second, corners, known_wall(part_, facets, corners), true);
    // Beside walls that a CAD model has, others keep their facets: a guess would bind these, too.
    if (row->second.free_form && !has_geometries(part_))
      if (auto fitted = fit_free_form(corners, near_)) {
        row->second.free_form = false;
        row->second.round.push_back(std::move(*fitted));
      }
    for (std::size_t face = 0; face < continues_.size(); ++face)
      if (continues_[face] == id) {
        const auto& own = of_tool(face);
        row->second.round.insert(row->second.round.end(), own.round.begin(), own.round.end());
        row->second.free_form |= own.free_form;
      }
  }
  return row->second;
}

const round_walls::wall& round_walls::of_tool(std::size_t face) {
  const auto [row, fresh] = tool_walls_.try_emplace(face);
  if (fresh) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::size_t i = 0; i < tool_.triangles.size(); ++i)
      if (tool_.faces[i] == face)
        triangles.push_back(tool_.triangles[i]);
    const auto corners = with_own_points(tool_.points, triangles);
    const auto known = known_wall(tool_.geometry(face), corners);
    // What continues a wall has the facets that the part has of it, and so has a copy.
    add(row->second, corners, known, known || (face < continues_.size() && continues_[face]));
  }
  return row->second;
}

void round_walls::add(wall& to, const facet_corners& corners,
                      const std::optional<exact_wall>& known, bool is_part) {
  if (corners.triangles.empty())
    return;
  const auto shape = known ? known : fit_exact(corners);
  if (!shape)
    to.free_form = true;
  else if (shape->flat() && is_part)
    to.plane = shape->shape;
  else if (!shape->flat() && is_meant_round(*shape, corners, is_part))
    to.round.push_back(*shape);
}

bool give_slack(labelled_surface& surface, const cavity& hollow, const corefined& cut,
                const tool_surface& tool, round_walls& walls) {
  bool any = false;
  for (std::size_t i = 0; i < cut.triangles.size(); ++i) {
    auto& face = surface.mesh.faces[i];
    const auto& wall = walls.behind(surface.labels, face.label);
    if (wall.round.empty() || wall.free_form)
      continue;
    const auto parent = static_cast<std::int64_t>(cut.parent[i]);
    const auto& t = parent < 0 ? tool.triangles[-1 - parent] : hollow.surface.triangles[parent];
    const auto& points = parent < 0 ? tool.points : hollow.surface.points;
    for (int k = 0; k < 3; ++k) {
      const vec3 middle = 0.5 * (points[t[k]] + points[t[(k + 1) % 3]]);
      face.slack = std::max(face.slack, std::abs(wall.nearest(middle)->distance(middle)));
    }
    any |= face.slack > 0;
  }
  return any;
}

bool moves_walls(const mesh_version& part, const tool_surface& tool,
                 const std::vector<std::optional<surface_id>>& continues,
                 const std::vector<facet_id>& near) {
  if (std::ranges::none_of(continues, [](const auto& id) { return id.has_value(); }))
    return false;
  const auto less = [](vec3 a, vec3 b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  const std::set<vec3, decltype(less)> points(tool.points.begin(), tool.points.end(), less);
  return std::ranges::any_of(near, [&](facet_id f) {
    return std::ranges::any_of(continues,
                               [&](const auto& id) { return id == part.facet(f).surface; }) &&
           std::ranges::all_of(part.facet(f).v,
                               [&](vertex_id v) { return points.contains(part.position(v)); });
  });
}

}  // namespace tedit::ops
