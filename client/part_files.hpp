// SPDX-License-Identifier: AGPL-3.0-or-later
// Files that hold a part and no mesh of it: what `client::import_part` and "tedit import" take.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>

namespace tedit::client {

// Suffixes, in lower case, without the dot.
inline constexpr std::array<std::string_view, 5> cad_suffixes{"step", "stp", "iges", "igs", "brep"};
inline constexpr std::array<std::string_view, 4> surface_suffixes{"stl", "obj", "ply", "3mf"};

/// Whether a file is one of CAD, by its suffix.
[[nodiscard]] bool is_cad_file(const std::filesystem::path& file);

/// Whether a file is a surface without CAD, by its suffix.
[[nodiscard]] bool is_surface_file(const std::filesystem::path& file);

}  // namespace tedit::client
