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

/// Returns the exit status.
int run_export_step(const step_options& options, session& s);

}  // namespace tedit::cli
