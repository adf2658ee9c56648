// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "mesh/features/exact_wall.hpp"
#include "mesh/quality.hpp"
#include "mesh/version.hpp"

namespace tedit::cli {

/// What `tedit info` says about a version.
struct mesh_report {
  struct surface_row {
    surface_id id = 0;
    std::string name;
    std::size_t facets = 0;  ///< Boundary facets; interface triangles are counted apart.
    std::size_t interface_facets = 0;
    double area_m2 = 0;
    /// What its boundary facets lie on; nothing for free forms and interfaces.
    std::optional<exact_wall> shape;
  };
  struct region_row {
    region_id id = 0;
    std::string name;
    std::size_t tets = 0;
    double volume_m3 = 0;
  };

  std::vector<surface_row> surfaces;
  std::vector<region_row> regions;
  double volume_m3 = 0;
  vec3 size_m;            ///< Extents of the bounding box.
  value_summary quality;  ///< Radius ratio q = 3 r_in/R_circ in [0,1].
};

/// Cost: O(mesh).
[[nodiscard]] mesh_report make_mesh_report(const mesh_version& mesh);

/// For people: "plane", "bore, diameter 8 mm", "round, diameter 8 mm", "cone", "sphere, diameter
/// 8 mm", "torus, tube radius 2 mm", "interface", "free form".
[[nodiscard]] std::string shape_words(const mesh_report::surface_row& row);

/// The JSON object of `tedit info`.
[[nodiscard]] nlohmann::ordered_json to_json(const mesh_version& mesh, const mesh_report& report);

}  // namespace tedit::cli
