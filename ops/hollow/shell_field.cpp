// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/hollow/shell_field.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace tedit::ops {

namespace {

using kernel = CGAL::Simple_cartesian<double>;
using triangles = std::vector<kernel::Triangle_3>;
using primitive = CGAL::AABB_triangle_primitive<kernel, triangles::const_iterator>;
using tree = CGAL::AABB_tree<CGAL::AABB_traits<kernel, primitive>>;

kernel::Point_3 point(vec3 p) {
  return {p.x, p.y, p.z};
}

vec3 place(const kernel::Point_3& p) {
  return {p.x(), p.y(), p.z()};
}

/// Outward directions at the edges and corners of the boundary by which a nearest point there tells
/// inside from outside: of an edge the sum of both facets' normals, of a corner the sum by the
/// facets' angles. Source: Baerentzen & Aanaes, "Signed distance computation using the angle
/// weighted pseudonormal", 2005.
class pseudo_normals {
public:
  pseudo_normals(const mesh_version& mesh, const region_walls& walls) : mesh_(mesh) {
    for (const auto& v : walls.triangles) {
      const vec3 n = normalized(whole_of(v));
      for (int k = 0; k < 3; ++k) {
        const vec3 at = mesh.position(v[k]);
        const vec3 a = normalized(mesh.position(v[(k + 1) % 3]) - at);
        const vec3 b = normalized(mesh.position(v[(k + 2) % 3]) - at);
        corners_[v[k]] += std::acos(std::clamp(dot(a, b), -1.0, 1.0)) * n;
        edges_[key(v[k], v[(k + 1) % 3])] += n;
      }
    }
  }

  /// At the point of a triangle nearest to some other point.
  [[nodiscard]] vec3 at(const std::array<vertex_id, 3>& v, vec3 nearest) const {
    std::array<double, 3> share{};
    const vec3 whole = whole_of(v);
    for (int k = 0; k < 3; ++k)
      share[k] =
        dot(area_vector(nearest, mesh_.position(v[(k + 1) % 3]), mesh_.position(v[(k + 2) % 3])),
            whole) /
        dot(whole, whole);
    constexpr double none = 1e-9;
    for (int k = 0; k < 3; ++k)
      if (share[k] > 1 - none)
        return corners_.at(v[k]);
    for (int k = 0; k < 3; ++k)
      if (share[k] < none)
        return edges_.at(key(v[(k + 1) % 3], v[(k + 2) % 3]));
    return whole;
  }

private:
  [[nodiscard]] vec3 whole_of(const std::array<vertex_id, 3>& v) const {
    return area_vector(mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2]));
  }

  static std::uint64_t key(vertex_id a, vertex_id b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  }

  const mesh_version& mesh_;
  std::unordered_map<vertex_id, vec3> corners_;
  std::unordered_map<std::uint64_t, vec3> edges_;
};

}  // namespace

/// Some triangles of the walls.
class shell_field::wall_tree {
public:
  wall_tree(const mesh_version& mesh, std::vector<std::array<vertex_id, 3>> corners,
            std::shared_ptr<const pseudo_normals> normals)
      : corners_(std::move(corners)), normals_(std::move(normals)) {
    for (const auto& v : corners_) {
      triangles_.emplace_back(point(mesh.position(v[0])), point(mesh.position(v[1])),
                              point(mesh.position(v[2])));
    }
    boxes_.insert(triangles_.begin(), triangles_.end());
    boxes_.accelerate_distance_queries();
  }

  struct nearest {
    vec3 at;
    double distance = 1e300;
    bool inside = false;  ///< The other point lies in the part, where these facets are nearest.
  };

  [[nodiscard]] nearest to(vec3 p) const {
    const auto [q, which] = boxes_.closest_point_and_primitive(point(p));
    const vec3 at = place(q);
    const auto& v = corners_[static_cast<std::size_t>(which - triangles_.begin())];
    return {at, norm(p - at), dot(p - at, normals_->at(v, at)) < 0};
  }

private:
  std::vector<std::array<vertex_id, 3>> corners_;
  std::shared_ptr<const pseudo_normals> normals_;
  triangles triangles_;
  tree boxes_;
};

shell_field::shell_field(const mesh_version& mesh, const region_walls& walls,
                         const std::vector<surface_id>& open, double thickness, double overlap)
    : thickness_(thickness), overlap_(overlap) {
  std::vector<std::array<vertex_id, 3>> kept;
  std::vector<std::array<vertex_id, 3>> left_open;
  for (std::size_t i = 0; i < walls.triangles.size(); ++i) {
    const auto& of = walls.surfaces[i];
    (of && std::ranges::count(open, *of) > 0 ? left_open : kept).push_back(walls.triangles[i]);
  }
  const auto normals = std::make_shared<const pseudo_normals>(mesh, walls);
  if (!kept.empty())
    closed_ = std::make_unique<wall_tree>(mesh, std::move(kept), normals);
  if (!left_open.empty())
    open_ = std::make_unique<wall_tree>(mesh, std::move(left_open), normals);
}

shell_field::~shell_field() = default;

field_sample shell_field::at(vec3 p) const {
  const auto wall = closed_ ? closed_->to(p) : wall_tree::nearest{};
  const auto opening = open_ ? open_->to(p) : wall_tree::nearest{};
  const bool inside = wall.distance < opening.distance ? wall.inside : opening.inside;
  if (!open_)
    return inside ? field_sample{thickness_ - wall.distance, normalized(wall.at - p)}
                  : field_sample{thickness_ + wall.distance, normalized(p - wall.at)};
  const vec3 away = normalized(p - opening.at);
  const field_sample beyond = inside ? field_sample{-opening.distance - overlap_, -away}
                                     : field_sample{opening.distance - overlap_, away};
  if (!closed_)
    return beyond;
  // Beyond an open wall the others go on as they stand where it is.
  const vec3 from = inside ? p : opening.at;
  const auto beside = inside ? wall : closed_->to(from);
  const field_sample within{thickness_ - beside.distance, normalized(beside.at - from)};
  return beyond.value > within.value ? beyond : within;
}

}  // namespace tedit::ops
