// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/field_file.hpp"

#include "mesh/io/vtu_writer.hpp"

namespace tedit::cli {

expected<void> write_field(const std::filesystem::path& path, const mesh_version& mesh,
                           const fem::problem& problem, const fem::solution& result) {
  std::vector<double> regions;
  regions.reserve(problem.element_count());
  for (const auto t : problem.element_tets)
    regions.push_back(mesh.region_of(t));
  vtu_grid grid;
  grid.points = problem.nodes;
  grid.cells = problem.element_nodes;
  grid.nodes_per_cell = problem.nodes_per_element;
  grid.point_data = {{"displacement_m", 3, result.displacement},
                     {"von_mises_pa", 1, result.von_mises},
                     {"stress_pa", 6, result.nodal_stress},
                     {"reaction_n", 3, result.reactions}};
  grid.cell_data = {{"region", 1, regions},
                    {"element_von_mises_pa", 1, result.element_von_mises},
                    {"element_stress_pa", 6, result.element_stress}};
  grid.notes = {{"version_id", to_hex(mesh.id())},
                {"quality", result.preview() ? "preview (linear tets)" : "final"},
                {"device", result.device}};
  return write_vtu(path, grid);
}

}  // namespace tedit::cli
