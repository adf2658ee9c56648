// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/version.hpp"

namespace tedit {

/// What became of a surface in an edit.
enum class surface_fate {
  kept,         ///< Same facets, same area.
  changed,      ///< Still there, facets or area differ.
  added,        ///< New id.
  removed,      ///< No facet left.
  merged_into,  ///< No facet left; the area went to surface `other`.
  split_from    ///< New id whose facets belonged to surface `other`.
};

[[nodiscard]] std::string_view fate_name(surface_fate fate) noexcept;

struct surface_change {
  surface_id id = 0;
  surface_fate fate = surface_fate::kept;
  surface_id other = 0;  ///< Only for merged_into and split_from.
  std::string name;
  double area_before = 0;  ///< m^2; 0 when it was not there.
  double area_after = 0;   ///< m^2; 0 when it is gone.
};

/// Compares two versions; `kept` rows are left out. Derived from the facets, never from what an
/// operation claims. Cost: O(facets in dirty pages + touched surfaces' facets).
[[nodiscard]] std::vector<surface_change> compare_surfaces(const mesh_version& before,
                                                           const mesh_version& after);

}  // namespace tedit
