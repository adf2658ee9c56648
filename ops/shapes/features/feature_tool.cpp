// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/features/feature_tool.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "mesh/features/hole.hpp"
#include "mesh/features/known_wall.hpp"
#include "mesh/features/lid_way.hpp"
#include "mesh/features/select.hpp"
#include "ops/shapes/caps/caps.hpp"
#include "ops/tools/local_size.hpp"

namespace tedit::ops {

namespace {

/// The hole, else the boss, that one surface belongs to.
expected<found_feature> feature_of(const mesh_version& mesh, surface_id pick,
                                   const execution& run) {
  auto hole = select_surfaces(mesh, {.kind = feature_kind::hole, .surfaces = {pick}}, run);
  if (hole)
    return std::move(hole->front());
  if (hole.error().code == ec::cancelled || hole.error().code == ec::surface_not_found)
    return fail(hole.error());
  auto boss = select_surfaces(mesh, {.kind = feature_kind::protrusion, .surfaces = {pick}}, run);
  if (boss)
    return std::move(boss->front());
  if (boss.error().code == ec::cancelled)
    return fail(boss.error());
  return fail(ec::not_a_protrusion,
              "surface " + std::to_string(pick) + " belongs neither to a hole nor to a boss",
              "Pick a wall of a hole, or a side of a boss that stands free");
}

surface_geometry brought(surface_geometry geometry, const motion& way) {
  geometry.point = way(geometry.point);
  geometry.axis = way.turned(geometry.axis);
  if (geometry.spline) {
    auto spline = *geometry.spline;
    for (auto& pole : spline.poles)
      pole = way(pole);
    geometry.spline = std::make_shared<const spline_surface>(std::move(spline));
  }
  return geometry;
}

/// Lids whose triangles hang together: over an edge of the part a rim has one for each side.
std::vector<lid> lids_of(const tool_surface& tool, std::size_t first_triangle) {
  std::vector<std::uint32_t> root(tool.points.size());
  std::iota(root.begin(), root.end(), 0U);
  const auto find = [&](std::uint32_t p) {
    while (root[p] != p)
      p = root[p] = root[root[p]];
    return p;
  };
  for (std::size_t i = first_triangle; i < tool.triangles.size(); ++i)
    for (int k = 1; k < 3; ++k)
      root[find(tool.triangles[i][k])] = find(tool.triangles[i][0]);
  std::map<std::uint32_t, lid> by_root;
  std::map<std::uint32_t, std::set<std::array<std::uint32_t, 2>>> edges;
  for (std::size_t i = first_triangle; i < tool.triangles.size(); ++i) {
    const auto& t = tool.triangles[i];
    const auto of = find(t[0]);
    auto& one = by_root[of];
    one.normal += area_vector(tool.points[t[0]], tool.points[t[1]], tool.points[t[2]]);
    for (int k = 0; k < 3; ++k) {
      one.points.push_back(t[k]);
      if (edges[of].erase({t[(k + 1) % 3], t[k]}) == 0)
        edges[of].insert({t[k], t[(k + 1) % 3]});
    }
  }
  std::vector<lid> result;
  for (auto& [of, one] : by_root) {
    std::ranges::sort(one.points);
    one.points.erase(std::ranges::unique(one.points).begin(), one.points.end());
    one.rim.assign(edges[of].begin(), edges[of].end());
    one.normal = normalized(one.normal);
    result.push_back(std::move(one));
  }
  return result;
}

/// Which face the walls' triangles have at their edges, as these have them.
std::map<std::array<std::uint32_t, 2>, std::uint32_t> wall_edges(const tool_surface& tool) {
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> result;
  const auto lid_face = static_cast<std::uint32_t>(tool.names.size() - 1);
  for (std::size_t i = 0; i < tool.triangles.size(); ++i)
    if (tool.faces[i] != lid_face)
      for (int k = 0; k < 3; ++k)
        result[{tool.triangles[i][k], tool.triangles[i][(k + 1) % 3]}] = tool.faces[i];
  return result;
}

/// Is a wall the same shape past a lid, straight on that way? What is of no known shape may be.
bool runs_on(const surface_geometry& wall, vec3 way) {
  constexpr double askew = 1e-4;
  using kind = surface_geometry::kind;
  if (wall.type == kind::plane)
    return std::abs(dot(wall.axis, way)) < askew;
  if (wall.type == kind::cylinder)
    return norm(cross(wall.axis, way)) < askew;
  return wall.type == kind::none;
}

/// `shapes`: what the faces stand for.
void find_ways(feature_tool& feature, const std::vector<surface_geometry>& shapes) {
  const auto walls = wall_edges(feature.tool);
  for (auto& lid : feature.lids) {
    std::set<std::uint32_t> faces;
    for (const auto& edge : lid.rim)
      faces.insert(walls.at({edge[1], edge[0]}));
    std::vector<surface_geometry> around;
    for (const auto face : faces)
      around.push_back(shapes[face]);
    std::vector<std::array<vec3, 2>> rim;
    for (const auto& edge : lid.rim)
      rim.push_back({feature.tool.points[edge[0]], feature.tool.points[edge[1]]});
    lid.way = way_past_lid(around, lid.normal, rim);
    for (const auto& edge : lid.rim)
      lid.runs_on.push_back(runs_on(shapes[walls.at({edge[1], edge[0]})], lid.way));
  }
}

/// What goes on straight from the mouth of a cone is a cylinder; none where it is something else,
/// or several.
surface_geometry straight_on(const feature_tool& feature,
                             const std::vector<surface_geometry>& shapes) {
  constexpr double alike = 1e-5;
  using kind = surface_geometry::kind;
  const auto walls = wall_edges(feature.tool);
  surface_geometry result;
  for (const auto& lid : feature.lids)
    for (std::size_t i = 0; i < lid.rim.size(); ++i) {
      if (lid.runs_on[i])
        continue;
      const auto& cone = shapes[walls.at({lid.rim[i][1], lid.rim[i][0]})];
      if (cone.type != kind::cone || norm(cross(cone.axis, lid.way)) > alike)
        return {};
      const vec3 from_axis = cross(feature.tool.points[lid.rim[i][0]] - cone.point, cone.axis);
      if (result.type == kind::none)
        result = {kind::cylinder, cone.point, cone.axis, norm(from_axis)};
      if (std::abs(norm(from_axis) - result.radius) > alike * result.radius ||
          norm(cross(cone.point - result.point, result.axis)) > alike * result.radius)
        return {};
    }
  return result;
}

/// Where walls are something else past a lid, what goes on straight there is a face of its own: the
/// last but one.
void add_face_past_lids(feature_tool& feature, std::vector<surface_geometry>& shapes) {
  if (std::ranges::all_of(feature.lids, [](const lid& one) {
        return std::ranges::find(one.runs_on, false) == one.runs_on.end();
      }))
    return;
  const auto shape = straight_on(feature, shapes);
  auto& tool = feature.tool;
  const auto lid_face = static_cast<std::uint32_t>(tool.names.size() - 1);
  std::ranges::replace(tool.faces, lid_face, lid_face + 1);
  tool.names.insert(tool.names.end() - 1, "straight on");
  feature.surfaces.insert(feature.surfaces.end() - 1, std::nullopt);
  shapes.insert(shapes.end() - 1, shape);
}

expected<feature_tool> close_feature(const mesh_version& mesh, const shell& part, boolean_mode mode,
                                     services& host) {
  auto plug = close_shell(mesh, part, 1.0, host);
  if (!plug)
    return fail(plug.error());
  feature_tool result;
  result.mode = mode;
  result.tool.points = std::move(plug->surface.points);
  result.tool.triangles = std::move(plug->surface.triangles);
  std::map<surface_id, std::uint32_t> faces;
  std::vector<surface_geometry> shapes;
  for (std::size_t i = 0; i < plug->shell_triangles; ++i) {
    const auto id = mesh.facet(part.facets[i]).surface;
    const auto [found, is_new] = faces.emplace(id, static_cast<std::uint32_t>(faces.size()));
    if (is_new) {
      const auto* row = mesh.find_surface(id);
      result.tool.names.push_back(row && !row->name.empty() ? row->name
                                                            : "copy of " + std::to_string(id));
      result.surfaces.emplace_back(id);
      shapes.push_back(find_geometry(mesh, id));
    }
    result.tool.faces.push_back(found->second);
  }
  result.tool.faces.resize(result.tool.triangles.size(),
                           static_cast<std::uint32_t>(result.tool.names.size()));
  result.tool.names.emplace_back("lid");
  shapes.emplace_back();
  result.surfaces.emplace_back();
  // The plug of a hole looks outward; round a boss everything is the other way round.
  if (mode == boolean_mode::add)
    for (auto& t : result.tool.triangles)
      std::swap(t[1], t[2]);
  result.lids = lids_of(result.tool, plug->shell_triangles);
  find_ways(result, shapes);
  add_face_past_lids(result, shapes);
  if (has_geometries(mesh))
    result.tool.geometries = std::move(shapes);
  return result;
}

std::vector<std::vector<lid_hit>> rays_from(const mesh_version& mesh,
                                            const std::vector<vec3>& points, vec3 way) {
  std::vector<std::vector<lid_hit>> rays;
  for (const auto& p : points) {
    auto& ray = rays.emplace_back();
    for (const auto& hit : ray_hits(mesh, p, way))
      ray.push_back({hit.distance, hit.leaves});
  }
  return rays;
}

/// How far from the points the material begins along `in`, at most, m; points with none within
/// `reach` are passed over.
double way_in(const mesh_version& mesh, const std::vector<vec3>& points, vec3 in, double reach,
              double size) {
  double most = 0;
  for (const auto& p : points) {
    const auto hits = ray_hits(mesh, p - 0.1 * lid_rules::on_surface * size * in, in);
    if (!hits.empty() && !hits.front().leaves && hits.front().distance < reach)
      most = std::max(most, hits.front().distance);
  }
  return most;
}

/// Of each rim edge so many points, where there are few edges: what covers a bit of the lid is
/// found.
std::size_t points_an_edge(std::size_t edges) {
  return edges <= 16 ? 4 : 1;
}

double layer_on(const mesh_version& mesh, const feature_tool& feature, const tool_surface& tool,
                const lid& one, vec3 way, double size) {
  std::vector<vec3> rim;
  box extent;
  vec3 middle;
  const auto more = points_an_edge(one.rim.size());
  for (const auto& [a, b] : one.rim) {
    for (std::size_t i = 0; i < more; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(more);
      rim.push_back(tool.points[a] + share * (tool.points[b] - tool.points[a]));
    }
    extent.add(tool.points[a]);
    middle += tool.points[a] / static_cast<double>(one.rim.size());
  }
  for (auto& p : rim)
    p += lid_rules::within_rim * (middle - p);
  if (feature.mode == boolean_mode::cut)
    return reach_of_hole(rays_from(mesh, rim, way), size);
  const double gap = way_in(mesh, rim, way, norm(extent.high - extent.low), size);
  return gap > lid_rules::on_surface * size ? gap + lid_rules::into_part * size : 0;
}

/// Lifts the lid by `step`. Walls go on up to it, where they are the same there.
void raise(tool_surface& tool, const lid& one, vec3 step, bool mirrored) {
  const auto walls = wall_edges(tool);
  std::map<std::uint32_t, std::uint32_t> raised;
  const auto lid_face = static_cast<std::uint32_t>(tool.names.size() - 1);
  for (const auto v : one.points) {
    raised[v] = static_cast<std::uint32_t>(tool.points.size());
    tool.points.push_back(tool.points[v] + step);
  }
  const std::set<std::uint32_t> own(one.points.begin(), one.points.end());
  for (std::size_t i = 0; i < tool.triangles.size(); ++i)
    if (tool.faces[i] == lid_face && own.contains(tool.triangles[i][0]))
      for (auto& v : tool.triangles[i])
        v = raised.at(v);
  for (std::size_t i = 0; i < one.rim.size(); ++i) {
    auto [a, b] = one.rim[i];
    if (mirrored)
      std::swap(a, b);
    tool.triangles.push_back({a, b, raised.at(b)});
    tool.triangles.push_back({a, raised.at(b), raised.at(a)});
    tool.faces.insert(tool.faces.end(), 2, one.runs_on[i] ? walls.at({b, a}) : lid_face - 1);
  }
}

}  // namespace

expected<picked_features> pick_features(const mesh_version& mesh,
                                        const std::vector<surface_id>& picked, context& ctx) {
  picked_features result;
  std::set<surface_id> all;
  std::optional<boolean_mode> mode;
  for (const auto pick : picked) {
    if (all.contains(pick))
      continue;
    const auto found = feature_of(mesh, pick, ctx.run);
    if (!found)
      return fail(found.error());
    const auto is = found->kind == feature_kind::hole ? boolean_mode::cut : boolean_mode::add;
    if (mode.value_or(is) != is)
      return fail(ec::invalid_argument, "holes and bosses are selected together",
                  "Take one kind at a time");
    mode = is;
    all.insert(found->surfaces.begin(), found->surfaces.end());
  }
  result.mode = mode.value_or(boolean_mode::cut);
  result.surfaces.assign(all.begin(), all.end());
  for (const auto& part : find_shells(mesh, facets_of(mesh, result.surfaces))) {
    auto tool = close_feature(mesh, part, result.mode, *ctx.host);
    if (!tool)
      return fail(tool.error());
    result.tools.push_back(std::move(*tool));
  }
  return result;
}

tool_surface placed(const mesh_version& mesh, const feature_tool& feature, const motion& way,
                    double size) {
  tool_surface tool = feature.tool;
  for (auto& p : tool.points)
    p = way(p);
  for (auto& geometry : tool.geometries)
    geometry = brought(geometry, way);
  if (way.mirrors)
    for (auto& t : tool.triangles)
      std::swap(t[1], t[2]);
  std::vector<double> layers;
  for (const auto& one : feature.lids)
    layers.push_back(layer_on(mesh, feature, tool, one, way.turned(one.way), size));
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (layers[i] > 0)
      raise(tool, feature.lids[i], layers[i] * way.turned(feature.lids[i].way), way.mirrors);
  return tool;
}

}  // namespace tedit::ops
