// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cad/model.hpp"
#include "cad/program.hpp"
#include "mesh/version.hpp"

namespace tedit::cad {

/// Shorter edges on some of a CAD part's surfaces.
struct local_size {
  std::string surface;  ///< A number, or a name that one face or several have.
  double mm = 0;        ///< The longest edge there.
};

struct import_request {
  std::filesystem::path file;
  std::string size = "medium";  ///< "coarse", "medium", "fine": docs/cad.md, *Sizes*.
  std::vector<local_size> local_sizes = {};
  program_limits limits;  ///< Of each of the two programs.
};

/// A part that came from CAD. Surface ids are the CAD faces' places, from 1, or those that a file
/// of TEdit's own says they have; region ids are the solids' places; names are theirs.
struct imported_part {
  version_ptr version;
  cad_model model;
  mesh_report report;
  std::vector<std::string> warnings;  ///< What a person should know, one sentence each.
  double read_ms = 0;                 ///< OpenCASCADE: reading, and joining solids.
  double mesh_ms = 0;                 ///< Gmsh, and building the version.
};

/// Reads a STEP, IGES or BREP file and meshes its solids, each in a confined process of its own
/// that may die: a file costs its import and nothing else. A STEP file whose reader dies is read
/// once more without annotations. Errors: `io_error`, `bad_input`, `unsupported_format`,
/// `mesher_failed`, `timeout`, `out_of_memory`, `cancelled`, `service_unavailable`; those of a
/// program that died say what it was doing.
[[nodiscard]] expected<imported_part> import_part(const import_request& request,
                                                  const execution& run);

/// The first half: the CAD model without a mesh. Errors: as `import_part`.
[[nodiscard]] expected<cad_model> read_model(const import_request& request, const execution& run);

}  // namespace tedit::cad
