// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/fields.hpp"

namespace tedit::fem {

namespace {

field scatter(const char* name, field_location location, int components, std::size_t slots,
              const std::vector<std::uint32_t>& owners, const std::vector<double>& values) {
  const auto width = static_cast<std::size_t>(components);
  std::vector<double> by_slot(slots * width, 0.0);
  for (std::size_t i = 0; i < owners.size(); ++i)
    for (std::size_t c = 0; c < width && owners[i] != no_id; ++c)
      by_slot[owners[i] * width + c] = values[i * width + c];
  return {name, location, components, paged_array<double>::from(by_slot)};
}

}  // namespace

std::vector<field> make_fields(const mesh_version& mesh, const problem& p, const solution& result) {
  using enum field_location;
  const auto at_vertices = [&](const char* name, int components, const auto& values) {
    return scatter(name, vertex, components, mesh.vertex_slots(), p.node_vertices, values);
  };
  const auto at_tets = [&](const char* name, int components, const auto& values) {
    return scatter(name, tet, components, mesh.tet_slots(), p.element_tets, values);
  };
  std::vector<double> largest(p.corner_count);
  for (std::size_t n = 0; n < largest.size(); ++n)
    largest[n] = result.principal_stress[3 * n];
  std::vector<field> fields{at_vertices("displacement_m", 3, result.displacement),
                            at_vertices("von_mises_pa", 1, result.von_mises),
                            at_vertices("stress_pa", 6, result.nodal_stress),
                            at_vertices("reaction_n", 3, result.reactions),
                            at_tets("element_von_mises_pa", 1, result.element_von_mises),
                            at_tets("element_stress_pa", 6, result.element_stress),
                            at_vertices("principal_stress_pa", 1, largest),
                            at_tets("element_error_sqrt_j", 1, result.element_error)};
  if (!result.safety_factor.empty())
    fields.push_back(at_vertices("safety_factor", 1, result.safety_factor));
  return fields;
}

}  // namespace tedit::fem
