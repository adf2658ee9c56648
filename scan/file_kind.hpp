// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace tedit::scan {

/// What a surface file is: "stl", "obj", "ply" or "3mf", by its bytes; one that they do not tell,
/// as where it is cut off, by its name. Nothing for any other file, or one that cannot be read.
/// Cost: O(bytes).
[[nodiscard]] std::optional<std::string> kind_of(const std::filesystem::path& file);

}  // namespace tedit::scan
