// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/part_geometry.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkGenericCell.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkStaticCellLocator.h>
#include <vtkUnsignedIntArray.h>

#include <algorithm>
#include <cmath>

namespace tedit::desktop {

namespace {

constexpr double sharp_angle_deg = 30;

struct cell {
  std::array<vtkIdType, 3> points;
  surface_id surface;
  facet_id facet;
};

/// Vertices and triangles with dense numbers.
struct raw_part {
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedIntArray> numbers;
  std::vector<cell> cells;
};

void add_points(const client::surface_model& surface, const std::vector<std::uint32_t>& displaced,
                const std::vector<float>& displacement, double scale,
                std::vector<vtkIdType>& number_of, raw_part& raw) {
  std::vector<std::uint32_t> used;
  surface.facets().for_each([&](std::uint32_t, const client::surface_facet& facet) {
    used.insert(used.end(), facet.v.begin(), facet.v.end());
  });
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  number_of.assign(used.empty() ? 0 : used.back() + 1, -1);
  raw.points->SetDataTypeToFloat();
  raw.points->SetNumberOfPoints(static_cast<vtkIdType>(used.size()));
  raw.numbers->SetName("slot");
  raw.numbers->SetNumberOfTuples(static_cast<vtkIdType>(used.size()));
  std::size_t d = 0;  // Both lists ascend.
  for (std::size_t i = 0; i < used.size(); ++i) {
    vec3 at = *surface.positions().find(used[i]);
    while (d < displaced.size() && displaced[d] < used[i])
      ++d;
    if (scale != 0 && d < displaced.size() && displaced[d] == used[i] &&
        displacement.size() >= 3 * (d + 1))
      at = {at.x + scale * displacement[3 * d], at.y + scale * displacement[3 * d + 1],
            at.z + scale * displacement[3 * d + 2]};
    number_of[used[i]] = static_cast<vtkIdType>(i);
    raw.points->SetPoint(static_cast<vtkIdType>(i), at.x, at.y, at.z);
    raw.numbers->SetValue(static_cast<vtkIdType>(i), used[i]);
  }
}

/// Triangles grouped by surface.
void add_cells(const client::surface_model& surface, const std::vector<vtkIdType>& number_of,
               raw_part& raw) {
  raw.cells.reserve(surface.total_facets());
  surface.facets().for_each([&](std::uint32_t slot, const client::surface_facet& f) {
    raw.cells.push_back(
      {{number_of[f.v[0]], number_of[f.v[1]], number_of[f.v[2]]}, f.surface, slot});
  });
  std::ranges::stable_sort(raw.cells, {}, &cell::surface);
}

vec3 point(vtkPoints* points, vtkIdType i) {
  std::array<double, 3> p{};
  points->GetPoint(i, p.data());
  return {p[0], p[1], p[2]};
}

vec3 unit_normal(const raw_part& raw, const cell& c) {
  auto* points = raw.points.Get();
  const vec3 a = point(points, c.points[0]);
  const vec3 n = cross(point(points, c.points[1]) - a, point(points, c.points[2]) - a);
  const double size = std::sqrt(dot(n, n));
  return size > 0 ? (1 / size) * n : vec3{};
}

vtkSmartPointer<vtkPolyData> make_edges(const raw_part& raw) {
  struct half_edge {
    std::uint64_t key;
    std::uint32_t cell;
  };
  std::vector<half_edge> all;
  all.reserve(3 * raw.cells.size());
  for (std::uint32_t i = 0; i < raw.cells.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const auto a = static_cast<std::uint64_t>(raw.cells[i].points[k]);
      const auto b = static_cast<std::uint64_t>(raw.cells[i].points[(k + 1) % 3]);
      all.push_back({std::min(a, b) << 32 | std::max(a, b), i});
    }
  std::ranges::sort(all, {}, &half_edge::key);
  const double sharp = std::cos(sharp_angle_deg * 3.14159265358979323846 / 180);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> lines;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    if (all[i].key != all[i + 1].key)
      continue;
    const auto& a = raw.cells[all[i].cell];
    const auto& b = raw.cells[all[i + 1].cell];
    if (a.surface == b.surface && dot(unit_normal(raw, a), unit_normal(raw, b)) > sharp)
      continue;
    const std::array<vtkIdType, 2> ends{static_cast<vtkIdType>(all[i].key >> 32),
                                        static_cast<vtkIdType>(all[i].key & 0xffffffffU)};
    lines->InsertNextCell(2, ends.data());
  }
  result->SetPoints(raw.points);
  result->SetLines(lines);
  return result;
}

vtkSmartPointer<vtkPolyData> make_faces(const raw_part& raw) {
  vtkNew<vtkPolyData> plain;
  vtkNew<vtkCellArray> triangles;
  for (const auto& c : raw.cells)
    triangles->InsertNextCell(3, c.points.data());
  plain->SetPoints(raw.points);
  plain->SetPolys(triangles);
  plain->GetPointData()->AddArray(raw.numbers);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(plain);
  normals->SetFeatureAngle(sharp_angle_deg);
  normals->SplittingOn();
  normals->ConsistencyOff();  // The server's facets are oriented.
  normals->Update();
  return normals->GetOutput();
}

std::vector<float> areas_of(vtkPolyData& faces) {
  std::vector<float> result(static_cast<std::size_t>(faces.GetNumberOfPoints()));
  for (vtkIdType i = 0; i < faces.GetNumberOfCells(); ++i) {
    vtkIdType count = 0;
    const vtkIdType* at = nullptr;
    faces.GetCellPoints(i, count, at);
    const vec3 a = point(faces.GetPoints(), at[0]);
    const vec3 n = cross(point(faces.GetPoints(), at[1]) - a, point(faces.GetPoints(), at[2]) - a);
    for (int k = 0; k < 3; ++k)
      result[static_cast<std::size_t>(at[k])] += static_cast<float>(std::sqrt(dot(n, n)) / 6);
  }
  return result;
}

}  // namespace

