// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace tedit::cad {

enum class file_kind { step, iges, brep };

/// "step", "iges", "brep": as the reader is told.
[[nodiscard]] std::string_view name_of(file_kind kind);

/// What a CAD file is, by its bytes, not its name. Errors: `io_error` for one that cannot be read;
/// `bad_input` for one that is empty; `unsupported_format` saying what it looks like instead.
/// Cost: reads its first bytes.
[[nodiscard]] expected<file_kind> kind_of(const std::filesystem::path& file);

/// Other files that a STEP file says hold its geometry, as it names them, each once. Cost:
/// O(bytes).
[[nodiscard]] std::vector<std::string> files_referred_to(std::string_view step);

}  // namespace tedit::cad
