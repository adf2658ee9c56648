// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/hollow/shell_field.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <map>

namespace tedit::ops {

namespace {

using kernel = CGAL::Simple_cartesian<double>;
using triangles = std::vector<kernel::Triangle_3>;
using primitive = CGAL::AABB_triangle_primitive<kernel, triangles::const_iterator>;
using tree = CGAL::AABB_tree<CGAL::AABB_traits<kernel, primitive>>;

kernel::Point_3 point(vec3 p) {
  return {p.x, p.y, p.z};
}

}  // namespace

struct shell_field::nearest_tree {
  explicit nearest_tree(triangles all)
      : surface(std::move(all)), boxes(surface.begin(), surface.end()) {
    boxes.accelerate_distance_queries();
  }

  [[nodiscard]] vec3 to(vec3 p) const {
    const auto q = boxes.closest_point(point(p));
    return {q.x(), q.y(), q.z()};
  }

  triangles surface;
  tree boxes;
};

shell_field::shell_field(const mesh_version& mesh, const std::vector<surface_id>& open,
                         double thickness, double overlap)
    : thickness_(thickness), overlap_(overlap) {
  std::map<vertex_id, std::uint32_t> place;
  triangles kept;
  triangles left_open;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    auto& t = boundary_.triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const auto v = mesh.facet(f).v[k];
      const auto [found, is_new] = place.emplace(v, static_cast<std::uint32_t>(place.size()));
      if (is_new)
        boundary_.points.push_back(mesh.position(v));
      t[k] = found->second;
    }
    const bool is_open = std::ranges::count(open, mesh.facet(f).surface) > 0;
    (is_open ? left_open : kept)
      .emplace_back(point(boundary_.points[t[0]]), point(boundary_.points[t[1]]),
                    point(boundary_.points[t[2]]));
  }
  sides_ = std::make_unique<surface_tree>(boundary_);
  if (!kept.empty())
    closed_ = std::make_unique<nearest_tree>(std::move(kept));
  if (!left_open.empty())
    open_ = std::make_unique<nearest_tree>(std::move(left_open));
}

shell_field::~shell_field() = default;

field_sample shell_field::at(vec3 p) const {
  const bool inside = sides_->winding(p, {1, 0, 0}) > 0;
  field_sample result{-1e300, {}};
  if (closed_) {
    const vec3 away = p - closed_->to(p);
    const double distance = norm(away);
    const bool grows = open_ || inside;
    result = grows ? field_sample{thickness_ - distance, -normalized(away)}
                   : field_sample{thickness_ + distance, normalized(away)};
  }
  if (open_) {
    const vec3 away = p - open_->to(p);
    const double distance = norm(away);
    const double beyond = (inside ? -distance : distance) - overlap_;
    if (beyond > result.value)
      result = {beyond, inside ? -normalized(away) : normalized(away)};
  }
  return result;
}

}  // namespace tedit::ops
