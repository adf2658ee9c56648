// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/quality.hpp"

#include <algorithm>
#include <limits>

namespace tedit {

double signed_volume(vec3 a, vec3 b, vec3 c, vec3 d) {
  return dot(b - a, cross(c - a, d - a)) / 6.0;
}

double signed_volume(const std::array<vec3, 4>& p) {
  return signed_volume(p[0], p[1], p[2], p[3]);
}

double radius_ratio(vec3 a, vec3 b, vec3 c, vec3 d) {
  const vec3 ab = b - a;
  const vec3 ac = c - a;
  const vec3 ad = d - a;
  const double volume = dot(ab, cross(ac, ad)) / 6.0;
  if (!(volume > 0))
    return 0;
  const double area = 0.5 * (norm(cross(ac, ad)) + norm(cross(ab, ad)) + norm(cross(ab, ac)) +
                             norm(cross(c - b, d - b)));
  const double la = norm(ab) * norm(d - c);
  const double lb = norm(ac) * norm(d - b);
  const double lc = norm(ad) * norm(c - b);
  // Heron's formula in the stable order of factors would need sorting; the clamp is enough, since
  // a product that rounds below zero belongs to a flat tet.
  const double s = 0.5 * (la + lb + lc);
  const double heron = s * (s - la) * (s - lb) * (s - lc);
  if (!(heron > 0) || !(area > 0))
    return 0;
  return std::min(1.0, 54.0 * volume * volume / (area * std::sqrt(heron)));
}

double radius_ratio(const std::array<vec3, 4>& p) {
  return radius_ratio(p[0], p[1], p[2], p[3]);
}

double harmonic_energy(const std::array<vec3, 4>& p) {
  const double volume = signed_volume(p);
  if (!(volume > 0))
    return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (const auto& face : tet_faces) {
    const vec3 area = 0.5 * cross(p[face[1]] - p[face[0]], p[face[2]] - p[face[0]]);
    sum += dot(area, area);
  }
  return sum / volume;
}

std::array<double, 6> dihedral_angles(const std::array<vec3, 4>& p) {
  constexpr std::array<std::array<int, 4>, 6> edges{
    {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}};
  std::array<double, 6> angles{};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto [a, b, c, d] = edges[i];
    const vec3 axis = normalized(p[b] - p[a]);
    const vec3 u = (p[c] - p[a]) - dot(p[c] - p[a], axis) * axis;
    const vec3 v = (p[d] - p[a]) - dot(p[d] - p[a], axis) * axis;
    angles[i] = std::atan2(norm(cross(u, v)), dot(u, v));
  }
  return angles;
}

value_summary summarize(std::vector<double> values) {
  if (values.empty())
    return {};
  const auto [low, high] = std::ranges::minmax_element(values);
  value_summary result{*low, 0, *high};
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  result.median = *middle;
  // An even count has two middle values.
  if (values.size() % 2 == 0)
    result.median = 0.5 * (result.median + *std::ranges::max_element(values.begin(), middle));
  return result;
}

value_summary radius_ratios(const mesh_version& mesh) {
  std::vector<double> values;
  values.reserve(mesh.tet_count());
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t))
      values.push_back(radius_ratio(mesh.corners(t)));
  return summarize(std::move(values));
}

value_summary radius_ratios(const mesh_version& mesh, const std::vector<tet_id>& tets) {
  std::vector<double> values;
  values.reserve(tets.size());
  for (const auto t : tets)
    if (t < mesh.tet_slots() && mesh.is_live_tet(t))
      values.push_back(radius_ratio(mesh.corners(t)));
  return summarize(std::move(values));
}

}  // namespace tedit
