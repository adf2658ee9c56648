// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>
#include <QTemporaryDir>

#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/execution.hpp"

namespace tedit::desktop {

/// Whether a file is one of CAD, by its suffix: STEP, IGES or BREP.
[[nodiscard]] bool is_cad_file(const QString& path);

/// "*.step *.stp ...": for a dialog.
[[nodiscard]] QString cad_patterns();

/// The mesh of a CAD file; its folder goes with it.
struct meshed_part {
  std::unique_ptr<QTemporaryDir> folder;
  QString mesh;                       ///< Path of a MSH file, in mm.
  std::vector<std::string> warnings;  ///< What a person should know, one sentence each.
};

/// Meshes a CAD file by this installation's "tedit import": on this computer, whichever server the
/// window works with, in processes that may die. `size`: "coarse", "medium" or "fine". It waits:
/// for a thread of work. Errors: those that the program says; `cancelled`; `service_unavailable`
/// where it does not start.
[[nodiscard]] expected<meshed_part> mesh_cad_file(const QString& file, const QString& size,
                                                  const execution& run);

}  // namespace tedit::desktop
