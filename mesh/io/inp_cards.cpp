// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/inp_cards.hpp"

namespace tedit {

std::string inp_keyword::value(const std::string& parameter) const {
  const auto found = parameters.find(parameter);
  return found == parameters.end() ? std::string() : found->second;
}

std::string inp_keyword::upper_value(const std::string& parameter) const {
  return upper(value(parameter));
}

bool is_comment_line(std::string_view line) {
  return trimmed(line).starts_with("**");
}

bool is_keyword_line(std::string_view line) {
  const auto text = trimmed(line);
  return text.starts_with('*') && !text.starts_with("**");
}

std::vector<std::string_view> fields_of_line(std::string_view line) {
  std::vector<std::string_view> result;
  while (!trimmed(line).empty()) {
    const auto comma = line.find(',');
    result.push_back(trimmed(line.substr(0, comma)));
    if (comma == line.npos)
      break;
    line.remove_prefix(comma + 1);
  }
  return result;
}

std::string plain_name(std::string_view name) {
  name = trimmed(name);
  if (name.size() >= 2 && name.front() == '"' && name.back() == '"')
    return std::string(name.substr(1, name.size() - 2));
  const auto dot = name.rfind('.');
  return std::string(dot == name.npos ? name : name.substr(dot + 1));
}

inp_keyword read_keyword(line_cursor& in) {
  std::string text(trimmed(in.line()));
  inp_keyword result;
  result.line = in.number();
  while (text.ends_with(',') && in.next()) {
    if (is_keyword_line(in.line()) || is_comment_line(in.line())) {
      in.back();
      break;
    }
    text += trimmed(in.line());
  }
  const auto fields = fields_of_line(text);
  for (const auto c : upper(fields[0].substr(1)))
    if (c != ' ' && c != '\t')
      result.name += c;
  for (std::size_t i = 1; i < fields.size(); ++i) {
    const auto equals = fields[i].find('=');
    const auto name = upper(trimmed(fields[i].substr(0, equals)));
    const auto value =
      equals == std::string_view::npos ? std::string_view() : trimmed(fields[i].substr(equals + 1));
    // A dot parts a name from its instance, a file's from its suffix.
    result.parameters[name] =
      name == "INPUT" || name == "FILE" ? std::string(value) : plain_name(value);
  }
  return result;
}

}  // namespace tedit
