// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/file_kind.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace tedit::cad {

namespace {

constexpr std::size_t looked_at = 4096;

/// The 73rd column of an IGES line says its section; the first lines are of section S.
bool is_iges(std::string_view head) {
  return head.size() > 80 && head[72] == 'S' && head.substr(73, 7).find('1') != head.npos &&
         head.substr(0, 80).find('\n') == head.npos;
}

bool is_brep(std::string_view head) {
  return head.find("CASCADE Topology V") != head.npos ||
         head.find("DBRep_DrawableShape") != head.npos;
}

std::string looks_like(std::string_view head) {
  if (head.starts_with("$MeshFormat"))
    return "a Gmsh mesh, which the other commands take as it is";
  if (head.starts_with("\x89HDF"))
    return "MED or other HDF5, whose mesh the other commands take as it is";
  if (head.starts_with("\x89PNG") || head.starts_with("\xFF\xD8\xFF"))
    return "a picture";
  if (head.starts_with("PK"))
    return "a ZIP archive: unpack it first";
  if (head.starts_with("solid ") || head.starts_with("facet"))
    return "an STL surface, which has no CAD faces";
  if (head.starts_with("{") || head.starts_with("<"))
    return "text of another kind";
  return "something else";
}

}  // namespace

std::string_view name_of(file_kind kind) {
  return kind == file_kind::step ? "step" : kind == file_kind::iges ? "iges" : "brep";
}

expected<file_kind> kind_of(const std::filesystem::path& file) {
  std::error_code code;
  if (!std::filesystem::is_regular_file(file, code))
    return fail(
      ec::io_error,
      "cannot read " + file.string() + ": " +
        (std::filesystem::exists(file, code) ? "it is no regular file" : "there is no such file"),
      "Check the path");
  std::ifstream in(file, std::ios::binary);
  if (!in)
    return fail(ec::io_error, "opening " + file.string() + " failed: " + std::strerror(errno),
                "Check the path");
  std::string head(looked_at, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  if (std::ranges::all_of(
        head, [](char c) { return c == '\0' || std::isspace(static_cast<unsigned char>(c)); }))
    return fail(ec::bad_input, "the file is empty", "Export the part from the CAD program again",
                file.string());
  if (head.find("ISO-10303-21") != head.npos)
    return file_kind::step;
  if (is_iges(head))
    return file_kind::iges;
  if (is_brep(head))
    return file_kind::brep;
  return fail(
    ec::unsupported_format, "this is no STEP, IGES or BREP file: it looks like " + looks_like(head),
    "Export the part from the CAD program as STEP (AP203, AP214 or AP242)", file.string());
}

std::vector<std::string> files_referred_to(std::string_view step) {
  std::vector<std::string> found;
  for (const std::string_view word :
       {"DOCUMENT_FILE", "APPLIED_EXTERNAL_IDENTIFICATION_ASSIGNMENT"})
    for (auto at = step.find(word); at != step.npos; at = step.find(word, at + 1)) {
      const auto line = step.substr(at, 400);
      const auto begin = line.find('\'');
      const auto end = begin == line.npos ? begin : line.find('\'', begin + 1);
      if (end == line.npos || end == begin + 1 || line.substr(0, begin).find(';') != line.npos)
        continue;
      std::string name(line.substr(begin + 1, end - begin - 1));
      if (std::ranges::find(found, name) == found.end())
        found.push_back(std::move(name));
    }
  return found;
}

}  // namespace tedit::cad
