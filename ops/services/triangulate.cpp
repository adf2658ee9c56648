// SPDX-License-Identifier: AGPL-3.0-or-later
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <vector>

#include "ops/services/host_services.hpp"

namespace tedit::ops {

namespace {

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct face_mark {
  int depth = -1;  ///< Constraint edges between the face and infinity; odd is inside.
};

using vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, kernel>;
using face_base = CGAL::Constrained_triangulation_face_base_2<
  kernel, CGAL::Triangulation_face_base_with_info_2<face_mark, kernel>>;
using structure = CGAL::Triangulation_data_structure_2<vertex_base, face_base>;
using triangulation =
  CGAL::Constrained_Delaunay_triangulation_2<kernel, structure,
                                             CGAL::No_constraint_intersection_tag>;
using point2 = std::array<double, 2>;

/// Flood from outside: every constraint that is crossed changes the side.
void mark_depths(triangulation& t) {
  for (auto face : t.all_face_handles())
    face->info().depth = -1;
  std::vector<triangulation::Face_handle> open{t.infinite_face()};
  std::vector<triangulation::Face_handle> next;
  for (int depth = 0; !open.empty(); ++depth) {
    while (!open.empty()) {
      const auto face = open.back();
      open.pop_back();
      if (face->info().depth != -1)
        continue;
      face->info().depth = depth;
      for (int i = 0; i < 3; ++i) {
        const auto other = face->neighbor(i);
        if (other->info().depth == -1)
          (face->is_constrained(i) ? next : open).push_back(other);
      }
    }
    open.swap(next);
  }
}

double distance_to_segment(point2 p, point2 a, point2 b) {
  const double ux = b[0] - a[0];
  const double uy = b[1] - a[1];
  const double length2 = ux * ux + uy * uy;
  const double along =
    length2 > 0 ? std::clamp(((p[0] - a[0]) * ux + (p[1] - a[1]) * uy) / length2, 0.0, 1.0) : 0;
  return std::hypot(p[0] - a[0] - along * ux, p[1] - a[1] - along * uy);
}

bool inside(const planar_polygon& polygon, point2 p) {
  bool result = false;
  for (const auto& loop : polygon.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& a = polygon.points[loop[i]];
      const auto& b = polygon.points[loop[(i + 1) % loop.size()]];
      if ((a[1] > p[1]) != (b[1] > p[1]) &&
          p[0] < (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0])
        result = !result;
    }
  return result;
}

/// A hexagonal grid at `spacing` inside the polygon, at least 0.6 spacing from its loops.
std::vector<point2> interior_points(const planar_polygon& polygon, double spacing) {
  point2 low{1e300, 1e300};
  point2 high{-1e300, -1e300};
  for (const auto& loop : polygon.loops)
    for (const auto i : loop)
      for (int c = 0; c < 2; ++c) {
        low[c] = std::min(low[c], polygon.points[i][c]);
        high[c] = std::max(high[c], polygon.points[i][c]);
      }
  std::vector<point2> result;
  const double rise = spacing * std::sqrt(0.75);
  const double columns = (high[0] - low[0]) / spacing;
  const double rows = (high[1] - low[1]) / rise;
  if (!(spacing > 0) || !(columns * rows < 4e6))
    return result;
  // The grid lies symmetric about the middle of the polygon's box.
  const point2 middle{0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])};
  const int half_rows = static_cast<int>(rows / 2) + 1;
  const int half_columns = static_cast<int>(columns / 2) + 2;
  for (int row = -half_rows; row <= half_rows; ++row) {
    for (int column = -half_columns; column <= half_columns; ++column) {
      const point2 p{middle[0] + spacing * (column + (row % 2 != 0 ? 0.5 : 0)),
                     middle[1] + rise * row};
      if (!inside(polygon, p))
        continue;
      double nearest = std::numeric_limits<double>::max();
      for (const auto& loop : polygon.loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
          nearest =
            std::min(nearest, distance_to_segment(p, polygon.points[loop[i]],
                                                  polygon.points[loop[(i + 1) % loop.size()]]));
      if (nearest >= 0.6 * spacing)
        result.push_back(p);
    }
  }
  return result;
}

/// Triangulates the loops with extra points; throws what CGAL throws.
planar_filling fill(const planar_polygon& polygon, const std::vector<point2>& extra) {
  triangulation t;
  std::vector<triangulation::Vertex_handle> handles(polygon.points.size());
  planar_filling result;
  result.points = polygon.points;
  for (const auto& loop : polygon.loops)
    for (const auto i : loop) {
      if (handles[i] != nullptr)
        continue;  // Loops may share a point.
      const auto known = t.number_of_vertices();
      handles[i] = t.insert({polygon.points[i][0], polygon.points[i][1]});
      if (t.number_of_vertices() == known)
        throw std::invalid_argument("two points of a rim coincide");
      handles[i]->info() = i;
    }
  if (t.dimension() < 2)
    return result;  // All on one line: there are no faces to mark.
  for (const auto& loop : polygon.loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      t.insert_constraint(handles[loop[i]], handles[loop[(i + 1) % loop.size()]]);
  for (const auto& p : extra) {
    t.insert({p[0], p[1]})->info() = static_cast<std::uint32_t>(result.points.size());
    result.points.push_back(p);
  }
  mark_depths(t);
  for (const auto face : t.finite_face_handles())
    if (face->info().depth % 2 == 1)
      result.triangles.push_back(
        {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return result;
}

/// Moves the extra points to the mean of their neighbours; the loops stay.
void smooth(planar_filling& filling, std::size_t fixed) {
  std::vector<std::set<std::uint32_t>> around(filling.points.size());
  for (const auto& triangle : filling.triangles)
    for (int i = 0; i < 3; ++i)
      for (int j = 1; j < 3; ++j)
        around[triangle[i]].insert(triangle[(i + j) % 3]);
  for (std::size_t i = fixed; i < filling.points.size(); ++i) {
    if (around[i].empty())
      continue;
    point2 mean{0, 0};
    for (const auto j : around[i])
      for (int c = 0; c < 2; ++c)
        mean[c] += filling.points[j][c] / static_cast<double>(around[i].size());
    filling.points[i] = mean;
  }
}

}  // namespace

expected<planar_filling> triangulate_polygon(const planar_polygon& polygon, double spacing) {
  constexpr int smoothing_rounds = 4;
  try {
    auto filling = fill(polygon, interior_points(polygon, spacing));
    const std::size_t fixed = polygon.points.size();
    for (int round = 0; round < smoothing_rounds && filling.points.size() > fixed; ++round) {
      smooth(filling, fixed);
      const std::vector<point2> extra(filling.points.begin() + static_cast<std::ptrdiff_t>(fixed),
                                      filling.points.end());
      filling = fill(polygon, extra);
    }
    if (filling.triangles.empty())
      return fail(ec::mesher_failed, "a rim encloses no area");
    return filling;
  } catch (const std::exception& e) {
    return fail(ec::mesher_failed, "a rim crosses itself or another rim");
  }
}

}  // namespace tedit::ops
