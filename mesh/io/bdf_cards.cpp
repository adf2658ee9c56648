// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/bdf_cards.hpp"

#include <algorithm>

namespace tedit {

namespace {

constexpr std::size_t most_empty_lines = 100;  ///< Of one card, behind each other.

/// Tabs go to the next column that is a multiple of eight.
std::string without_tabs(std::string_view line) {
  constexpr std::size_t longest_line = 4096;
  std::string result;
  for (const char c : line.substr(0, longest_line)) {
    if (c == '$')
      break;  // A comment behind the fields.
    if (c != '\t') {
      result += c;
      continue;
    }
    do
      result += ' ';
    while (result.size() % 8 != 0);
  }
  return result;
}

/// The fields of one line behind its first, and that first.
struct line_fields {
  std::string first;
  std::vector<std::string> data;
  bool is_large = false;
};

std::vector<std::string> between_commas(std::string_view line) {
  std::vector<std::string> result;
  for (;;) {
    const auto comma = line.find(',');
    result.emplace_back(trimmed(line.substr(0, comma)));
    if (comma == line.npos)
      return result;
    line.remove_prefix(comma + 1);
  }
}

line_fields fields_of(std::string_view raw) {
  const auto line = without_tabs(raw);
  line_fields result;
  if (line.find(',') != std::string::npos) {
    auto fields = between_commas(line);
    result.first = upper(fields[0]);
    result.is_large = result.first.find('*') != std::string::npos;
    // The field behind the data is the mark of the continuation.
    const std::size_t most = result.is_large ? 4 : 8;
    for (std::size_t i = 1; i < fields.size() && i <= most; ++i)
      result.data.push_back(std::move(fields[i]));
    result.data.resize(most);
    return result;
  }
  result.first = upper(trimmed(line.substr(0, std::min<std::size_t>(8, line.size()))));
  result.is_large = result.first.find('*') != std::string::npos;
  const std::size_t width = result.is_large ? 16 : 8;
  for (std::size_t i = 8; i < 72; i += width)
    result.data.emplace_back(i < line.size() ? trimmed(std::string_view(line).substr(i, width))
                                             : std::string_view());
  return result;
}

bool continues(const std::string& first) {
  return first.empty() || first[0] == '+' || first[0] == '*';
}

}  // namespace

bool is_bdf_comment(std::string_view line) {
  return trimmed(line).starts_with('$');
}

bdf_card read_bdf_card(line_cursor& in) {
  auto line = fields_of(in.line());
  // A decimal comma in a line of columns makes it one of commas.
  if (line.first.find(' ') != std::string::npos)
    in.fail_here(ec::bad_input,
                 "the card \"" + shown(line.first) + "\" has both columns and commas",
                 "Write decimals with a point");
  if (line.first.ends_with('*'))
    line.first.pop_back();
  bdf_card card{{std::string(trimmed(line.first))}, in.number()};
  card.fields.insert(card.fields.end(), line.data.begin(), line.data.end());
  std::size_t empty_lines = 0;
  while (in.next()) {
    if (is_bdf_comment(in.line()) || trimmed(in.line()).empty())
      continue;
    line = fields_of(in.line());
    if (!continues(line.first)) {
      in.back();
      break;
    }
    const bool is_empty =
      std::ranges::all_of(line.data, [](const std::string& field) { return field.empty(); });
    empty_lines = is_empty ? empty_lines + 1 : 0;
    // A few letters must not become fields without end.
    if (empty_lines > most_empty_lines)
      in.fail_here(ec::bad_input, "a " + shown(card.name()) + " goes on over more than " +
                                    std::to_string(most_empty_lines) + " empty lines");
    card.fields.insert(card.fields.end(), line.data.begin(), line.data.end());
  }
  return card;
}

}  // namespace tedit
