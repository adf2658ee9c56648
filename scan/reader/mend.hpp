// SPDX-License-Identifier: AGPL-3.0-or-later
// From the triangles of a file to closed, oriented shells. All lengths in mm.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "scan/reader/file_surface.hpp"

namespace tedit::scan {

/// "(1, 2, 3) mm" of a place in mm.
[[nodiscard]] std::string place_of(vec3 mm);

/// The diagonal of the box around all points.
[[nodiscard]] double extent_of(const triangle_surface& surface);

struct weld_report {
  std::size_t degenerate = 0;
  std::size_t duplicate = 0;
};

/// Makes points that lie within `tolerance` of each other one, drops those that are not used,
/// triangles that are no higher than that (with 0: those that have a corner twice), and all but one
/// of those with the same corners.
/// Deterministic. Cost: O(n log n).
weld_report weld(file_surface& read, double tolerance);

/// Whether each edge has two triangles. Cost: O(n log n).
[[nodiscard]] bool is_closed(const triangle_surface& surface);

/// What counts as the same point: two millionths of the extent, and well within the shortest edges.
[[nodiscard]] double weld_tolerance(const triangle_surface& surface);

struct sew_report {
  std::size_t merged = 0;  ///< Points at borders.
  std::size_t split = 0;   ///< Edges that had points of the other side on them.
  std::size_t filled = 0;  ///< Holes.
  double widest_mm = 0;    ///< The gap that was closed.
};

/// Closes borders: points that lie near each other are one, edges are split at points on them, and
/// loops that are shorter than a twentieth of the extent get triangles. Errors: `bad_input` for
/// loops that are longer, with the length and middle of the longest; `non_manifold` where borders
/// meet in a point. Cost: O(n log n).
[[nodiscard]] expected<sew_report> sew(file_surface& read);

/// Refuses edges with more than two triangles (`non_manifold`) with the place of the first.
[[nodiscard]] expected<void> check_edges(const triangle_surface& surface);

/// Refuses a closed surface that goes through itself (`bad_input`), with how many pairs of
/// triangles do and where the first is. Cost: O(n log n).
[[nodiscard]] expected<void> check_intersections(const triangle_surface& surface);

/// Triangles over a loop of points, in its sense; empty where there are none. Cost: cubic.
[[nodiscard]] std::vector<triangle_corners> fill_loop(const std::vector<vec3>& loop);

/// Shells, each a closed surface in one piece.
struct shell_set {
  std::vector<std::uint32_t> shell_of;  ///< Of each triangle.
  std::vector<std::uint32_t> solid_of;  ///< Of each shell: those of one solid bound it together.
  std::size_t solids = 0;
  std::size_t cavities = 0;
  std::size_t turned = 0;  ///< Triangles that looked another way than those around them.
  std::size_t inward = 0;  ///< Shells that looked inward.
};

/// Turns all triangles outward of the material, and says what lies in what: a shell within another
/// one is a cavity of it, one within that a solid again. Errors: `non_manifold` where a point has
/// several fans of triangles, or the surface has one side only. Cost: O(n log n + n shells).
[[nodiscard]] expected<shell_set> orient(triangle_surface& surface);

}  // namespace tedit::scan
