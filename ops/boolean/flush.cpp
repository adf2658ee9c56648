// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/flush.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "mesh/box.hpp"

namespace tedit::ops {

namespace {

struct plane {
  vec3 normal;
  double offset = 0;
};

using edge = std::pair<std::uint32_t, std::uint32_t>;

vec3 normal_of(const tool_surface& tool, std::size_t i) {
  const auto& t = tool.triangles[i];
  return normalized(area_vector(tool.points[t[0]], tool.points[t[1]], tool.points[t[2]]));
}

/// The plane of a face of the tool, where it has one.
std::optional<plane> plane_of(const tool_surface& tool, std::uint32_t face) {
  vec3 sum;
  for (std::size_t i = 0; i < tool.triangles.size(); ++i)
    if (tool.faces[i] == face) {
      const auto& t = tool.triangles[i];
      sum += area_vector(tool.points[t[0]], tool.points[t[1]], tool.points[t[2]]);
    }
  const vec3 normal = normalized(sum);
  box extent;
  double low = 1e300;
  double high = -1e300;
  for (std::size_t i = 0; i < tool.triangles.size(); ++i) {
    if (tool.faces[i] != face)
      continue;
    if (dot(normal_of(tool, i), normal) < 1 - 1e-9)
      return std::nullopt;
    for (const auto v : tool.triangles[i]) {
      extent.add(tool.points[v]);
      low = std::min(low, dot(tool.points[v], normal));
      high = std::max(high, dot(tool.points[v], normal));
    }
  }
  if (!(high - low <= 1e-9 * norm(extent.high - extent.low)))
    return std::nullopt;
  return plane{normal, 0.5 * (low + high)};
}

/// A triangle of the part's boundary, or of an interface between two of its regions.
struct near_triangle {
  std::array<vertex_id, 3> v;
  bool between = false;
};

/// Triangles of the part in that plane near the tool: whether some look the same way or the
/// opposite one, their corners, and the plane of the largest.
struct part_side {
  bool same = false;
  bool opposite = false;
  std::set<vertex_id> corners;
  plane exact;
};

part_side facets_in(const mesh_version& mesh, const std::vector<near_triangle>& near,
                    const plane& at, double tolerance) {
  part_side result;
  double largest = 0;
  for (const auto& triangle : near) {
    const auto& v = triangle.v;
    const bool on = std::ranges::all_of(v, [&](auto corner) {
      return std::abs(dot(mesh.position(corner), at.normal) - at.offset) <= tolerance;
    });
    const vec3 area = area_vector(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]));
    const double along = dot(area, at.normal);
    if (!on || std::abs(along) < 0.99 * norm(area) || norm(area) == 0)
      continue;
    result.same |= along > 0 || triangle.between;
    result.opposite |= along < 0 || triangle.between;
    result.corners.insert(v.begin(), v.end());
    if (norm(area) > largest) {
      largest = norm(area);
      const vec3 normal = normalized(area);
      result.exact = {normal, dot(normal, mesh.position(v[0]))};
    }
  }
  return result;
}

/// Does nothing of the part but facets of the plane itself reach into the layer on a face? By
/// boxes: where in doubt there is something. An interface is nothing: the tool is cut by it anyway.
bool is_clear(const mesh_version& mesh, const std::vector<near_triangle>& near,
              const tool_surface& tool, std::uint32_t face, const plane& at, double tolerance,
              double layer) {
  box extent;
  for (std::size_t i = 0; i < tool.triangles.size(); ++i)
    if (tool.faces[i] == face)
      for (const auto v : tool.triangles[i]) {
        extent.add(tool.points[v]);
        extent.add(tool.points[v] + layer * at.normal);
      }
  return std::ranges::none_of(near, [&](const near_triangle& triangle) {
    const auto& v = triangle.v;
    const std::array p{mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
    double low = 1e300;
    double high = -1e300;
    for (const auto& q : p) {
      low = std::min(low, dot(q, at.normal) - at.offset);
      high = std::max(high, dot(q, at.normal) - at.offset);
    }
    return !triangle.between && high > tolerance && low < layer && extent.meets(box_of(p));
  });
}

/// The face moves out by `step`; what was beside it stays, and a wall closes the gap, in the faces
/// of what was beside.
void add_layer(tool_surface& tool, std::uint32_t face, vec3 step) {
  std::map<edge, std::uint32_t> beside;
  for (std::size_t i = 0; i < tool.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k)
      beside[{tool.triangles[i][k], tool.triangles[i][(k + 1) % 3]}] = tool.faces[i];
  std::map<std::uint32_t, std::uint32_t> raised;
  const auto raise = [&](std::uint32_t v) {
    const auto [row, fresh] = raised.try_emplace(v, static_cast<std::uint32_t>(tool.points.size()));
    if (fresh)
      tool.points.push_back(tool.points[v] + step);
    return row->second;
  };
  const auto count = tool.triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (tool.faces[i] != face)
      continue;
    const auto old = tool.triangles[i];
    for (int k = 0; k < 3; ++k) {
      const auto a = old[k];
      const auto b = old[(k + 1) % 3];
      const auto other = beside.find({b, a});
      if (other == beside.end() || other->second == face)
        continue;
      tool.triangles.push_back({a, b, raise(b)});
      tool.triangles.push_back({a, raise(b), raise(a)});
      tool.faces.insert(tool.faces.end(), 2, other->second);
    }
    tool.triangles[i] = {raise(old[0]), raise(old[1]), raise(old[2])};
  }
}

