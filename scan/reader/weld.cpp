// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "mesh/box.hpp"
#include "mesh/place_text.hpp"
#include "scan/reader/mend.hpp"

namespace tedit::scan {

namespace {

/// Points within the tolerance of one that stays become it. Sorted along an oblique line, to which
/// no plane of a part is square: few others lie near a place there.
std::vector<std::uint32_t> places_of_points(const std::vector<vec3>& points, double tolerance) {
  const vec3 along = normalized({1, std::numbers::sqrt2, std::numbers::sqrt3});
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::uint32_t v = 0; v < points.size(); ++v)
    order.emplace_back(dot(points[v], along), v);
  std::ranges::sort(order);
  std::vector<std::uint32_t> place(points.size(), no_id);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto v = order[i].second;
    if (place[v] != no_id)
      continue;
    place[v] = v;
    for (std::size_t j = i + 1; j < order.size() && order[j].first - order[i].first <= tolerance;
         ++j)
      if (const auto w = order[j].second;
          place[w] == no_id && norm(points[w] - points[v]) <= tolerance)
        place[w] = v;
  }
  return place;
}

double height_of(const triangle_surface& surface, const triangle_corners& t) {
  const vec3 a = surface.points[t[0]];
  const vec3 b = surface.points[t[1]];
  const vec3 c = surface.points[t[2]];
  const double longest = std::max({norm(b - a), norm(c - b), norm(a - c)});
  return longest > 0 ? norm(cross(b - a, c - a)) / longest : 0;
}

/// Keeps the triangles that `keep` says, with what belongs to them.
template <class Keep>
void keep_triangles(file_surface& read, const Keep& keep) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < read.surface.triangles.size(); ++t) {
    if (!keep(t))
      continue;
    read.surface.triangles[kept] = read.surface.triangles[t];
    if (!read.group_of.empty())
      read.group_of[kept] = read.group_of[t];
    if (!read.body_of.empty())
      read.body_of[kept] = read.body_of[t];
    ++kept;
  }
  read.surface.triangles.resize(kept);
  if (!read.group_of.empty())
    read.group_of.resize(kept);
  if (!read.body_of.empty())
    read.body_of.resize(kept);
}

void drop_unused_points(triangle_surface& surface) {
  std::vector<std::uint32_t> place(surface.points.size(), no_id);
  std::vector<vec3> points;
  for (auto& t : surface.triangles)
    for (auto& v : t) {
      if (place[v] == no_id) {
        place[v] = static_cast<std::uint32_t>(points.size());
        points.push_back(surface.points[v]);
      }
      v = place[v];
    }
  surface.points = std::move(points);
}

}  // namespace

std::string place_of(vec3 mm) {
  return place_text(1e-3 * mm);
}

double extent_of(const triangle_surface& surface) {
  box extent;
  for (const auto& p : surface.points)
    extent.add(p);
  return surface.points.empty() ? 0 : norm(extent.high - extent.low);
}

bool is_closed(const triangle_surface& surface) {
  return std::ranges::all_of(triangles_across(surface.triangles), [](const auto& across) {
    return std::ranges::find(across, no_id) == across.end();
  });
}

double weld_tolerance(const triangle_surface& surface) {
  constexpr double share_of_extent = 2e-6;
  constexpr double share_of_edges = 0.1;
  constexpr std::size_t of_a_hundred = 100;
  const double size = extent_of(surface);
  std::vector<double> lengths;
  for (const auto& t : surface.triangles)
    for (int k = 0; k < 3; ++k)
      if (const double length = norm(surface.points[t[(k + 1) % 3]] - surface.points[t[k]]);
          length > 1e-9 * size)
        lengths.push_back(length);
  if (lengths.empty())
    return share_of_extent * size;
  const auto short_one =
    lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / of_a_hundred);
  std::ranges::nth_element(lengths, short_one);
  return std::min(share_of_extent * size, share_of_edges * *short_one);
}

weld_report weld(file_surface& read, double tolerance) {
  auto& surface = read.surface;
  const auto place = places_of_points(surface.points, tolerance);
  for (auto& t : surface.triangles)
    for (auto& v : t)
      v = place[v];
  weld_report report;
  std::set<triangle_corners> known;
  keep_triangles(read, [&](std::size_t i) {
    auto t = surface.triangles[i];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ||
        (tolerance > 0 && height_of(surface, t) <= tolerance)) {
      ++report.degenerate;
      return false;
    }
    std::ranges::sort(t);
    const bool is_new = known.insert(t).second;
    report.duplicate += !is_new;
    return is_new;
  });
  drop_unused_points(surface);
  return report;
}

}  // namespace tedit::scan
