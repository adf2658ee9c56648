// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scan/reader/ply_header.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "scan/reader/file_surface.hpp"

namespace tedit::scan {

namespace {

constexpr const char* ply_remedy = "Save the file again in the program that it comes from";

ply_type type_of(std::string_view word, const line_cursor& lines) {
  constexpr std::array<std::pair<std::string_view, ply_type>, 16> names{
    {{"char", ply_type::int8},
     {"int8", ply_type::int8},
     {"uchar", ply_type::uint8},
     {"uint8", ply_type::uint8},
     {"short", ply_type::int16},
     {"int16", ply_type::int16},
     {"ushort", ply_type::uint16},
     {"uint16", ply_type::uint16},
     {"int", ply_type::int32},
     {"int32", ply_type::int32},
     {"uint", ply_type::uint32},
     {"uint32", ply_type::uint32},
     {"float", ply_type::float32},
     {"float32", ply_type::float32},
     {"double", ply_type::float64},
     {"float64", ply_type::float64}}};
  const auto* found = std::ranges::find(names, word, &std::pair<std::string_view, ply_type>::first);
  if (found == names.end())
    lines.fail_here(ec::bad_input, "\"" + shown(word) + "\" is no type of a PLY file", ply_remedy);
  return found->second;
}

ply_encoding encoding_of(std::string_view word, const line_cursor& lines) {
  if (word == "ascii")
    return ply_encoding::text;
  if (word == "binary_little_endian")
    return ply_encoding::little;
  if (word == "binary_big_endian")
    return ply_encoding::big;
  lines.fail_here(ec::unsupported_format, "\"" + shown(word) + "\" is no encoding of a PLY file",
                  ply_remedy);
}

void add_property(const std::vector<std::string_view>& words, const line_cursor& lines,
                  ply_header& header) {
  const bool is_list = words.size() == 5 && words[1] == "list";
  if (header.elements.empty() || (!is_list && words.size() != 3))
    lines.fail_here(ec::bad_input,
                    header.elements.empty() ? "this property stands before all elements"
                                            : "this property has not a type and a name, or list, "
                                              "two types and a name",
                    ply_remedy);
  ply_property made{std::string(words.back()), ply_type::float32, is_list, ply_type::uint8};
  made.type = type_of(words[is_list ? 3 : 1], lines);
  if (is_list)
    made.count_type = type_of(words[2], lines);
  header.elements.back().properties.push_back(std::move(made));
}

}  // namespace

std::size_t size_of(ply_type type) {
  constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

ply_header read_ply_header(std::string_view file) {
  ply_header header;
  bool has_format = false;
  line_cursor lines(file);
  while (lines.next()) {
    const auto words = words_of(lines.line());
    if (words.empty() || words[0] == "ply" || words[0] == "obj_info")
      continue;
    if (words[0] == "comment") {
      if (header.unit.empty())
        header.unit = unit_in(lines.line());
    } else if (words[0] == "format" && words.size() >= 2) {
      header.encoding = encoding_of(words[1], lines);
      has_format = true;
    } else if (words[0] == "element" && words.size() == 3) {
      const auto count = lines.integer(words[2], "the count of an element");
      if (count < 0)
        lines.fail_here(ec::bad_input,
                        "the PLY file says that it has " + std::to_string(count) + " of \"" +
                          shown(words[1]) + "\"",
                        ply_remedy);
      header.elements.push_back({std::string(words[1]), static_cast<std::uint64_t>(count), {}});
    } else if (words[0] == "property" && words.size() >= 3) {
      add_property(words, lines, header);
    } else if (words[0] == "end_header") {
      if (!has_format)
        lines.fail_here(ec::bad_input, "the header of the PLY file does not say its format",
                        ply_remedy);
      header.line = lines.number();
      header.body = std::min(file.size(), file.find('\n', lines.offset()) + 1);
      return header;
    } else {
      lines.fail_here(ec::bad_input,
                      "\"" + shown(words[0]) + "\" is out of place in the header of a PLY file",
                      ply_remedy);
    }
  }
  lines.fail_here(ec::bad_input, "the header of the PLY file has no end", ply_remedy);
}

}  // namespace tedit::scan
