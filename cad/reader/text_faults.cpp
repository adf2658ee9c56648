// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/reader/text_faults.hpp"

#include <algorithm>
#include <cctype>
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

/// nan, -inf, Infinity, 1.#QNAN: as programs print what is no number.
bool is_no_number(std::string_view word) {
  if (word.find(".#") != word.npos)
    return true;
  if (word.starts_with('-') || word.starts_with('+'))
    word.remove_prefix(1);
  std::string lower(word.substr(0, 9));
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return lower.starts_with("nan") ? word.size() == 3 || word[3] == '('
                                  : lower == "inf" || lower == "infinity";
}

/// The first such word between blanks, commas and parentheses, outside of quotes and comments.
std::optional<std::string_view> first_no_number(std::string_view text, bool has_quotes) {
  constexpr std::string_view between = " \t\r\n,;()=";
  for (std::size_t at = 0; at < text.size();) {
    if (has_quotes && text[at] == '\'') {
      at = std::min(text.find('\'', at + 1), text.size() - 1) + 1;
      continue;
    }
    if (has_quotes && text.substr(at, 2) == "/*") {
      at = std::min(text.find("*/", at + 2), text.size() - 2) + 2;
      continue;
    }
    if (between.find(text[at]) != between.npos) {
      ++at;
      continue;
    }
    const auto end =
      std::min(text.find_first_of(has_quotes ? " \t\r\n,;()='" : between, at + 1), text.size());
    if (const auto word = text.substr(at, end - at); is_no_number(word))
      return word;
    at = end;
  }
  return std::nullopt;
}

}  // namespace

expected<void> check_finite(const std::string& kind, const std::string& file) {
  std::error_code code;
  if (const auto bytes = std::filesystem::file_size(file, code); code || bytes > largest_text)
    return {};
  const auto text = text_of(file);
  const auto found = kind == "iges" ? std::nullopt : first_no_number(text, kind == "step");
  if (!found)
    return {};
  const auto before =
    std::string_view(text).substr(0, static_cast<std::size_t>(found->data() - text.data()));
  const auto place = line_of(file, 1 + static_cast<std::size_t>(std::ranges::count(before, '\n')));
  if (auto told = fault_of_text(kind, file);
      told && (told->where == place || told->where.starts_with(place + ",")))
    return fail(std::move(*told));
  return fail(ec::bad_input,
              "a finite number must be here, and not " + std::string(found->substr(0, 20)),
              "Export the part again from the CAD program", place);
}

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
