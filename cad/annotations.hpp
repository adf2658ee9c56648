// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace tedit::cad {

/// Whether an entity of a STEP file is an annotation: a tolerance, a datum, a dimension's note, a
/// drawing's callout. Nothing of a part's shape, names or colours is one.
[[nodiscard]] bool is_annotation(std::string_view entity_type);

struct plain_step {
  std::string text;
  std::size_t left_out = 0;
};

/// The text of a STEP file with a point in the place of each annotation: its number stays in use,
/// so that what refers to it finds something. Text in quotes and comments is left alone.
/// Cost: O(bytes).
[[nodiscard]] plain_step without_annotations(std::string_view step);

/// The same from file to file: how many were left out. Errors: `io_error`.
[[nodiscard]] expected<std::size_t> write_without_annotations(const std::filesystem::path& from,
                                                              const std::filesystem::path& to);

}  // namespace tedit::cad
