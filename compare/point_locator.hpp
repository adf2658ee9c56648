// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mesh/box_tree.hpp"
#include "mesh/version.hpp"

namespace tedit {

/// A place within a mesh: a tet and the weights of its corners, which add up to 1.
struct located_point {
  tet_id tet = no_id;
  std::array<double, 4> weights{};

  [[nodiscard]] double least() const;
};

/// A point that is outside a tet by at most this share of the tet's height there still counts as on
/// its face: boundaries that are meshed anew cut their curves otherwise.
inline constexpr double still_inside = 0.05;

/// The barycentric coordinates of a point in a tet, negative outside; nothing in one without
/// volume. Cost: O(1).
[[nodiscard]] std::optional<std::array<double, 4>> barycentric(const std::array<vec3, 4>& corners,
                                                               const vec3& p);

/// Finds points in some tets of a version.
class point_locator {
public:
  /// @pre the mesh outlives it. Cost: O(n log n) of these tets.
  point_locator(const mesh_version& mesh, std::span<const tet_id> tets);

  /// The tet in which the point lies deepest, of those equal the first one; a point that is outside
  /// all by no more than `still_inside` is put on the face. Nothing when it is farther out. Cost:
  /// O(log n).
  [[nodiscard]] std::optional<located_point> find(const vec3& p) const;

private:
  const mesh_version& mesh_;
  std::vector<tet_id> tets_;
  box_tree boxes_;
};

/// Weights below 0 become 0, the others grow so that they add up to 1 again.
void put_on_face(std::array<double, 4>& weights);

}  // namespace tedit
