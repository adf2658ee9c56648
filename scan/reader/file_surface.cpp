// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scan/reader/file_surface.hpp"

#include "base/text.hpp"
#include "base/units.hpp"
#include "mesh/io/foreign_file.hpp"

namespace tedit::scan {

expected<file_surface> read_surface(std::string_view kind, std::span<const char> bytes) {
  bytes = without_mark(bytes);
  const bool is_archive = std::string_view(bytes.data(), bytes.size()).starts_with("PK");
  if (auto foreign = foreign_file(bytes); foreign && !(kind == "3mf" && is_archive))
    return fail(std::move(*foreign));
  return kind == "stl"   ? read_stl(bytes)
         : kind == "obj" ? read_obj(bytes)
         : kind == "ply" ? read_ply(bytes)
                         : read_3mf(bytes);
}

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\v\f";
  std::vector<std::string_view> words;
  while (true) {
    const auto from = line.find_first_not_of(blanks);
    if (from == line.npos)
      return words;
    line.remove_prefix(from);
    words.push_back(line.substr(0, line.find_first_of(blanks)));
    line.remove_prefix(words.back().size());
  }
}

std::string unit_in(std::string_view text) {
  constexpr std::string_view words = "TEdit boundary, unit ";
  const auto at = text.find(words);
  if (at == text.npos)
    return {};
  const auto after = words_of(text.substr(at + words.size(), 16));
  const auto unit = after.empty() ? std::string() : std::string(after.front());
  return metres_per_unit(unit) ? unit : std::string();
}

void add_polygon(file_surface& into, std::span<const std::uint32_t> corners, std::uint32_t group) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    into.surface.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    into.group_of.push_back(group);
  }
}

expected<file_surface> checked(file_surface read, const char* kind) {
  const auto count = read.surface.triangles.size();
  if (count == 0)
    return fail(ec::bad_input, std::string("the ") + kind + " file holds no triangle",
                "Save the part's surface again, as a binary STL or a 3MF");
  if (count > most_triangles)
    return fail(ec::bad_input,
                "the surface has " + std::to_string(count) + " triangles, more than 2,000,000",
                "Simplify it first, for example in MeshLab");
  return read;
}

}  // namespace tedit::scan