std::shared_ptr<const part_geometry> build_part(const client::surface_model& surface,
                                                const std::vector<std::uint32_t>& displaced,
                                                const std::vector<float>& displacement,
                                                double scale) {
  raw_part raw;
  std::vector<vtkIdType> number_of;
  add_points(surface, displaced, displacement, scale, number_of, raw);
  add_cells(surface, number_of, raw);
  auto part = std::make_shared<part_geometry>();
  part->version_id = surface.version_id();
  part->faces = make_faces(raw);
  part->edges = make_edges(raw);
  auto* numbers = vtkUnsignedIntArray::SafeDownCast(part->faces->GetPointData()->GetArray("slot"));
  if (numbers)
    part->vertices.assign(numbers->GetPointer(0),
                          numbers->GetPointer(0) + numbers->GetNumberOfTuples());
  part->cell_surface.reserve(raw.cells.size());
  part->cell_facet.reserve(raw.cells.size());
  for (const auto& c : raw.cells) {
    const auto at = static_cast<std::int64_t>(part->cell_surface.size());
    auto [range, first] = part->cells.try_emplace(c.surface, at, at);
    range->second.second = at + 1;
    part->cell_surface.push_back(c.surface);
    part->cell_facet.push_back(c.facet);
  }
  part->faces->BuildCells();  // Else the first reader would, maybe on two threads.
  part->areas = areas_of(*part->faces);
  part->faces->GetBounds(part->bounds.data());
  part->locator = vtkSmartPointer<vtkStaticCellLocator>::New();
  part->locator->SetDataSet(part->faces);
  part->locator->BuildLocator();
  return part;
}

