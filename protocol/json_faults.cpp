// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/json_faults.hpp"

#include <algorithm>
#include <optional>
#include <regex>
#include <utility>

namespace tedit::protocol {

namespace {

std::string line_and_column(std::string_view json, std::size_t at) {
  const auto before = json.substr(0, at);
  const auto line = 1 + std::ranges::count(before, '\n');
  const auto begin = before.rfind('\n');
  const auto column = begin == before.npos ? at + 1 : at - begin;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// The parser's words, the letters around the place, and a line with ^ below them.
struct shown_letters {
  std::string words;
  std::string_view letters;
  std::size_t mark = 0;  ///< Place of ^ among the letters.
};

std::optional<shown_letters> letters_in(std::string_view said) {
  const auto first = said.find('\n');
  const auto last = said.rfind('\n');
  if (first == said.npos || said.empty() || said.back() != '^')
    return std::nullopt;
  return shown_letters{std::string(said.substr(0, first)),
                       first == last ? "" : said.substr(first + 1, last - first - 1),
                       said.size() - last - 2};
}

/// What is wrong with the text as JSON.
json_fault fault_of_text(std::string_view json, const shown_letters& shown) {
  if (shown.words.find("end of string") != std::string::npos ||
      shown.words.find("Closing quote") != std::string::npos)
    return {shown.words, line_and_column(json, json.size())};
  const auto at = shown.letters.empty() ? json.npos : json.find(shown.letters);
  const bool certain = at != json.npos && json.find(shown.letters, at + 1) == json.npos;
  return {shown.words, certain ? line_and_column(json, at + shown.mark) : std::string()};
}

std::string wanted(const std::string& type) {
  if (type == "TYPE_DOUBLE" || type == "TYPE_FLOAT")
    return "a number";
  if (type == "TYPE_STRING")
    return "a text";
  if (type == "TYPE_BOOL")
    return "true or false";
  return type.starts_with("TYPE_") ? "a whole number in its range" : "an object {...}";
}

/// What is wrong with a field; `(loads[0].force) total: ...` or `(loads[0].force.x): ...`.
std::optional<json_fault> fault_of_field(const std::string& said) {
  static const std::regex form(R"(^(?:\((.*?)\))? ?(\w*): (.*)$)");
  static const std::regex value(R"(^invalid value (.*) for type (\S+)$)");
  std::smatch parts;
  if (!std::regex_match(said, parts, form))
    return std::nullopt;
  const auto path = parts[1].str();
  const auto owner = path.empty() ? std::string("it") : path;
  const auto whole = path + (path.empty() || parts[2].length() == 0 ? "" : ".") + parts[2].str();
  const auto words = parts[3].str();
  if (words.starts_with("Cannot find field"))
    return json_fault{owner + " has no field \"" + parts[2].str() + "\"", path};
  if (words.find("cannot start list") != std::string::npos)
    return json_fault{whole + " is a list, not one value", whole};
  if (words.starts_with("Root element"))
    return json_fault{"it is not an object {...}", ""};
  if (words.find("is already set") != std::string::npos)
    return json_fault{owner + " has two kinds at once", path};
  std::smatch of_value;
  if (std::regex_match(words, of_value, value))
    return json_fault{whole + " is " + of_value[1].str() + ", not " + wanted(of_value[2].str()),
                      whole};
  return std::nullopt;
}

}  // namespace

json_fault json_fault_of(std::string_view json, std::string_view said) {
  if (const auto shown = letters_in(said))
    return fault_of_text(json, *shown);
  if (said.starts_with("Message too deep"))
    return {"brackets are nested too deep", ""};
  // Regular expressions call themselves for each letter.
  constexpr std::size_t longest = 1000;
  if (said.size() <= longest)
    if (auto fault = fault_of_field(std::string(said)))
      return *std::move(fault);
  return {std::string(said), ""};
}

}  // namespace tedit::protocol