/// The part's facets near the tool, to find a face of the tool that is made of nothing but them.
class facet_copies {
public:
  facet_copies(const mesh_version& mesh, const std::vector<near_triangle>& near) {
    for (const auto& triangle : near) {
      const auto& v = triangle.v;
      known_.insert(key({mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])}));
    }
  }

  /// Its points are where the part's are: there is nothing to be made flush.
  [[nodiscard]] bool hold_all_of(const tool_surface& tool, std::uint32_t face) const {
    for (std::size_t i = 0; i < tool.triangles.size(); ++i) {
      const auto& t = tool.triangles[i];
      if (tool.faces[i] == face &&
          !known_.contains(key({tool.points[t[0]], tool.points[t[1]], tool.points[t[2]]})))
        return false;
    }
    return true;
  }

private:
  using corner = std::array<double, 3>;
  using triangle = std::array<corner, 3>;

  static triangle key(const std::array<vec3, 3>& p) {
    triangle t;
    for (int i = 0; i < 3; ++i)
      t[i] = {p[i].x, p[i].y, p[i].z};
    std::ranges::sort(t);
    return t;
  }

  std::set<triangle> known_;
};

std::vector<near_triangle> triangles_near(const mesh_version& mesh,
                                          const std::vector<facet_id>& near, const box& extent) {
  std::vector<near_triangle> result;
  const auto add = [&](const std::array<vertex_id, 3>& v, bool between) {
    if (extent.meets(
          box_of(std::array{mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])})))
      result.push_back({v, between});
  };
  for (const auto f : near)
    add(mesh.facet(f).v, false);
  for (std::size_t i = 0; i < mesh.data().interfaces.size(); ++i)
    add(mesh.data().interfaces[i].v, true);
  return result;
}

}  // namespace

flush_tool make_flush(const mesh_version& mesh, const tool_surface& tool, boolean_mode mode,
                      const std::vector<facet_id>& near_facets, double tolerance, double layer) {
  flush_tool result{tool, {}};
  box extent;
  for (const auto& p : tool.points)
    extent.add(p);
  const auto near = triangles_near(mesh, near_facets, extent.grown(tolerance + layer));
  const facet_copies copies(mesh, near);
  for (std::uint32_t face = 0; face < tool.names.size(); ++face) {
    const auto at = plane_of(tool, face);
    if (!at || copies.hold_all_of(tool, face))
      continue;
    const auto side = facets_in(mesh, near, *at, tolerance);
    if (!side.same && !side.opposite)
      continue;
    const bool cut_outside = mode == boolean_mode::cut && !side.opposite;
    const bool stands_on = mode == boolean_mode::add && !side.same;
    const bool keeps_all = mode == boolean_mode::keep && !side.opposite;
    const bool layered = (cut_outside || stands_on || keeps_all) &&
                         is_clear(mesh, near, tool, face, *at, tolerance, layer);
    if (layered)
      add_layer(result.tool, face, layer * at->normal);
    // Where the layer begins, too, points that lie a rounding error apart would stay two.
    flush_face row{side.exact.normal, side.exact.offset, {}, {}};
    row.part.assign(side.corners.begin(), side.corners.end());
    std::set<std::uint32_t> points;
    const auto& now = layered ? tool : result.tool;  // Other layers have made this face larger.
    for (std::size_t i = 0; i < now.triangles.size(); ++i)
      if (now.faces[i] == face)
        for (const auto v : now.triangles[i])
          if (std::abs(dot(now.points[v], at->normal) - at->offset) <= tolerance)
            points.insert(v);
    row.tool.assign(points.begin(), points.end());
    result.faces.push_back(std::move(row));
  }
  return result;
}

std::vector<shared_plane> planes_among(const flush_tool& flush,
                                       const std::vector<vertex_id>& vertices) {
  std::map<vertex_id, std::uint32_t> place;
  for (std::uint32_t i = 0; i < vertices.size(); ++i)
    place[vertices[i]] = i;
  std::vector<shared_plane> result;
  for (const auto& face : flush.faces) {
    shared_plane plane{face.normal, face.offset, {}};
    for (const auto v : face.part)
      if (const auto found = place.find(v); found != place.end())
        plane.points[0].push_back(found->second);
    plane.points[1] = face.tool;
    result.push_back(std::move(plane));
  }
  return result;
}

}  // namespace tedit::ops
