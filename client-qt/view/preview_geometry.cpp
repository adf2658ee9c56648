// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/preview_geometry.hpp"

#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <cmath>

#include "mesh/box.hpp"

namespace tedit::desktop {

namespace {

using corners = std::array<vec3, 3>;

/// Vertices of a boundary that is where it was, relative to the part's size: new ones on a curved
/// wall are put on its facets.
constexpr double vertex_tolerance = 2e-5;

/// The same for the middle of facets and edges, relative to the longest edge: other triangles
/// between the vertices of a curved wall bulge by this much where a circle has eight of them.
constexpr double bulge_tolerance = 0.07;

corners corners_of(const client::surface_model& surface, const client::surface_facet& facet) {
  return {*surface.positions().find(facet.v[0]), *surface.positions().find(facet.v[1]),
          *surface.positions().find(facet.v[2])};
}

/// From corner to corner of the box around a surface, m.
double size_of(const client::surface_model& surface) {
  box all;
  surface.facets().for_each([&](std::uint32_t, const client::surface_facet& facet) {
    for (const auto& p : corners_of(surface, facet))
      all.add(p);
  });
  return norm(all.high - all.low);
}

double longest_edge(const corners& at) {
  return std::max({norm(at[1] - at[0]), norm(at[2] - at[1]), norm(at[0] - at[2])});
}

/// How far off the middle of a facet and of its edges may be, m.
double most_off(const corners& at, double size) {
  return std::max(vertex_tolerance * size, bulge_tolerance * longest_edge(at));
}

/// Distances to a surface, for facets in a place: what lies further off than these may is left out.
class nearness {
public:
  nearness(const client::surface_model& surface, const std::vector<corners>& asked)
      : size_(size_of(surface)) {
    box place;
    double most = 0;
    for (const auto& at : asked) {
      most = std::max(most, most_off(at, size_));
      for (const auto& p : at)
        place.add(p);
    }
    place = place.grown(1.01 * most);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> triangles;
    surface.facets().for_each([&](std::uint32_t, const client::surface_facet& facet) {
      const auto at = corners_of(surface, facet);
      if (!place.meets(box_of(at)))
        return;
      std::array<vtkIdType, 3> ids{};
      std::ranges::transform(at, ids.begin(),
                             [&](const vec3& p) { return points->InsertNextPoint(p.x, p.y, p.z); });
      triangles->InsertNextCell(3, ids.data());
    });
    is_empty_ = triangles->GetNumberOfCells() == 0;
    if (is_empty_)
      return;
    mesh_->SetPoints(points);
    mesh_->SetPolys(triangles);
    mesh_->BuildCells();
    locator_->SetDataSet(mesh_);
    locator_->BuildLocator();
  }

  /// Whether a facet lies on the surface.
  [[nodiscard]] bool holds(const corners& at) {
    for (const auto& p : at)
      if (distance(p) > vertex_tolerance * size_)
        return false;
    const double most = most_off(at, size_);
    if (distance((at[0] + at[1] + at[2]) / 3) > most)
      return false;
    for (int k = 0; k < 3; ++k)
      if (distance((at[k] + at[(k + 1) % 3]) / 2) > most)
        return false;
    return true;
  }

private:
  double distance(const vec3& from) {
    if (is_empty_)
      return size_;
    std::array<double, 3> at{from.x, from.y, from.z};
    std::array<double, 3> closest{};
    vtkIdType cell = -1;
    int sub = 0;
    double squared = 0;
    locator_->FindClosestPoint(at.data(), closest.data(), scratch_, cell, sub, squared);
    return cell < 0 ? size_ : std::sqrt(squared);
  }

  vtkNew<vtkPolyData> mesh_;
  vtkNew<vtkStaticCellLocator> locator_;
  vtkNew<vtkGenericCell> scratch_;
  double size_ = 0;
  bool is_empty_ = false;
};

/// The facets of `surface` that `other` does not have in the same slot at the same place.
std::vector<client::surface_facet> unlike(const client::surface_model& surface,
                                          const client::surface_model& other) {
  std::vector<client::surface_facet> result;
  surface.facets().for_each([&](std::uint32_t slot, const client::surface_facet& facet) {
    const auto* its = other.facets().find(slot);
    if (!its || its->v != facet.v || corners_of(surface, facet) != corners_of(other, *its))
      result.push_back(facet);
  });
  return result;
}

/// The facets of `surface` that lie off `other`, as a part of their own; null when none do.
std::shared_ptr<const part_geometry> off(const client::surface_model& surface,
                                         const client::surface_model& other) {
  auto facets = unlike(surface, other);
  if (facets.empty())
    return nullptr;
  std::vector<corners> places;
  for (const auto& facet : facets)
    places.push_back(corners_of(surface, facet));
  nearness there(other, places);
  std::erase_if(facets, [&](const auto& f) { return there.holds(corners_of(surface, f)); });
  if (facets.empty())
    return nullptr;
  client::surface_update all;
  all.version_id = surface.version_id();
  for (const auto& facet : facets) {
    all.facets.push_back(static_cast<std::uint32_t>(all.facets.size()));
    all.facet_surfaces.push_back(facet.surface);
    for (const auto v : facet.v) {
      const vec3 p = *surface.positions().find(v);
      all.facet_vertices.push_back(v);
      all.vertices.push_back(v);
      all.positions.insert(all.positions.end(), {p.x, p.y, p.z});
    }
  }
  client::surface_model model;
  return model.apply(all) ? build_part(model, {}, {}, 0) : nullptr;
}

}  // namespace

std::shared_ptr<const preview_geometry> differences_of(const client::surface_model& before,
                                                       const client::surface_model& after) {
  auto result = std::make_shared<preview_geometry>();
  result->added = off(after, before);
  result->removed = off(before, after);
  return result;
}

}  // namespace tedit::desktop
