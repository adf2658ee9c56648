// SPDX-License-Identifier: AGPL-3.0-or-later
// Surfaces without CAD as parts: docs/scans.md.
#pragma once

#include "cad/import.hpp"
#include "scan/exchange.hpp"

namespace tedit::scan {

struct import_request {
  std::filesystem::path file;
  std::string kind;  ///< As `kind_of` says.
  std::string unit;  ///< Of coordinates where the file says none: "mm", "cm", "m", "in"; empty: mm.
  std::string size = "medium";  ///< "coarse", "medium", "fine": docs/cad.md, *Sizes*.
  cad::program_limits limits;   ///< Of each of the two programs.
};

/// A part that came from a surface file. Its `model` has facts of surfaces and regions, and no
/// shape. Several patches of one group are one surface.
struct imported_surface {
  cad::imported_part part;
  surface_part file;  ///< The file's surface, mended, in mm.
};

/// Reads a closed surface, mends and divides it, and fills it with tets, in two confined processes
/// that may die: a file costs its import and nothing else. Errors: `io_error`, `bad_input`,
/// `non_manifold`, `unsupported_format`, `mesher_failed`, `timeout`, `out_of_memory`, `cancelled`,
/// `service_unavailable`, with the place in the file or in space.
[[nodiscard]] expected<imported_surface> import_surface(const import_request& request,
                                                        const execution& run);

/// How far the boundary of a part's mesh is off the file's surface at most, m. Cost: O(n log n).
[[nodiscard]] double deviation_of(const mesh_version& mesh, const surface_part& file);

}  // namespace tedit::scan
