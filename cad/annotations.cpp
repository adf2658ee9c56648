// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/annotations.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>

namespace tedit::cad {

namespace {

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Where the statement that begins at `at` ends: behind its semicolon.
std::size_t end_of_statement(std::string_view text, std::size_t at) {
  while (at < text.size()) {
    if (text[at] == '\'') {
      at = text.find('\'', at + 1);
    } else if (text.substr(at, 2) == "/*") {
      at = text.find("*/", at + 2);
    } else if (text[at] == ';') {
      return at + 1;
    }
    if (at == std::string_view::npos)
      return text.size();
    ++at;
  }
  return text.size();
}

/// Whether one of the types of "#12=TYPE(...)" or "#12=(TYPE(...)OTHER(...))" is an annotation.
bool has_annotation(std::string_view statement) {
  auto at = statement.find('=');
  if (at == std::string_view::npos)
    return false;
  int depth = 0;
  const auto first = statement.find_first_not_of(" \t\r\n", at + 1);
  const int of_types = first != std::string_view::npos && statement[first] == '(' ? 1 : 0;
  while (++at < statement.size()) {
    if (statement[at] == '\'') {
      at = std::min(statement.find('\'', at + 1), statement.size() - 1);
    } else if (statement[at] == '(') {
      ++depth;
    } else if (statement[at] == ')') {
      --depth;
    } else if (depth == of_types && is_word(statement[at])) {
      const auto begin = at;
      while (at + 1 < statement.size() && is_word(statement[at + 1]))
        ++at;
      if (is_annotation(statement.substr(begin, at + 1 - begin)))
        return true;
    }
  }
  return false;
}

}  // namespace

bool is_annotation(std::string_view entity_type) {
  constexpr std::array beginnings{
    "ANNOTATION_",         "DATUM",      "DIMENSIONAL_",           "DRAUGHTING_",
    "GEOMETRIC_TOLERANCE", "LEADER_",    "TESSELLATED_ANNOTATION", "TERMINATOR_SYMBOL",
    "TOLERANCE_",          "PLUS_MINUS_"};
  // A colour that drawings name, too, what ties the styles of a part to its shape, and units.
  constexpr std::array kept{"DRAUGHTING_PRE_DEFINED_COLOUR", "DRAUGHTING_MODEL",
                            "DIMENSIONAL_EXPONENTS"};
  if (std::ranges::find(kept, entity_type) != kept.end())
    return false;
  return entity_type.ends_with("_TOLERANCE") ||
         std::ranges::any_of(
           beginnings, [&](const char* beginning) { return entity_type.starts_with(beginning); });
}

plain_step without_annotations(std::string_view step) {
  plain_step result;
  result.text.reserve(step.size());
  for (std::size_t at = 0; at < step.size();) {
    const auto begin = std::min(step.find_first_not_of(" \t\r\n", at), step.size());
    if (step.substr(begin, 2) == "/*") {
      const auto behind = std::min(step.find("*/", begin + 2), step.size() - 2) + 2;
      result.text += step.substr(at, behind - at);
      at = behind;
      continue;
    }
    const auto end = end_of_statement(step, at);
    const auto statement = step.substr(at, end - at);
    const auto number = statement.find('#');
    const auto equals = statement.find('=');
    if (number != std::string_view::npos && equals != std::string_view::npos && number < equals &&
        has_annotation(statement)) {
      result.text += statement.substr(0, equals);
      result.text += "=CARTESIAN_POINT('',(0.,0.,0.));";
      ++result.left_out;
    } else {
      result.text += statement;
    }
    at = end;
  }
  return result;
}

expected<std::size_t> write_without_annotations(const std::filesystem::path& from,
                                                const std::filesystem::path& to) {
  std::ifstream in(from, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const auto plain = without_annotations(text);
  std::ofstream out(to, std::ios::binary);
  out << plain.text;
  if (!in || !out.flush())
    return fail(ec::io_error, "the CAD file cannot be copied without its annotations",
                "Make room on the disk of the temporary folder ($TMPDIR)");
  return plain.left_out;
}

}  // namespace tedit::cad
