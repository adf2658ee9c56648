// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/command.hpp"

namespace tedit::cli {

/// The CAD model of a document's version as a STEP file.
struct step_options {
  std::string document;
  std::string output;
  std::optional<std::uint32_t> version;  ///< The current one without it.
};

/// By its suffix.
[[nodiscard]] bool is_step(const std::string& file);

struct written_step {
  std::uint32_t version = 0;
  std::size_t solids = 0;
  std::size_t faces = 0;
  double deviation_m = 0;  ///< Of the mesh from the model, at most.
};

/// Writes the file. Errors: `usage` for what is no document, `not_found` for a part without a CAD
/// model and for an edit that is in the mesh only; those of `read_part` and `cad::write_step`.
[[nodiscard]] expected<written_step> export_step_file(const step_options& options,
                                                      const execution& run);

/// The same as a command. Returns the exit status.
int run_export_step(const step_options& options, session& s);

}  // namespace tedit::cli
