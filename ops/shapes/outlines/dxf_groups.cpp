// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/outlines/dxf_groups.hpp"

#include <charconv>
#include <cmath>

namespace tedit::ops {

namespace {

constexpr std::string_view binary_mark = "AutoCAD Binary DXF";
constexpr std::string_view dwg_mark = "AC10";
constexpr double most_coordinate = 1e9;

std::string_view without_mark(std::string_view bytes) {
  constexpr std::string_view utf8 = "\xef\xbb\xbf";
  return bytes.starts_with(utf8) ? bytes.substr(utf8.size()) : bytes;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Takes the next line off; nothing at the end.
std::optional<std::string_view> next_line(std::string_view& rest) {
  if (rest.empty())
    return std::nullopt;
  const auto end = rest.find('\n');
  const auto line = rest.substr(0, end);
  rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
  return trimmed(line);
}

template <class T>
std::optional<T> read_number(std::string_view text) {
  if (text.starts_with('+'))
    text.remove_prefix(1);
  T value{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

/// For people: a value of a damaged file may be of any length and any bytes.
std::string quoted(std::string_view value) {
  std::string text(value.substr(0, 20));
  for (auto& c : text)
    if (c < ' ' || c > '~')
      c = '?';
  return "\"" + text + "\"";
}

}  // namespace

bool is_drawing_file(std::string_view bytes) {
  auto rest = without_mark(bytes);
  if (rest.starts_with(binary_mark) || rest.starts_with(dwg_mark))
    return true;
  const auto code = next_line(rest);
  const auto value = next_line(rest);
  return code && value && ((*code == "0" && *value == "SECTION") || *code == "999");
}

expected<std::vector<dxf_group>> dxf_groups(const attachment& file) {
  auto rest = without_mark(file.bytes);
  if (rest.starts_with(binary_mark))
    return fail(ec::unsupported_format, file.name + " is a binary DXF, which is not read",
                "Save it as an ASCII DXF");
  if (rest.starts_with(dwg_mark))
    return fail(ec::unsupported_format, file.name + " is a DWG drawing, which is not read",
                "Save it as an ASCII DXF");
  std::vector<dxf_group> groups;
  while (const auto first = next_line(rest)) {
    const auto code = read_number<int>(*first);
    const auto line = 2 * groups.size() + 1;
    if (!code || *code < -5 || *code > 1071)
      return fail(ec::bad_input,
                  file.name + " is damaged: " + quoted(*first) + " is no code of a group",
                  "Export it again as an ASCII DXF", "line " + std::to_string(line));
    const auto value = next_line(rest);
    if (!value)
      break;
    if (*code == 0 && *value == "EOF")
      return groups;
    groups.push_back({*code, *value});
  }
  return fail(ec::bad_input, file.name + " ends early: the mark of its end is not there",
              "Export it again", "line " + std::to_string(2 * groups.size() + 1));
}

std::vector<dxf_item> dxf_items(const std::vector<dxf_group>& groups) {
  std::vector<dxf_item> items;
  const std::span<const dxf_group> all(groups);
  for (std::size_t i = 0; i < all.size();) {
    std::size_t next = i + 1;
    while (next < all.size() && all[next].code != 0)
      ++next;
    // What stands before the first item are comments.
    if (all[i].code == 0)
      items.push_back({all[i].value, all.subspan(i + 1, next - i - 1), 2 * i + 2});
    i = next;
  }
  return items;
}

const dxf_group* dxf_values::find(int code) const {
  for (const auto& group : item_.groups)
    if (group.code == code)
      return &group;
  return nullptr;
}

std::string_view dxf_values::text(int code) const {
  const auto* group = find(code);
  return group ? group->value : std::string_view{};
}

double dxf_values::number_in(const dxf_group& group) {
  const auto value = read_number<double>(group.value);
  if (value && std::abs(*value) < most_coordinate)
    return *value;
  const auto line = item_.line + 2 * static_cast<std::size_t>(&group - item_.groups.data()) + 2;
  if (!fault_)
    fault_ = error{ec::bad_input, quoted(group.value) + " is no number that a drawing can have",
                   "Export it again: numbers have a decimal point and are below 1e9",
                   "line " + std::to_string(line)};
  return 0;
}

double dxf_values::number(int code, double otherwise) {
  const auto* group = find(code);
  return group ? number_in(*group) : otherwise;
}

int dxf_values::whole(int code, int otherwise) {
  return static_cast<int>(number(code, otherwise));
}

}  // namespace tedit::ops
