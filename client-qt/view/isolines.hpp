// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <set>
#include <span>

#include "client-qt/view/part_geometry.hpp"

namespace tedit::desktop {

/// Lines on the part where its values are one of the levels: straight in each triangle. `values`:
/// one for each point of the part; a triangle with one that is not finite has none, nor has a
/// hidden surface. On any thread. Cost: O(triangles * levels).
[[nodiscard]] vtkSmartPointer<vtkPolyData> make_isolines(const part_geometry& part,
                                                         std::span<const float> values,
                                                         std::span<const double> levels,
                                                         const std::set<surface_id>& hidden);

/// The same on all triangles of a mesh, as of a section.
[[nodiscard]] vtkSmartPointer<vtkPolyData> make_isolines(vtkPolyData& mesh,
                                                         std::span<const float> values,
                                                         std::span<const double> levels);

}  // namespace tedit::desktop
