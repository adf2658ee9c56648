// SPDX-License-Identifier: AGPL-3.0-or-later
// What passes between the two programs of `tedit import` for files without CAD, beside what
// cad/exchange.hpp says: the reader's surface.
#pragma once

#include <filesystem>
#include <vector>

#include "base/error.hpp"
#include "mesh/segment/segment.hpp"

namespace tedit::scan {

inline constexpr const char* surface_file = "part.surface";  ///< The reader's.

/// The closed surface of a file, mended, in mm. Its patches are the faces of `cad::part_facts`, in
/// the same order.
struct surface_part {
  triangle_surface surface;
  std::vector<std::uint32_t> patch_of;  ///< Of each triangle.
  std::vector<fitted_shape> shapes;     ///< Of each patch.
  std::vector<std::uint32_t> solid_of;  ///< Of each patch.
};

[[nodiscard]] bool save_surface(const surface_part& part, const std::filesystem::path& folder);
/// Errors: `io_error`, `internal` for a file that no reader wrote.
[[nodiscard]] expected<surface_part> load_surface(const std::filesystem::path& folder);

/// How far the second set of triangles goes off the first one at most: at its corners, the middles
/// of its edges and its own. Cost: O(n log n).
[[nodiscard]] double largest_distance(const triangle_surface& from, const triangle_surface& to);

}  // namespace tedit::scan
