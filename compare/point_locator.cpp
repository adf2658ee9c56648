// SPDX-License-Identifier: AGPL-3.0-or-later
#include "compare/point_locator.hpp"

#include <algorithm>

namespace tedit {

namespace {

std::vector<box> boxes_around(const mesh_version& mesh, std::span<const tet_id> tets) {
  std::vector<box> result;
  result.reserve(tets.size());
  for (const auto t : tets) {
    const auto extent = box_of(mesh.corners(t));
    const vec3 size = extent.high - extent.low;
    // Three weights of -`still_inside` leave the box by three times that of its size.
    result.push_back(extent.grown(3 * still_inside * std::max({size.x, size.y, size.z})));
  }
  return result;
}

}  // namespace

double located_point::least() const {
  return std::ranges::min(weights);
}

std::optional<std::array<double, 4>> barycentric(const std::array<vec3, 4>& corners,
                                                 const vec3& p) {
  const vec3 a = corners[1] - corners[0];
  const vec3 b = corners[2] - corners[0];
  const vec3 c = corners[3] - corners[0];
  const vec3 d = p - corners[0];
  const double six_volumes = dot(a, cross(b, c));
  if (!(six_volumes > 0))
    return std::nullopt;
  const double u = dot(d, cross(b, c)) / six_volumes;
  const double v = dot(a, cross(d, c)) / six_volumes;
  const double w = dot(a, cross(b, d)) / six_volumes;
  return std::array<double, 4>{1 - u - v - w, u, v, w};
}

void put_on_face(std::array<double, 4>& weights) {
  double sum = 0;
  for (auto& w : weights)
    sum += w = std::max(w, 0.0);
  for (auto& w : weights)
    w /= sum;
}

point_locator::point_locator(const mesh_version& mesh, std::span<const tet_id> tets)
    : mesh_(mesh), tets_(tets.begin(), tets.end()), boxes_(boxes_around(mesh, tets)) {
  // nop
}

std::optional<located_point> point_locator::find(const vec3& p) const {
  located_point best;
  double depth = -still_inside;
  (void)boxes_.any_meeting(box{p, p}, [&](std::size_t i) {
    const auto t = tets_[i];
    const auto weights = barycentric(mesh_.corners(t), p);
    if (!weights)
      return false;
    const double least = std::ranges::min(*weights);
    if (least > depth || (least == depth && t < best.tet)) {
      depth = least;
      best = {t, *weights};
    }
    return false;
  });
  if (best.tet == no_id)
    return std::nullopt;
  put_on_face(best.weights);
  return best;
}

}  // namespace tedit
