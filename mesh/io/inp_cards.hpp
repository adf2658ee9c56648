// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mesh/io/line_cursor.hpp"

namespace tedit {

/// A keyword line of Abaqus and CalculiX: "*ELEMENT, TYPE=C3D4, ELSET=Part".
struct inp_keyword {
  std::string name;                               ///< In capitals, without "*": "ELEMENT".
  std::map<std::string, std::string> parameters;  ///< By name in capitals; a flag has no value.
  std::size_t line = 0;

  [[nodiscard]] bool has(const std::string& parameter) const {
    return parameters.contains(parameter);
  }
  /// Empty where it is not there.
  [[nodiscard]] std::string value(const std::string& parameter) const;
  [[nodiscard]] std::string upper_value(const std::string& parameter) const;
};

/// Whether the line is a keyword line: no data, no comment.
[[nodiscard]] bool is_keyword_line(std::string_view line);
[[nodiscard]] bool is_comment_line(std::string_view line);

/// The keyword at the cursor's line; goes on over lines that end with a comma.
[[nodiscard]] inp_keyword read_keyword(line_cursor& in);

/// The fields of a data line between commas, without blanks around them; none behind a last comma.
[[nodiscard]] std::vector<std::string_view> fields_of_line(std::string_view line);

/// A name without quotes and without the instance before its dot: "Part-1-1.Top" is "Top".
[[nodiscard]] std::string plain_name(std::string_view name);

}  // namespace tedit
