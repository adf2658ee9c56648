// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/tools/extruder.hpp"

#include <algorithm>
#include <cmath>

namespace tedit::ops {

namespace {

/// Long straight edges are divided: walls and ends need points along them.
outline divided(const outline& o, double size) {
  outline result;
  for (std::size_t i = 0; i < o.points.size(); ++i) {
    const auto& a = o.points[i];
    const auto& b = o.points[(i + 1) % o.points.size()];
    const int parts = parts_of(std::hypot(b[0] - a[0], b[1] - a[1]), size);
    for (int k = 0; k < parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      result.points.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
      result.side.push_back(o.side[i]);
    }
  }
  return result;
}

double signed_area(const outline& o) {
  double twice = 0;
  for (std::size_t i = 0; i < o.points.size(); ++i) {
    const auto& a = o.points[i];
    const auto& b = o.points[(i + 1) % o.points.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * twice;
}

/// In how many of the other outlines the first point lies: odd is a hole.
bool is_hole(const std::vector<outline>& all, std::size_t which) {
  const auto& p = all[which].points.front();
  bool inside = false;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k == which)
      continue;
    const auto& q = all[k].points;
    for (std::size_t i = 0, j = q.size() - 1; i < q.size(); j = i++)
      if ((q[i][1] > p[1]) != (q[j][1] > p[1]) &&
          p[0] < (q[j][0] - q[i][0]) * (p[1] - q[i][1]) / (q[j][1] - q[i][1]) + q[i][0])
        inside = !inside;
  }
  return inside;
}

}  // namespace

int parts_of(double length, double size) {
  return std::clamp(static_cast<int>(std::lround(length / size)), 1, 10'000);
}

void orient(std::vector<outline>& all) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool clockwise = signed_area(all[i]) < 0;
    if (clockwise == is_hole(all, i))
      continue;
    auto& o = all[i];
    std::ranges::reverse(o.points);
    // Edge i now goes where edge n - 2 - i went back.
    std::ranges::reverse(o.side);
    std::ranges::rotate(o.side, o.side.begin() + 1);
  }
}

std::vector<outline> divided_outlines(const profile& what, double size) {
  std::vector<outline> outlines;
  for (const auto& o : what.outlines)
    outlines.push_back(divided(o, size));
  orient(outlines);
  return outlines;
}

expected<planar_filling> fill_outlines(const std::vector<outline>& outlines, double size,
                                       services& host) {
  planar_polygon polygon;
  for (const auto& o : outlines) {
    std::vector<std::uint32_t> loop;
    for (const auto& p : o.points) {
      loop.push_back(static_cast<std::uint32_t>(polygon.points.size()));
      polygon.points.push_back(p);
    }
    polygon.loops.push_back(std::move(loop));
  }
  return host.triangulate(polygon, size);
}

void extruder::add_walls(const std::vector<outline>& outlines, std::uint32_t rim, int layers,
                         bool round) {
  std::uint32_t first = 0;
  for (const auto& o : outlines) {
    const auto n = static_cast<std::uint32_t>(o.points.size());
    for (std::uint32_t i = 0; i < n; ++i)
      for (int k = 0; k < layers; ++k) {
        const auto below = static_cast<std::uint32_t>(k) * rim + first;
        const auto above =
          static_cast<std::uint32_t>(round ? (k + 1) % layers : k + 1) * rim + first;
        const auto j = (i + 1) % n;
        const auto face = 2 + o.side[i];
        if ((i + static_cast<std::uint32_t>(k)) % 2 == 1) {
          add(below + i, below + j, above + j, face);
          add(below + i, above + j, above + i, face);
        } else {
          add(below + i, below + j, above + i, face);
          add(below + j, above + j, above + i, face);
        }
      }
    first += n;
  }
}

}  // namespace tedit::ops
