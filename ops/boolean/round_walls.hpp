// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "mesh/box.hpp"
#include "mesh/features/fitted_form.hpp"
#include "mesh/features/known_wall.hpp"
#include "ops/boolean/remesh.hpp"
#include "ops/tools/local_size.hpp"

namespace tedit::ops {

/// The exact walls behind the surfaces of a boolean's result: those of the part, fitted to the
/// corners that it has there, and the tool's own. Each is fitted when it is first asked for.
class round_walls {
public:
  /// @param continues as for `services::boolean_onto`.
  round_walls(const mesh_version& part, const tool_surface& tool,
              const std::vector<std::optional<surface_id>>& continues)
      : part_(part), tool_(tool), continues_(continues), near_(extent_of(tool)) {}

  struct wall {
    std::vector<exact_wall> round;    ///< None: it is flat, or of no known shape.
    std::optional<wall_shape> plane;  ///< Of a flat wall of the part: that of most of its corners.
    bool free_form = false;           ///< Of no known shape.

    /// The one that a point is nearest to; null where there is none.
    [[nodiscard]] const exact_wall* nearest(vec3 p) const;
  };

  /// Interfaces are of no known shape. Cost: that of a fit, once a surface.
  [[nodiscard]] const wall& behind(const surface_labels& labels, std::int32_t label);

  /// Is all of a surface of the part on known round walls? Cost: the same.
  [[nodiscard]] bool is_round(surface_id id) {
    const auto& wall = of_part(id);
    return !wall.round.empty() && !wall.free_form;
  }

  /// Are all round walls of some of the part's facets those of the CAD model, none fitted? Cost:
  /// the same, of the facets' surfaces.
  [[nodiscard]] bool are_known(const std::vector<facet_id>& facets);

  /// What each face of the tool is said to stand for, or by its corners does; none of flat ones of
  /// which nothing is said. Cost: that of a fit, once a face.
  [[nodiscard]] std::vector<surface_geometry> tool_geometries();

  /// Is the middle of an edge of such a surface's facet that meets a box further than that (m) off
  /// the wall? Cost: O(1).
  [[nodiscard]] bool has_chord(surface_id id, const std::array<vec3, 3>& facet, const box& near,
                               double most_off);

private:
  const wall& of_part(surface_id id);
  const wall& of_tool(std::size_t face);
  static void add(wall& to, const facet_corners& corners, const std::optional<exact_wall>& known,
                  bool is_part);

  const mesh_version& part_;
  const tool_surface& tool_;
  const std::vector<std::optional<surface_id>>& continues_;
  box near_;  ///< The tool's: free form is fitted there alone.
  std::map<surface_id, wall> part_walls_;
  std::map<std::size_t, wall> tool_walls_;
  const wall unknown_{{}, {}, true};
};

/// Gives the triangles of a surface that is as the exact boolean left it the slack of what they are
/// a part of: by so much that chords are off their round wall. False where there is none.
/// Cost: O(triangles), and that of the fits.
bool give_slack(labelled_surface& surface, const cavity& hollow, const corefined& cut,
                const tool_surface& tool, round_walls& walls);

/// Does the tool have facets of the part for faces that continue a surface, so that it moves walls?
/// @param near all live facets that meet the tool's box.
[[nodiscard]] bool moves_walls(const mesh_version& part, const tool_surface& tool,
                               const std::vector<std::optional<surface_id>>& continues,
                               const std::vector<facet_id>& near);

}  // namespace tedit::ops
