// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "mesh/box_tree.hpp"
#include "scan/exchange.hpp"

namespace tedit::scan {

/// The nearest point of a triangle. Cost: O(1).
[[nodiscard]] vec3 nearest_on_triangle(vec3 p, vec3 a, vec3 b, vec3 c);

/// Edges of the surface where patches meet, or where one has an edge within: by the places of its
/// corners, the lower one first.
using edge_key = std::pair<std::uint32_t, std::uint32_t>;
[[nodiscard]] inline edge_key key_of(std::uint32_t a, std::uint32_t b) {
  return std::minmax(a, b);
}

/// Triangles or segments among which the nearest to a point is found.
class piece_set {
public:
  /// @param pieces: three corners each; a segment has its second one twice.
  explicit piece_set(std::vector<std::array<vec3, 3>> pieces);

  /// The nearest point, and its piece. `guess`: how far it may be; it is looked for further off
  /// where there is none. Cost: O(log n + those about as near).
  [[nodiscard]] std::pair<vec3, std::size_t> nearest(vec3 p, double guess) const;

private:
  std::vector<std::array<vec3, 3>> pieces_;
  box_tree tree_;
};

/// What vertices of a new mesh lie on: the shapes of the file's patches where they are known, else
/// its triangles; between patches, its edges.
class ground {
public:
  /// `part` must outlive this. Cost: O(n log n).
  explicit ground(const surface_part& part);

  [[nodiscard]] vec3 on_patch(vec3 p, std::uint32_t patch, double guess) const;
  /// On the line between two patches, or on an edge within one (twice the same): on both of their
  /// shapes where these cross.
  [[nodiscard]] vec3 on_line(vec3 p, std::uint32_t a, std::uint32_t b, double guess) const;

  /// The radius of the patch there, `HUGE_VAL` where it is flat.
  [[nodiscard]] double radius_at(vec3 p, std::uint32_t patch, double guess) const;

  /// Edges within a patch that bend by more than 40 degrees.
  [[nodiscard]] const std::vector<edge_key>& creases() const { return creases_; }
  [[nodiscard]] const surface_part& part() const { return part_; }

private:
  void find_lines();
  void find_radii();

  const surface_part& part_;
  std::vector<triangle_corners> across_;
  std::vector<piece_set> patches_;
  std::vector<std::vector<std::uint32_t>> triangles_of_;  ///< Of each patch.
  std::map<edge_key, piece_set> lines_;                   ///< By their patches.
  std::vector<edge_key> creases_;
  std::vector<double> radii_;  ///< Of each triangle of free form.
};

}  // namespace tedit::scan
