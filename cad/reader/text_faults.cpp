// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/reader/text_faults.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string_view>

namespace tedit::cad {

namespace {

std::string text_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string line_of(const std::string& file, std::size_t line) {
  return file + ", line " + std::to_string(line);
}

/// What a count of a BREP file stands behind.
bool is_counted(std::string_view word) {
  for (const std::string_view one :
       {"Locations", "Curve2ds", "Curves", "Polygon3D", "Polygons", "PolygonOnTriangulations",
        "Surfaces", "Triangulations", "TShapes"})
    if (word == one)
      return true;
  return false;
}

}  // namespace

error step_fault(const std::string& file) {
  error why{ec::bad_input, "the STEP file cannot be read: its text is damaged or cut off",
            "Export it again from the CAD program", file};
  const auto text = text_of(file);
  const auto last = text.find_last_not_of(" \t\r\n");
  if (last == std::string::npos || text.find("END-ISO-10303-21") != std::string::npos)
    return why;
  std::size_t line = 1;
  for (const char c : std::string_view(text).substr(0, last + 1))
    line += c == '\n';
  why.message = "the STEP file is cut off: it ends without END-ISO-10303-21";
  why.where = line_of(file, line);
  return why;
}

expected<void> check_brep_counts(const std::string& file) {
  const auto text = text_of(file);
  std::string_view rest(text);
  for (std::size_t line = 1; !rest.empty(); ++line) {
    const auto one = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), one.size() + 1));
    const auto blank = one.find(' ');
    if (blank == one.npos || !is_counted(one.substr(0, blank)))
      continue;
    const auto number = one.substr(blank + 1);
    unsigned long long count = 0;
    const auto code = std::from_chars(number.data(), number.data() + number.size(), count).ec;
    // Each takes a letter and a blank at least.
    if (code != std::errc() || count > rest.size() / 2 + 1)
      return fail(ec::bad_input,
                  "the BREP file says that it has " + std::string(number.substr(0, 24)) + " " +
                    std::string(one.substr(0, blank)) + ", more than the " +
                    std::to_string(rest.size()) + " bytes behind can hold",
                  "It is cut off or damaged: write it again, or take a STEP file",
                  line_of(file, line));
  }
  return {};
}

}  // namespace tedit::cad
