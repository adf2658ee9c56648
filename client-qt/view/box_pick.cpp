// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/box_pick.hpp"

#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace tedit::desktop {

namespace {

constexpr double pixels_between_rays = 4;
constexpr int most_rays_a_side = 96;

int steps(double pixels) {
  return std::clamp(static_cast<int>(pixels / pixels_between_rays) + 1, 1, most_rays_a_side);
}

/// Near and far planes are seen square on: points of them lie evenly between those of the corners.
vec3 between(const pick_box& box, std::size_t end, double x, double y) {
  const vec3 below = (1 - x) * box.rays[0][end] + x * box.rays[1][end];
  const vec3 above = (1 - x) * box.rays[2][end] + x * box.rays[3][end];
  return (1 - y) * below + y * above;
}

std::set<surface_id> seen_in(const part_geometry& part, const pick_box& box) {
  std::set<surface_id> seen;
  const int columns = steps(box.width);
  const int rows = steps(box.height);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double x = (i + 0.5) / columns;
      const double y = (j + 0.5) / rows;
      if (const auto hit = pick_visible(part, box.hidden, box.section, between(box, 0, x, y),
                                        between(box, 1, x, y)))
        seen.insert(hit->surface);
    }
  return seen;
}

bool lies_in(const part_geometry& part, const pick_box& box, surface_id id) {
  const auto range = part.cells.at(id);
  for (auto cell = range.first; cell < range.second; ++cell) {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    part.faces->GetCellPoints(cell, count, points);
    for (vtkIdType k = 0; k < count; ++k) {
      std::array<double, 3> p{};
      part.faces->GetPoints()->GetPoint(points[k], p.data());
      const auto [x, y] = box.to_pixels.apply({p[0], p[1], p[2]});
      if (x < box.left || x > box.left + box.width || y < box.bottom || y > box.bottom + box.height)
        return false;
    }
  }
  return true;
}

}  // namespace

std::optional<picked_point> pick_visible(const part_geometry& part,
                                         const std::set<surface_id>& hidden,
                                         const std::optional<section_plane>& section, vec3 from,
                                         const vec3& to) {
  for (int tries = 0; tries < 64; ++tries) {
    auto hit = pick(part, from, to);
    if (!hit || (!hidden.contains(hit->surface) && !(section && section->takes_away(hit->at))))
      return hit;
    const vec3 way = to - from;
    from = hit->at + 1e-6 * way;
  }
  return std::nullopt;
}

std::vector<surface_id> surfaces_in(const part_geometry& part, const pick_box& box) {
  const auto seen = seen_in(part, box);
  std::vector<surface_id> result;
  for (const auto id : seen)
    if (box.by == pick_box::rule::touched || lies_in(part, box, id))
      result.push_back(id);
  return result;
}

}  // namespace tedit::desktop
