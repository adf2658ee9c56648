// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/reader/text_faults.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace tedit::cad {

namespace {

constexpr std::uintmax_t largest_text = std::uintmax_t{1} << 30;

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

std::optional<error> fault_of_text(const std::string& kind, const std::string& file) {
  std::error_code code;
  if (const auto bytes = std::filesystem::file_size(file, code); code || bytes > largest_text)
    return std::nullopt;
  const auto text = text_of(file);
  const auto fault = kind == "step"   ? fault_of_step(text)
                     : kind == "iges" ? fault_of_iges(text)
                                      : fault_of_brep(text);
  if (!fault)
    return std::nullopt;
  const auto before = std::string_view(text).substr(0, fault->at);
  const auto line = 1 + static_cast<std::size_t>(std::ranges::count(before, '\n'));
  return error{ec::bad_input, fault->cause, fault->remedy,
               line_of(file, line) + (fault->entity.empty() ? "" : ", " + fault->entity)};
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
