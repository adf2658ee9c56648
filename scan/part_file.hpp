// SPDX-License-Identifier: AGPL-3.0-or-later
// Files of parts that are no meshes yet: the one way in, of commands and of the server.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cad/import.hpp"

namespace tedit::scan {

struct part_file_request {
  std::filesystem::path file;
  std::string unit = {};  ///< Of an STL, OBJ or PLY: "mm", "cm", "m", "in", "inch"; empty: mm.
  std::string size = "medium";  ///< "coarse", "medium", "fine": docs/cad.md, *Sizes*.
  std::vector<cad::local_size> local_sizes = {};  ///< Of a CAD file.
  cad::program_limits limits = {};                ///< Of each of the programs.
};

/// A part that came from CAD or from a surface without CAD.
struct file_part {
  cad::imported_part part;
  /// How far the mesh is off the file's surface at most, m; none for CAD.
  std::optional<double> deviation_m;
  double repair_ms = 0;  ///< Mending thin tets: cad/repair.hpp.

  /// What a document keeps of CAD: of a surface file nothing.
  [[nodiscard]] std::optional<cad::cad_model> model() const {
    return deviation_m ? std::nullopt : std::optional(part.model);
  }
};

/// Reads a file with a part, whichever its bytes say it is, meshes it and mends its thin tets. What
/// is no surface is taken for CAD, whose reader says what is wrong with it. Errors: those of
/// `cad::import_part` and `import_surface`; `invalid_argument` for a unit of a CAD file and for
/// local sizes of a surface.
[[nodiscard]] expected<file_part> import_part_file(const part_file_request& request,
                                                   const execution& run);

}  // namespace tedit::scan
