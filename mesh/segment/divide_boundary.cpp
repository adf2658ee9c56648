// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/segment/divide_boundary.hpp"

#include <algorithm>

#include "mesh/boundary_patches.hpp"
#include "mesh/segment/segment.hpp"

namespace tedit {

namespace {

/// The rows of the surfaces that were made.
std::vector<surface_info> divide(std::vector<boundary_facet>& facets,
                                 const std::vector<vec3>& positions) {
  triangle_surface surface;
  std::vector<std::uint32_t> place(positions.size(), no_id);
  for (const auto& facet : facets) {
    auto& corners = surface.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      auto& at = place[facet.v[k]];
      if (at == no_id) {
        at = static_cast<std::uint32_t>(surface.points.size());
        surface.points.push_back(positions[facet.v[k]]);
      }
      corners[k] = at;
    }
  }
  const auto found = segment_surface(surface, limits_for(surface));
  for (std::size_t f = 0; f < facets.size(); ++f)
    facets[f].surface = surface_id{found.patch_of[f]} + 1;
  constexpr double mm_per_metre = 1e3;
  std::vector<surface_info> rows;
  for (std::size_t i = 0; i < found.shapes.size(); ++i) {
    const auto id = static_cast<surface_id>(i + 1);
    rows.push_back({id, name_of(found.shapes[i], id, mm_per_metre)});
  }
  return rows;
}

}  // namespace

std::string give_missing_surfaces(raw_mesh& raw, std::vector<boundary_facet>& facets,
                                  const std::vector<bool>& has_surface) {
  const auto missing = static_cast<std::size_t>(std::ranges::count(has_surface, false));
  if (missing == 0)
    return {};
  const auto sentence = std::to_string(missing) + " boundary faces had no surface id; they got ";
  const auto says_one = [](const raw_mesh::triangle& one) { return one.has_surface; };
  if (missing == facets.size() && std::ranges::none_of(raw.triangles, says_one)) {
    raw.surface_names = divide(facets, raw.positions);
    return sentence + std::to_string(raw.surface_names.size()) +
           " new surfaces: planes, cylinders, cones, spheres and free forms";
  }
  surface_id largest = 0;
  for (const auto& triangle : raw.triangles)
    largest = std::max(largest, triangle.surface);
  const auto made = assign_missing_surfaces(facets, has_surface, raw.positions, largest);
  return sentence + (made.empty() ? "those of the faces around"
                                  : std::to_string(made.size()) +
                                      " new surfaces, split at edges sharper than 30 degrees");
}

}  // namespace tedit