std::optional<picked_point> pick(const part_geometry& part, const vec3& from, const vec3& to) {
  if (part.faces->GetNumberOfCells() == 0)
    return std::nullopt;
  const std::array<double, 3> a{from.x, from.y, from.z};
  const std::array<double, 3> b{to.x, to.y, to.z};
  std::array<double, 3> at{};
  std::array<double, 3> local{};
  double t = 0;
  int sub = 0;
  vtkIdType cell = -1;
  vtkNew<vtkGenericCell> scratch;
  if (!part.locator->IntersectWithLine(a.data(), b.data(), 0, t, at.data(), local.data(), sub, cell,
                                       scratch))
    return std::nullopt;
  picked_point result;
  result.surface = part.cell_surface[static_cast<std::size_t>(cell)];
  result.at = {at[0], at[1], at[2]};
  result.cell = cell;
  result.weights = {1 - local[0] - local[1], local[0], local[1]};
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  part.faces->GetCellPoints(cell, count, points);
  auto* corners = part.faces->GetPoints();
  const vec3 first = point(corners, points[0]);
  const vec3 n = cross(point(corners, points[1]) - first, point(corners, points[2]) - first);
  result.normal = n / std::max(1e-300, std::sqrt(dot(n, n)));
  for (int k = 0; k < 3; ++k)
    result.vertices[k] = part.vertices[static_cast<std::size_t>(points[k])];
  return result;
}

/// Calls `visit` with the three points of each triangle of these surfaces.
template <class Visit>
static void for_each_triangle(const part_geometry& part, const std::vector<surface_id>& wanted,
                              const Visit& visit) {
  for (const auto id : wanted) {
    const auto range = part.cells.find(id);
    if (range == part.cells.end())
      continue;
    for (auto i = range->second.first; i < range->second.second; ++i) {
      vtkIdType count = 0;
      const vtkIdType* points = nullptr;
      part.faces->GetCellPoints(i, count, points);
      visit(points);
    }
  }
}

vtkSmartPointer<vtkPolyData> extract(const part_geometry& part,
                                     const std::vector<surface_id>& wanted) {
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> triangles;
  for_each_triangle(part, wanted,
                    [&](const vtkIdType* points) { triangles->InsertNextCell(3, points); });
  result->SetPoints(part.faces->GetPoints());
  result->SetPolys(triangles);
  result->GetPointData()->SetNormals(part.faces->GetPointData()->GetNormals());
  return result;
}

/// Points are doubled at sharp edges: which edges are the same is told by their vertices.
vtkSmartPointer<vtkPolyData> outline(const part_geometry& part,
                                     const std::vector<surface_id>& wanted) {
  struct edge {
    std::uint64_t key;
    std::array<vtkIdType, 2> ends;
  };
  std::vector<edge> all;
  for_each_triangle(part, wanted, [&](const vtkIdType* points) {
    for (int k = 0; k < 3; ++k) {
      const std::array<vtkIdType, 2> ends{points[k], points[(k + 1) % 3]};
      const std::uint64_t a = part.vertices[static_cast<std::size_t>(ends[0])];
      const std::uint64_t b = part.vertices[static_cast<std::size_t>(ends[1])];
      all.push_back({std::min(a, b) << 32 | std::max(a, b), ends});
    }
  });
  std::ranges::sort(all, {}, &edge::key);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> lines;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool again = (i > 0 && all[i - 1].key == all[i].key) ||
                       (i + 1 < all.size() && all[i + 1].key == all[i].key);
    if (!again)
      lines->InsertNextCell(2, all[i].ends.data());
  }
  result->SetPoints(part.faces->GetPoints());
  result->SetLines(lines);
  return result;
}

vtkSmartPointer<vtkPolyData> make_cap(const client::section& cut, double scale) {
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  const auto count = static_cast<vtkIdType>(cut.positions.size() / 3);
  points->SetNumberOfPoints(count);
  const auto& moved = cut.values.of("displacement_m");
  const bool moves = scale != 0 && moved.size() == cut.positions.size();
  for (vtkIdType i = 0; i < count; ++i) {
    std::array<double, 3> at{};
    for (int c = 0; c < 3; ++c) {
      const auto k = static_cast<std::size_t>(3 * i + c);
      at[c] = cut.positions[k] + (moves ? scale * moved[k] : 0);
    }
    points->SetPoint(i, at.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (std::size_t i = 0; i + 2 < cut.triangles.size(); i += 3) {
    const std::array<vtkIdType, 3> corners{cut.triangles[i], cut.triangles[i + 1],
                                           cut.triangles[i + 2]};
    triangles->InsertNextCell(3, corners.data());
  }
  result->SetPoints(points);
  result->SetPolys(triangles);
  return result;
}

}  // namespace tedit::desktop
