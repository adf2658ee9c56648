// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mesh/io/file.hpp"
#include "mesh/vec3.hpp"

namespace tedit {

/// A named array of `components` values per point or cell.
struct vtu_array {
  std::string name;
  int components = 1;
  std::span<const double> values;
};

/// Whole numbers that belong to the file, not to its points or cells.
struct vtu_numbers {
  std::string name;
  int components = 1;
  std::span<const std::int64_t> values;
};

/// An unstructured grid of one cell type, as VTU holds it.
struct vtu_grid {
  std::span<const vec3> points;
  std::span<const std::uint32_t> cells;  ///< Point indices, `nodes_per_cell` each.
  int nodes_per_cell = 4;                ///< 3: triangles, 4: tets, 10: quadratic tets.
  std::vector<vtu_array> point_data;
  std::vector<vtu_array> cell_data;
  std::vector<std::pair<std::string, std::string>> notes;  ///< Text field data.
  std::vector<vtu_numbers> numbers = {};
  /// As bytes with a zero behind each text: not every program that reads VTU knows texts.
  std::vector<std::pair<std::string, std::vector<std::string>>> texts = {};
};

/// Writes VTU with raw appended data and 64-bit headers; doubles stay doubles. Errors: `io_error`.
[[nodiscard]] expected<void> write_vtu(const file_target& to, const vtu_grid& grid);

}  // namespace tedit
