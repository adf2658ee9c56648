// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/make_report.hpp"

#include <algorithm>
#include <ranges>

namespace tedit {

namespace {

std::vector<named_reaction> name_reactions(const mesh_version& mesh,
                                           const std::vector<fem::surface_reaction>& reactions) {
  std::vector<named_reaction> result;
  for (const auto& r : reactions) {
    const auto* row = mesh.find_surface(r.surface);
    result.push_back({r.surface, row ? row->name : "", r.force_n});
  }
  return result;
}

/// Whether the element with the largest stress has `node` as a corner.
bool has_largest_stress(const fem::problem& p, const fem::solution& result, std::uint32_t node) {
  if (result.max_von_mises_element == no_id)
    return false;
  const auto width = static_cast<std::size_t>(p.nodes_per_element);
  const auto corners = std::span(p.element_nodes).subspan(result.max_von_mises_element * width, 4);
  return std::ranges::find(corners, node) != corners.end();
}

/// The largest stress is that of a node (order 2) or of an element (order 1).
std::optional<fem::singularity> singularity_of_maximum(const fem::problem& p,
                                                       const fem::solution& result) {
  for (const auto& place : result.singular_places)
    if (p.element_order == 1 ? has_largest_stress(p, result, place.node)
                             : place.at == result.max_von_mises_at)
      return place.kind;
  return std::nullopt;
}

void add_judgement(const mesh_version& mesh, const fem::problem& problem,
                   const fem::solution& result, solve_report& report) {
  report.strain_energy_j = result.strain_energy_j;
  if (result.mass_known)
    report.mass_kg = result.mass_kg;
  report.relative_error_estimate = result.relative_error;
  if (!result.safety_factor.empty()) {
    report.min_safety_factor = result.min_safety_factor;
    report.min_safety_factor_at = result.min_safety_factor_at;
  }
  report.surface_reactions = name_reactions(mesh, result.surface_reactions);
  report.singular_places_count = result.singular_places.size();
  for (const auto& place :
       result.singular_places | std::views::take(solve_report::most_singular_places))
    report.singular_places.push_back({place.kind, place.at, place.von_mises_pa});
  report.max_von_mises_singularity = singularity_of_maximum(problem, result);
}

}  // namespace

solve_report make_report(const mesh_version& mesh, const std::string& load_case,
                         const fem::problem& problem, const fem::solution& result) {
  solve_report report;
  report.version_id = to_hex(mesh.id());
  report.load_case = load_case;
  report.device = result.device;
  report.element_order = result.element_order;
  report.preview = result.preview();
  report.dofs = problem.unknowns();
  report.iterations = result.iterations;
  report.true_relative_residual = result.true_relative_residual;
  report.max_displacement_m = result.max_displacement_m;
  report.max_displacement_at = result.max_displacement_at;
  report.compliance_j = result.compliance_j;
  report.max_von_mises_pa = result.max_von_mises_pa;
  report.max_von_mises_at = result.max_von_mises_at;
  report.reaction_n = result.reaction_n;
  report.applied_n = result.applied_n;
  report.assembly_ms = result.assembly_ms;
  report.setup_ms = result.setup_ms;
  report.solve_ms = result.solve_ms;
  report.recovery_ms = result.recovery_ms;
  add_judgement(mesh, problem, result, report);
  return report;
}

solve_envelope make_envelope(const std::vector<solve_report>& cases) {
  solve_envelope result;
  const auto& first = cases.front();
  result.version_id = first.version_id;
  result.element_order = first.element_order;
  result.preview = std::ranges::any_of(cases, &solve_report::preview);
  result.interim = std::ranges::any_of(cases, &solve_report::interim);
  result.max_von_mises = {first.max_von_mises_pa, first.max_von_mises_at, first.load_case};
  result.max_displacement = {first.max_displacement_m, first.max_displacement_at, first.load_case};
  for (const auto& one : cases) {
    result.load_cases.push_back(one.load_case);
    if (one.max_von_mises_pa > result.max_von_mises.value)
      result.max_von_mises = {one.max_von_mises_pa, one.max_von_mises_at, one.load_case};
    if (one.max_displacement_m > result.max_displacement.value)
      result.max_displacement = {one.max_displacement_m, one.max_displacement_at, one.load_case};
    auto& least = result.min_safety_factor;
    if (one.min_safety_factor && (!least || *one.min_safety_factor < least->value))
      least = worst_value{*one.min_safety_factor, one.min_safety_factor_at, one.load_case};
  }
  return result;
}

solve_outcome make_outcome(const mesh_version& mesh, const fem::case_set& set,
                           const fem::solved_cases& result, bool interim, double total_ms) {
  solve_outcome outcome;
  const auto count = result.cases.size();
  for (std::size_t c = 0; c < count; ++c) {
    auto report = make_report(mesh, set.cases[c].name, set.problem, result.cases[c]);
    report.interim = interim;
    report.total_ms = total_ms / static_cast<double>(count);
    report.warnings = set.cases[c].warnings;
    outcome.cases.push_back(std::move(report));
  }
  if (count > 1)
    outcome.envelope = make_envelope(outcome.cases);
  return outcome;
}

}  // namespace tedit
