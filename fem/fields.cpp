// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/fields.hpp"

#include "fem/error_estimate.hpp"

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
                            at_vertices("relative_error", 1, nodal_error(p, result)),
                            at_tets("element_error_sqrt_j", 1, result.element_error)};
  if (!result.safety_factor.empty())
    fields.push_back(at_vertices("safety_factor", 1, result.safety_factor));
  return fields;
}

std::string case_field(std::string_view name, std::string_view load_case) {
  return std::string(name) + " (" + std::string(load_case) + ")";
}

std::vector<field> make_fields(const mesh_version& mesh, const case_set& set,
                               const solved_cases& result) {
  const auto& p = set.problem;
  if (result.cases.size() == 1)
    return make_fields(mesh, p, result.cases.front());
  const auto at_vertices = [&](const char* name, const std::vector<double>& values) {
    return scatter(name, field_location::vertex, 1, mesh.vertex_slots(), p.node_vertices, values);
  };
  const auto& worst = result.envelope;
  std::vector<field> fields{
    at_vertices("envelope_von_mises", worst.von_mises),
    at_vertices("envelope_case", {worst.von_mises_case.begin(), worst.von_mises_case.end()})};
  if (!worst.safety_factor.empty()) {
    fields.push_back(at_vertices("envelope_safety_factor", worst.safety_factor));
    fields.push_back(at_vertices("envelope_safety_factor_case", {worst.safety_factor_case.begin(),
                                                                 worst.safety_factor_case.end()}));
  }
  for (std::size_t c = 0; c < result.cases.size(); ++c)
    for (auto& one : make_fields(mesh, p, result.cases[c])) {
      one.name = case_field(one.name, set.cases[c].name);
      fields.push_back(std::move(one));
    }
  return fields;
}

}  // namespace tedit::fem
