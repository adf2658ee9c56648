// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>

#include "mesh/adapt/adapt_mesh.hpp"
#include "mesh/box.hpp"
#include "mesh/features/fitted_form.hpp"
#include "mesh/features/known_wall.hpp"

namespace tedit {

/// Is a wall whose corners lie on a cylinder, cone, sphere or torus meant to be one? Those of a
/// hexagon do, too.
using round_test = std::function<bool(surface_id)>;

/// The walls behind a version's surfaces: planes, cylinders, cones, spheres, tori and smooth free
/// form, each fitted when it is first asked for.
class wall_places {
public:
  /// @param is_round which walls may be taken for cylinders, cones, spheres or tori; all where it
  /// is empty.
  /// @param near free form is fitted there alone; else everywhere.
  explicit wall_places(const mesh_version& mesh, round_test is_round = {},
                       const std::optional<box>& near = {})
      : mesh_(mesh), is_round_(std::move(is_round)), near_(near) {}

  /// Where the middle of an edge of the skin belongs: on all the walls whose triangles meet there,
  /// but for those of which nothing is known. The middle itself where they are flat or no such
  /// point is near.
  /// Cost: a fit of each surface once; else O(walls).
  [[nodiscard]] vec3 middle(vec3 a, vec3 b, std::span<const surface_id> walls);

  /// m: how far a point is off the wall; 0 where nothing is known of it. Cost: the same.
  [[nodiscard]] double off(surface_id wall, vec3 p);

private:
  /// Nothing for free form of which nothing is known.
  const std::optional<exact_wall>& wall_of(surface_id id);

  [[nodiscard]] std::optional<exact_wall> find_wall(surface_id id) const;

  const mesh_version& mesh_;
  round_test is_round_;
  std::optional<box> near_;
  std::map<surface_id, std::optional<exact_wall>> walls_;
};

/// How many vertices of the changed tets that were not there before lie off the walls of the
/// version before, further than a ten thousandth of the edges there. Cost: O(changed), and the
/// fits.
[[nodiscard]] std::size_t count_off_walls(const mesh_version& before, const mesh_version& after,
                                          std::span<const tet_id> changed);

}  // namespace tedit
