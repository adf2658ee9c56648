// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/surface.hpp"
#include "client/types.hpp"

class vtkPolyData;
class vtkStaticCellLocator;

namespace tedit::desktop {

/// The boundary as it is drawn and picked. Immutable; made on any thread.
struct part_geometry {
  std::string version_id;
  vtkSmartPointer<vtkPolyData> faces;    ///< Points are doubled at sharp edges, for their normals.
  std::vector<std::uint32_t> vertices;   ///< The vertex slot of each point.
  std::vector<float> areas;              ///< m^2 that each point stands for: a third of its faces.
  std::vector<surface_id> cell_surface;  ///< Ascending.
  std::vector<facet_id> cell_facet;      ///< The facet slot of each cell.
  std::map<surface_id, std::pair<std::int64_t, std::int64_t>> cells;  ///< First, past the last.
  vtkSmartPointer<vtkPolyData> edges;  ///< Between surfaces, and sharp ones inside.
  vtkSmartPointer<vtkStaticCellLocator> locator;
  std::array<double, 6> bounds{};  ///< m: x low, x high, y low, ...
};

/// A point of the surface under the pointer.
struct picked_point {
  surface_id surface = 0;
  vec3 at;      ///< m, as drawn.
  vec3 normal;  ///< Of the triangle, outward, unit.
  std::int64_t cell = 0;
  std::array<std::uint32_t, 3> vertices{};  ///< Of the triangle's vertices.
  std::array<double, 3> weights{};          ///< Barycentric.
};

/// Makes the geometry, moved by `scale` times the displacement when there is one.
/// Cost: O(facets log facets); 0.1 s for 80 000.
[[nodiscard]] std::shared_ptr<const part_geometry> build_part(
  const client::surface_model& surface, const std::vector<std::uint32_t>& displaced,
  const std::vector<float>& displacement, double scale);

/// The first point on the way from `from` to `to`, m.
[[nodiscard]] std::optional<picked_point> pick(const part_geometry& part, const vec3& from,
                                               const vec3& to);

/// A section as a mesh, moved by `scale` times its displacement. Cost: O(its points).
[[nodiscard]] vtkSmartPointer<vtkPolyData> make_cap(const client::section& cut, double scale);

/// The triangles of some surfaces as a mesh of their own. Cost: O(those triangles).
[[nodiscard]] vtkSmartPointer<vtkPolyData> extract(const part_geometry& part,
                                                   const std::vector<surface_id>& wanted);

/// The lines around some surfaces: edges that only one of their triangles has. On the points of the
/// part. Cost: O(those triangles).
[[nodiscard]] vtkSmartPointer<vtkPolyData> outline(const part_geometry& part,
                                                   const std::vector<surface_id>& wanted);

}  // namespace tedit::desktop
