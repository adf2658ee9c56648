// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/foreign_file.hpp"

#include <algorithm>
#include <string>

#include "mesh/io/line_cursor.hpp"

namespace tedit {

namespace {

using namespace std::string_view_literals;

constexpr const char* export_mesh =
  "Write it as .msh, .vtu, .inp, .bdf, .unv or .med in the program that it comes from";

struct foreign_kind {
  std::string_view begin;  ///< In capitals where it is text.
  const char* is;
  const char* remedy;
};

constexpr foreign_kind binary_kinds[] = {
  {"\x89PNG"sv, "a PNG picture", "Choose the file of the part"},
  {"\xFF\xD8\xFF"sv, "a JPEG picture", "Choose the file of the part"},
  {"%PDF"sv, "a PDF document", "Choose the file of the part"},
  {"PK\3\4"sv, "a zip archive", "Unpack it first"},
  {"\x1F\x8B"sv, "a file that is packed by gzip", "Unpack it first: gunzip FILE"},
  {"7z\xBC\xAF"sv, "an archive of 7-Zip", "Unpack it first"},
  {"Rar!"sv, "a RAR archive", "Unpack it first"},
  {"\xD0\xCF\x11\xE0"sv, "a file of Windows programs (OLE), such as a part of SolidWorks",
   "Export the part as STEP"},
  // With all of its first bytes it is taken for MED.
  {"\x89HDF"sv, "an HDF5 file, such as MED, whose first bytes are damaged",
   "Copy it again, not as text"},
  {"SQLite format 3"sv, "a database, such as a document of TEdit",
   "Open it as a document: its name ends with .tedit"},
  {"\x7F"
   "ELF"sv,
   "a program", "Choose the file of the part"}};

/// Compared with the first letters of the file in capitals.
constexpr foreign_kind text_kinds[] = {
  {"<!DOCTYPE HTML"sv, "a web page, as where a download failed", "Download the file again"},
  {"<HTML"sv, "a web page, as where a download failed", "Download the file again"},
  {"VERSION HTTPS://GIT-LFS"sv, "a pointer of Git LFS in place of the file",
   "Fetch the file: git lfs pull"},
  {"ISO-10303-21"sv, "a STEP file (CAD geometry)",
   "Mesh it first: gmsh part.step -3 -format msh41 -o part.msh"},
  {"# VTK DATAFILE"sv, "an old VTK file", "Write it as .vtu, for example with ParaView"},
  {"MESHVERSIONFORMATTED"sv, "a mesh of Medit (.mesh)", export_mesh},
  {"#INVENTOR"sv, "an Inventor scene", "Export the part as STEP, STL or 3MF"},
  {"#VRML"sv, "a VRML scene", "Export the part as STEP, STL or 3MF"},
  {"/PREP7"sv, "input of Ansys (.cdb)", export_mesh},
  {"/BATCH"sv, "input of Ansys (.cdb)", export_mesh},
  {"{\""sv, "JSON", "Choose the file of the part"}};

std::string_view first_text(std::string_view text) {
  constexpr std::size_t enough = 256;
  const auto begin = text.find_first_not_of(" \t\r\n\v\f");
  return begin == text.npos ? std::string_view() : text.substr(begin, enough);
}

bool is_wide_text(std::string_view text) {
  return text.starts_with("\xFF\xFE"sv) || text.starts_with("\xFE\xFF"sv);
}

/// What is no kind of file at all.
std::optional<error> about_text(std::string_view text) {
  if (text.empty())
    return error{ec::bad_input, "the file is empty", "Write or copy it again", {}};
  if (is_wide_text(text))
    return error{
      ec::unsupported_format, "the file is text in UTF-16", "Save it as UTF-8 or ASCII", {}};
  if (first_text(text).empty())
    return error{ec::bad_input, "the file holds blanks alone", "Write or copy it again", {}};
  return std::nullopt;
}

}  // namespace

std::optional<error> foreign_file(std::span<const char> bytes) {
  const std::string_view text(bytes.data(), bytes.size());
  if (auto about = about_text(text))
    return about;
  const auto words = upper(first_text(text));
  const auto said = [&](const foreign_kind& kind) {
    return error{ec::unsupported_format,
                 "this is " + std::string(kind.is) + ", which is not read",
                 kind.remedy,
                 {}};
  };
  for (const auto& kind : binary_kinds)
    if (text.starts_with(kind.begin))
      return said(kind);
  for (const auto& kind : text_kinds)
    if (words.starts_with(kind.begin))
      return said(kind);
  return std::nullopt;
}

}  // namespace tedit
