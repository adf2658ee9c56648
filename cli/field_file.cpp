// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/field_file.hpp"

#include "fem/fields.hpp"
#include "mesh/formats.hpp"
#include "mesh/io/file.hpp"

namespace tedit::cli {

namespace {

std::vector<std::pair<std::string, std::string>> notes_of(const mesh_version& mesh,
                                                          const fem::solution& result) {
  const char* quality = result.element_order < 2 ? "preview (linear tets)"
                        : result.preview()       ? "preview (quadratic tets, stopped early)"
                                                 : "final (quadratic tets)";
  return {{"version_id", to_hex(mesh.id())}, {"quality", quality}, {"device", result.device}};
}

}  // namespace

expected<void> write_field(const std::filesystem::path& path, const mesh_version& mesh,
                           const fem::problem& problem, const fem::solution& result) {
  return formats::vtu::write(
    path, mesh,
    {.fields = fem::make_fields(mesh, problem, result), .notes = notes_of(mesh, result)});
}

expected<void> write_field(const std::filesystem::path& path, const mesh_version& mesh,
                           const fem::case_set& set, const fem::solved_cases& result) {
  auto notes = notes_of(mesh, result.cases.front());
  for (std::size_t c = 0; c < set.cases.size(); ++c)
    notes.emplace_back("case_" + std::to_string(c), set.cases[c].name);
  return formats::vtu::write(path, mesh,
                             {.fields = fem::make_fields(mesh, set, result), .notes = notes});
}

}  // namespace tedit::cli
