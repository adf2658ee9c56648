// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/field_file.hpp"

#include "fem/fields.hpp"
#include "mesh/io/field_writer.hpp"

namespace tedit::cli {

expected<void> write_field(const std::filesystem::path& path, const mesh_version& mesh,
                           const fem::problem& problem, const fem::solution& result) {
  return write_vtu(
    path, mesh, fem::make_fields(mesh, problem, result),
    {{"version_id", to_hex(mesh.id())},
     {"quality", result.preview() ? "preview (linear tets)" : "final (quadratic tets)"},
     {"device", result.device}});
}

}  // namespace tedit::cli
