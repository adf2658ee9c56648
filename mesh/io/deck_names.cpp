// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/deck_names.hpp"

#include <algorithm>
#include <ostream>

namespace tedit {

namespace {

/// A line end would end the comment.
std::string one_line(std::string text) {
  std::ranges::replace_if(
    text, [](unsigned char c) { return c < 32; }, ' ');
  return text;
}

}  // namespace

std::string surface_word(surface_id id) {
  return "SURFACE-" + std::to_string(id);
}

std::string region_word(region_id id) {
  return "REGION-" + std::to_string(id);
}

void write_name_comments(std::ostream& out, std::string_view comment, const mesh_version& mesh,
                         std::string_view length_unit) {
  out << comment << "TEdit unit " << length_unit << '\n';
  for (const auto& row : mesh.regions())
    out << comment << "TEdit region " << row.id << " is " << region_word(row.id) << ": "
        << one_line(row.name) << '\n';
  for (const auto& row : mesh.surfaces())
    out << comment << "TEdit surface " << row.id << " is " << surface_word(row.id) << ": "
        << one_line(row.name) << '\n';
}

}  // namespace tedit
