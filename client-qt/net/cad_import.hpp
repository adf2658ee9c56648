// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>
#include <QTemporaryDir>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/execution.hpp"

namespace tedit::desktop {

/// Whether a file is one of CAD, by its suffix: STEP, IGES or BREP.
[[nodiscard]] bool is_cad_file(const QString& path);

/// Whether a file is a surface without CAD, by its suffix: STL, OBJ, PLY or 3MF.
[[nodiscard]] bool is_surface_file(const QString& path);

/// "*.step *.stp ... *.stl": all that `mesh_cad_file` meshes, for a dialog.
[[nodiscard]] QString cad_patterns();

/// Whether a CAD model is written into a file of this name: STEP.
[[nodiscard]] bool is_step_file(const QString& path);

/// A CAD file as a document: its mesh beside its model; of a surface file the mesh alone. The
/// folder goes with it.
struct meshed_part {
  std::unique_ptr<QTemporaryDir> folder;
  QString document;                   ///< Path of the .tedit file.
  std::vector<std::string> warnings;  ///< What a person should know, one sentence each.
};

/// A CAD or surface file, and how it is meshed.
struct cad_file {
  QString path;
  QString size = "medium";  ///< "coarse", "medium", "fine".
  QString unit = "mm";      ///< Of a surface that says none: "mm", "cm", "m", "in".
  std::map<std::string, double> local_sizes_mm;  ///< Of a CAD file, by surface.
};

/// Meshes a CAD or surface file by this installation's "tedit import": on this computer, whichever
/// server the window works with, in processes that may die. It waits: for a thread of work. Errors:
/// those that the program says; `cancelled`; `service_unavailable` where it does not start.
[[nodiscard]] expected<meshed_part> mesh_cad_file(const cad_file& part_file, const execution& run);

/// Writes the CAD model of a document with all its edits as a STEP file, by "tedit export", on this
/// computer. `document`: its file's bytes. It waits. Errors: those that the program says, as where
/// an edit is in the mesh only; `io_error`, `cancelled`, `service_unavailable`.
[[nodiscard]] expected<void> write_cad_model(const std::vector<char>& document, const QString& step,
                                             const execution& run);

}  // namespace tedit::desktop
