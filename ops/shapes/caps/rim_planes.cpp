// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/caps/rim_planes.hpp"

#include <algorithm>
#include <cmath>

namespace tedit::ops {

namespace {

/// Planes that meet at less than about 3 degrees are not told apart safely.
constexpr double least_sine = 0.05;

bool lies_in(const mesh_version& mesh, const boundary_facet& f, const rim_plane& plane,
             double tolerance) {
  return std::ranges::all_of(f.v, [&](vertex_id v) {
    return std::abs(dot(mesh.position(v) - plane.point, plane.normal)) <= tolerance;
  });
}

/// The longest run from edge `first` on that stays in one plane.
rim_plane run_from(const mesh_version& mesh, const rim& r, std::size_t first, double tolerance) {
  const std::size_t n = r.loop.size();
  rim_plane plane;
  plane.first = first;
  plane.point = mesh.position(r.loop[first]);
  vec3 sum;
  for (; plane.edges < n; ++plane.edges) {
    const auto& f = mesh.facet(r.outer[(first + plane.edges) % n]);
    const vec3 area = area_vector(mesh, f);
    if (plane.edges > 0 && (!lies_in(mesh, f, plane, tolerance) || dot(area, plane.normal) <= 0))
      break;
    sum += area;
    plane.normal = normalized(sum);
  }
  return plane;
}

}  // namespace

std::vector<rim_plane> rim_planes(const mesh_version& mesh, const rim& r) {
  const std::size_t n = r.loop.size();
  const double tolerance = 1e-4 * std::max(r.mean_edge, r.radius);
  // The first run may begin in the middle of its plane: start again where it ended.
  const auto lead = run_from(mesh, r, 0, tolerance);
  std::vector<rim_plane> planes;
  std::size_t done = 0;
  while (done < n && planes.size() < 4) {
    planes.push_back(run_from(mesh, r, (lead.edges + done) % n, tolerance));
    done += planes.back().edges;
  }
  if (done != n || planes.size() < 2 || planes.size() > 3)
    return {};
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (norm(cross(planes[i].normal, planes[j].normal)) < least_sine)
        return {};
  return planes;
}

std::optional<vec3> common_point(const std::vector<rim_plane>& planes) {
  const auto& [a, b, c] = std::tie(planes[0], planes[1], planes[2]);
  const double volume = dot(a.normal, cross(b.normal, c.normal));
  if (std::abs(volume) < least_sine)
    return std::nullopt;
  return (dot(a.point, a.normal) * cross(b.normal, c.normal) +
          dot(b.point, b.normal) * cross(c.normal, a.normal) +
          dot(c.point, c.normal) * cross(a.normal, b.normal)) /
         volume;
}

}  // namespace tedit::ops
