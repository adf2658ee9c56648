// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/isolines.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace tedit::desktop {

namespace {

/// A triangle's corners with their values, ascending by value.
struct corner {
  double value;
  std::array<double, 3> at;
};

std::array<double, 3> between(const corner& a, const corner& b, double level) {
  const double t = (level - a.value) / (b.value - a.value);
  std::array<double, 3> result{};
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = a.at[c] + t * (b.at[c] - a.at[c]);
  return result;
}

/// A level that just touches a corner gives no line.
void add_lines(const std::array<corner, 3>& c, std::span<const double> levels, vtkPoints* points,
               vtkCellArray* lines) {
  for (auto level = std::ranges::upper_bound(levels, c[0].value);
       level != levels.end() && *level < c[2].value; ++level) {
    const auto one = between(c[0], c[2], *level);
    const auto other =
      *level < c[1].value ? between(c[0], c[1], *level) : between(c[1], c[2], *level);
    const std::array<vtkIdType, 2> ends{points->InsertNextPoint(one.data()),
                                        points->InsertNextPoint(other.data())};
    lines->InsertNextCell(2, ends.data());
  }
}

}  // namespace

vtkSmartPointer<vtkPolyData> make_isolines(const part_geometry& part, std::span<const float> values,
                                           std::span<const double> levels,
                                           const std::set<surface_id>& hidden) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  auto* from = part.faces->GetPoints();
  for (const auto& [id, range] : part.cells) {
    if (hidden.contains(id))
      continue;
    for (auto i = range.first; i < range.second; ++i) {
      vtkIdType count = 0;
      const vtkIdType* at = nullptr;
      part.faces->GetCellPoints(i, count, at);
      std::array<corner, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k].value = values[static_cast<std::size_t>(at[k])];
        from->GetPoint(at[k], corners[k].at.data());
      }
      if (std::ranges::any_of(corners, [](const corner& c) { return !std::isfinite(c.value); }))
        continue;
      std::ranges::sort(corners, {}, &corner::value);
      add_lines(corners, levels, points, lines);
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetLines(lines);
  return result;
}

}  // namespace tedit::desktop
