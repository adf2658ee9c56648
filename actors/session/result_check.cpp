// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/session/result_check.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "fem/quantities.hpp"

namespace tedit::actors {

namespace {

auto damaged(const std::string& what) {
  return fail(ec::protocol_error, "a solver sent " + what,
              "Solve on another device, and tell whoever made that solver");
}

bool has_finite_numbers(const solve_report& r) {
  const double numbers[] = {r.true_relative_residual,
                            r.max_displacement_m,
                            r.compliance_j,
                            r.max_von_mises_pa,
                            r.assembly_ms,
                            r.setup_ms,
                            r.solve_ms,
                            r.recovery_ms,
                            r.total_ms,
                            r.strain_energy_j,
                            r.mass_kg.value_or(0),
                            r.relative_error_estimate,
                            r.min_safety_factor.value_or(0)};
  const vec3 places[] = {r.max_displacement_at, r.max_von_mises_at, r.reaction_n, r.applied_n,
                         r.min_safety_factor_at};
  return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); }) &&
         std::ranges::all_of(places, [](const vec3& v) { return is_finite(v); }) &&
         std::ranges::all_of(r.surface_reactions,
                             [](const named_reaction& one) { return is_finite(one.force_n); }) &&
         std::ranges::all_of(r.singular_places, [](const stress_peak& one) {
           return is_finite(one.at) && std::isfinite(one.von_mises_pa);
         });
}

bool has_finite_numbers(const solve_envelope& e) {
  const auto finite = [](const worst_value& one) {
    return std::isfinite(one.value) && is_finite(one.at);
  };
  return finite(e.max_von_mises) && finite(e.max_displacement) &&
         (!e.min_safety_factor || finite(*e.min_safety_factor));
}

/// What an array of this name must be; nothing for a name that is none.
struct expected_array {
  field_location location = field_location::vertex;
  int components = 1;
};

std::optional<expected_array> array_named(std::string_view name, const load_case_list& cases) {
  const auto of_case = [&](const fem::result_array& array) {
    if (name == array.name)
      return true;
    const auto fits = [&](const fem::load_case& one) {
      return name == std::string(array.name) + " (" + one.name + ")";
    };
    return name.starts_with(array.name) && std::ranges::any_of(cases, fits);
  };
  for (const auto& array : fem::result_arrays) {
    if (of_case(array))
      return expected_array{
        array.place == fem::array_place::tets ? field_location::tet : field_location::vertex,
        array.components};
    if (!array.envelope.values.empty() &&
        (name == array.envelope.values || name == array.envelope.cases))
      return expected_array{};
  }
  return std::nullopt;
}

bool all_finite(const paged_array<double>& values) {
  const auto& pages = values.pages();
  std::atomic<bool> finite{true};
  parallel_for(pages.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (auto p = first; p < last; ++p) {
      const auto bytes = pages[p]->bytes();
      const auto* numbers = reinterpret_cast<const double*>(bytes.data());
      const auto is = [](double x) { return std::isfinite(x); };
      if (!std::all_of(numbers, numbers + bytes.size() / sizeof(double), is))
        finite = false;
    }
  });
  return finite;
}

expected<void> check_outcome(const solve_outcome& outcome, const mesh_version& mesh,
                             const load_case_list& load_cases) {
  const auto version = to_hex(mesh.id());
  if (outcome.cases.size() != load_cases.size())
    return damaged(std::to_string(outcome.cases.size()) + " results for " +
                   std::to_string(load_cases.size()) + " load cases");
  for (std::size_t c = 0; c < load_cases.size(); ++c) {
    const auto& report = outcome.cases[c];
    if (report.version_id != version || report.load_case != load_cases[c].name)
      return damaged("a result of another version or load case");
    if (!has_finite_numbers(report))
      return damaged("a report with numbers that are not finite");
  }
  if (outcome.envelope &&
      (outcome.envelope->version_id != version || !has_finite_numbers(*outcome.envelope)))
    return damaged("an envelope of another version, or with numbers that are not finite");
  return {};
}

}  // namespace

expected<void> check_solved(const solve_outcome& outcome, std::span<const field> fields,
                            const mesh_version& mesh, const load_case_list& load_cases) {
  if (auto ok = check_outcome(outcome, mesh, load_cases); !ok)
    return ok;
  for (const auto& one : fields) {
    const auto wanted = array_named(one.name, load_cases);
    if (!wanted)
      return damaged("an array that nobody knows");
    const auto slots =
      one.location == field_location::vertex ? mesh.vertex_slots() : mesh.tet_slots();
    if (one.location != wanted->location || one.components != wanted->components ||
        one.values.size() != slots * static_cast<std::size_t>(one.components))
      return damaged("an array " + one.name + " that does not fit the mesh");
    if (!all_finite(one.values))
      return damaged("an array " + one.name + " with numbers that are not finite");
  }
  return {};
}

}  // namespace tedit::actors
