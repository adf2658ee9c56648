// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/io/line_cursor.hpp"

namespace tedit {

/// A card of Nastran's bulk data with its continuations: field 0 is its name, in capitals and
/// without "*"; eight fields of each line follow, short lines filled up. Fields that are not there
/// read as blank.
struct bdf_card {
  std::vector<std::string> fields;
  std::size_t line = 0;

  [[nodiscard]] const std::string& name() const { return fields[0]; }
  [[nodiscard]] std::size_t size() const { return fields.size(); }
  /// Blank where there is none.
  [[nodiscard]] std::string_view at(std::size_t i) const {
    return i < fields.size() ? std::string_view(fields[i]) : std::string_view();
  }
};

/// Whether the line is one of the comments, which begin with "$".
[[nodiscard]] bool is_bdf_comment(std::string_view line);

/// The card at the cursor's line, in free (commas), small (8 characters) or large fields ("*"
/// behind the name, 16 characters). Goes on over its continuations; comments between them are
/// skipped.
[[nodiscard]] bdf_card read_bdf_card(line_cursor& in);

}  // namespace tedit
