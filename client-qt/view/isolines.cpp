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

/// The lines of some triangles of a mesh.
class line_maker {
public:
  line_maker(vtkPolyData& mesh, std::span<const float> values, std::span<const double> levels)
      : mesh_(mesh), values_(values), levels_(levels) {}

  void add(vtkIdType triangle) {
    vtkIdType count = 0;
    const vtkIdType* at = nullptr;
    mesh_.GetCellPoints(triangle, count, at);
    std::array<corner, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k].value = values_[static_cast<std::size_t>(at[k])];
      mesh_.GetPoints()->GetPoint(at[k], corners[k].at.data());
    }
    if (std::ranges::any_of(corners, [](const corner& c) { return !std::isfinite(c.value); }))
      return;
    std::ranges::sort(corners, {}, &corner::value);
    add_lines(corners, levels_, points_, lines_);
  }

  [[nodiscard]] vtkSmartPointer<vtkPolyData> take() {
    auto result = vtkSmartPointer<vtkPolyData>::New();
    result->SetPoints(points_);
    result->SetLines(lines_);
    return result;
  }

private:
  vtkPolyData& mesh_;
  std::span<const float> values_;
  std::span<const double> levels_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> lines_;
};

}  // namespace

vtkSmartPointer<vtkPolyData> make_isolines(const part_geometry& part, std::span<const float> values,
                                           std::span<const double> levels,
                                           const std::set<surface_id>& hidden) {
  line_maker lines(*part.faces, values, levels);
  for (const auto& [id, range] : part.cells)
    for (auto i = range.first; !hidden.contains(id) && i < range.second; ++i)
      lines.add(i);
  return lines.take();
}

vtkSmartPointer<vtkPolyData> make_isolines(vtkPolyData& mesh, std::span<const float> values,
                                           std::span<const double> levels) {
  line_maker lines(mesh, values, levels);
  mesh.BuildCells();
  for (vtkIdType i = 0; i < mesh.GetNumberOfCells(); ++i)
    lines.add(i);
  return lines.take();
}

}  // namespace tedit::desktop
