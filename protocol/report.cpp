// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/report.hpp"

#include "protocol/load_policy_message.hpp"
#include "protocol/optimisation_message.hpp"
#include "protocol/vector_message.hpp"
#include "tedit/v1/session.pb.h"

namespace tedit::protocol {

namespace {

// The message's enumeration starts with one for "unspecified"; ours with `kept`, which no list of
// changes holds.
v1::SurfaceChange::Fate fate_to(surface_fate fate) {
  return static_cast<v1::SurfaceChange::Fate>(static_cast<int>(fate));
}

static_assert(static_cast<int>(surface_fate::changed) == v1::SurfaceChange::CHANGED &&
              static_cast<int>(surface_fate::split_from) == v1::SurfaceChange::SPLIT_FROM);

void to_message(const surface_change& change, v1::SurfaceChange* out) {
  out->set_id(change.id);
  out->set_name(change.name);
  out->set_fate(fate_to(change.fate));
  out->set_other(change.other);
  out->set_area_before_m2(change.area_before);
  out->set_area_after_m2(change.area_after);
}

surface_change from_message(const v1::SurfaceChange& m) {
  return {
    m.id(),           static_cast<surface_fate>(m.fate()), m.other(), m.name(), m.area_before_m2(),
    m.area_after_m2()};
}

static_assert(static_cast<int>(fem::singularity::reentrant_edge) + 1 ==
              v1::SingularPlace::REENTRANT_EDGE);

v1::SingularPlace::Kind kind_to(fem::singularity kind) {
  return static_cast<v1::SingularPlace::Kind>(static_cast<int>(kind) + 1);
}

/// Nothing for "unspecified" and for kinds that a newer server may know.
std::optional<fem::singularity> kind_from(v1::SingularPlace::Kind kind) {
  if (kind != v1::SingularPlace::CLAMP_RIM && kind != v1::SingularPlace::REENTRANT_EDGE)
    return std::nullopt;
  return static_cast<fem::singularity>(static_cast<int>(kind) - 1);
}

void judgement_to(const solve_report& report, v1::SolveReport* out) {
  out->set_strain_energy_j(report.strain_energy_j);
  if (report.mass_kg)
    out->set_mass_kg(*report.mass_kg);
  out->set_relative_error_estimate(report.relative_error_estimate);
  if (report.min_safety_factor) {
    out->set_min_safety_factor(*report.min_safety_factor);
    write_vector(report.min_safety_factor_at, out->mutable_min_safety_factor_at_m());
  }
  for (const auto& r : report.surface_reactions) {
    auto* row = out->add_surface_reactions();
    row->set_surface(r.surface);
    row->set_name(r.name);
    write_vector(r.force_n, row->mutable_force_n());
  }
  for (const auto& place : report.singular_places) {
    auto* row = out->add_singular_places();
    row->set_kind(kind_to(place.kind));
    write_vector(place.at, row->mutable_at_m());
    row->set_von_mises_pa(place.von_mises_pa);
  }
  out->set_singular_places_count(static_cast<std::uint32_t>(report.singular_places_count));
  if (report.max_von_mises_singularity)
    out->set_max_von_mises_singularity(kind_to(*report.max_von_mises_singularity));
  out->set_notice(report.notice);
  out->mutable_warnings()->Assign(report.warnings.begin(), report.warnings.end());
}

void judgement_from(const v1::SolveReport& m, solve_report& report) {
  report.strain_energy_j = m.strain_energy_j();
  if (m.has_mass_kg())
    report.mass_kg = m.mass_kg();
  report.relative_error_estimate = m.relative_error_estimate();
  if (m.has_min_safety_factor())
    report.min_safety_factor = m.min_safety_factor();
  report.min_safety_factor_at = read_vector(m.min_safety_factor_at_m());
  for (const auto& row : m.surface_reactions())
    report.surface_reactions.push_back({row.surface(), row.name(), read_vector(row.force_n())});
  for (const auto& row : m.singular_places())
    if (const auto kind = kind_from(row.kind()))
      report.singular_places.push_back({*kind, read_vector(row.at_m()), row.von_mises_pa()});
  report.singular_places_count = m.singular_places_count();
  report.max_von_mises_singularity = kind_from(m.max_von_mises_singularity());
  report.notice = m.notice();
  report.warnings.assign(m.warnings().begin(), m.warnings().end());
}

}  // namespace

void to_message(const edit_report& report, v1::EditReport* out) {
  out->set_from_version(report.from_version);
  out->set_to_version(report.to_version);
  out->set_operation(report.operation);
  out->mutable_surfaces()->Assign(report.surfaces.begin(), report.surfaces.end());
  out->mutable_surfaces_used()->Assign(report.surfaces_used.begin(), report.surfaces_used.end());
  for (const auto& change : report.surface_map)
    to_message(change, out->add_surface_map());
  for (const auto& line : report.receipt)
    to_message(line, out->add_receipt());
  out->mutable_notices()->Assign(report.notices.begin(), report.notices.end());
  out->set_tets_added(report.tets_added);
  out->set_tets_removed(report.tets_removed);
  out->set_volume_change_m3(report.volume_change);
  if (report.ratios) {
    out->set_touched_min_before(report.ratios->min_before);
    out->set_touched_min_after(report.ratios->min_after);
    out->set_touched_median_after(report.ratios->median_after);
  }
  out->set_operation_ms(report.operation_ms);
  if (report.optimisation)
    to_message(*report.optimisation, out->mutable_optimisation());
  to_message(report.loads, out->mutable_loads());
  out->set_improve_ms(report.improve_ms);
  out->set_check_ms(report.check_ms);
  out->set_total_ms(report.total_ms);
  for (const auto& f : report.figures) {
    auto* row = out->add_figures();
    row->set_id(f.id);
    row->set_value(f.value);
    row->set_unit(f.unit);
    row->set_help(f.help);
  }
}

edit_report from_message(const v1::EditReport& m) {
  edit_report report;
  report.from_version = m.from_version();
  report.to_version = m.to_version();
  report.operation = m.operation();
  report.surfaces.assign(m.surfaces().begin(), m.surfaces().end());
  report.surfaces_used.assign(m.surfaces_used().begin(), m.surfaces_used().end());
  for (const auto& change : m.surface_map())
    report.surface_map.push_back(from_message(change));
  for (const auto& line : m.receipt())
    report.receipt.push_back(from_message(line));
  report.notices.assign(m.notices().begin(), m.notices().end());
  report.tets_added = m.tets_added();
  report.tets_removed = m.tets_removed();
  report.volume_change = m.volume_change_m3();
  if (m.has_touched_min_after())
    report.ratios = {m.touched_min_before(), m.touched_min_after(), m.touched_median_after()};
  report.operation_ms = m.operation_ms();
  if (m.has_optimisation())
    report.optimisation = from_message(m.optimisation());
  report.loads = from_message(m.loads()).value_or(fem::carry_settings{});
  report.improve_ms = m.improve_ms();
  report.check_ms = m.check_ms();
  report.total_ms = m.total_ms();
  for (const auto& row : m.figures())
    report.figures.push_back({row.id(), row.value(), row.unit(), row.help()});
  return report;
}

void to_message(const solve_report& report, v1::SolveReport* out) {
  out->set_version_id(report.version_id);
  out->set_load_case(report.load_case);
  out->set_device(report.device);
  out->set_element_order(static_cast<std::uint32_t>(report.element_order));
  out->set_preview(report.preview);
  out->set_interim(report.interim);
  out->set_dofs(report.dofs);
  out->set_iterations(static_cast<std::uint32_t>(report.iterations));
  out->set_true_relative_residual(report.true_relative_residual);
  out->set_max_displacement_m(report.max_displacement_m);
  write_vector(report.max_displacement_at, out->mutable_max_displacement_at_m());
  out->set_compliance_j(report.compliance_j);
  out->set_max_von_mises_pa(report.max_von_mises_pa);
  write_vector(report.max_von_mises_at, out->mutable_max_von_mises_at_m());
  write_vector(report.reaction_n, out->mutable_reaction_n());
  write_vector(report.applied_n, out->mutable_applied_n());
  out->set_assembly_ms(report.assembly_ms);
  out->set_setup_ms(report.setup_ms);
  out->set_solve_ms(report.solve_ms);
  out->set_recovery_ms(report.recovery_ms);
  out->set_total_ms(report.total_ms);
  judgement_to(report, out);
}

solve_report from_message(const v1::SolveReport& m) {
  solve_report report;
  report.version_id = m.version_id();
  report.load_case = m.load_case();
  report.device = m.device();
  report.element_order = static_cast<int>(m.element_order());
  report.preview = m.preview();
  report.interim = m.interim();
  report.dofs = m.dofs();
  report.iterations = static_cast<int>(m.iterations());
  report.true_relative_residual = m.true_relative_residual();
  report.max_displacement_m = m.max_displacement_m();
  report.max_displacement_at = read_vector(m.max_displacement_at_m());
  report.compliance_j = m.compliance_j();
  report.max_von_mises_pa = m.max_von_mises_pa();
  report.max_von_mises_at = read_vector(m.max_von_mises_at_m());
  report.reaction_n = read_vector(m.reaction_n());
  report.applied_n = read_vector(m.applied_n());
  report.assembly_ms = m.assembly_ms();
  report.setup_ms = m.setup_ms();
  report.solve_ms = m.solve_ms();
  report.recovery_ms = m.recovery_ms();
  report.total_ms = m.total_ms();
  judgement_from(m, report);
  return report;
}

namespace {

void to_message(const worst_value& worst, v1::Envelope::Worst* out) {
  out->set_value(worst.value);
  write_vector(worst.at, out->mutable_at_m());
  out->set_load_case(worst.load_case);
}

worst_value from_message(const v1::Envelope::Worst& m) {
  return {m.value(), read_vector(m.at_m()), m.load_case()};
}

}  // namespace

void to_message(const solve_envelope& envelope, v1::Envelope* out) {
  out->set_version_id(envelope.version_id);
  out->mutable_load_cases()->Assign(envelope.load_cases.begin(), envelope.load_cases.end());
  out->set_element_order(static_cast<std::uint32_t>(envelope.element_order));
  out->set_preview(envelope.preview);
  out->set_interim(envelope.interim);
  to_message(envelope.max_von_mises, out->mutable_max_von_mises_pa());
  to_message(envelope.max_displacement, out->mutable_max_displacement_m());
  if (envelope.min_safety_factor)
    to_message(*envelope.min_safety_factor, out->mutable_min_safety_factor());
}

solve_envelope from_message(const v1::Envelope& m) {
  solve_envelope envelope;
  envelope.version_id = m.version_id();
  envelope.load_cases.assign(m.load_cases().begin(), m.load_cases().end());
  envelope.element_order = static_cast<int>(m.element_order());
  envelope.preview = m.preview();
  envelope.interim = m.interim();
  envelope.max_von_mises = from_message(m.max_von_mises_pa());
  envelope.max_displacement = from_message(m.max_displacement_m());
  if (m.has_min_safety_factor())
    envelope.min_safety_factor = from_message(m.min_safety_factor());
  return envelope;
}

void to_message(const solve_outcome& outcome, v1::Solved* out) {
  out->set_solve(outcome.solve);
  if (!outcome.envelope)
    return to_message(outcome.cases.front(), out->mutable_report());
  for (const auto& report : outcome.cases)
    to_message(report, out->add_cases());
  to_message(*outcome.envelope, out->mutable_envelope());
}

solve_outcome from_message(const v1::Solved& m) {
  solve_outcome outcome;
  for (const auto& report : m.cases())
    outcome.cases.push_back(from_message(report));
  if (outcome.cases.empty())
    outcome.cases.push_back(from_message(m.report()));
  if (m.has_envelope())
    outcome.envelope = from_message(m.envelope());
  outcome.solve = m.solve();
  return outcome;
}

}  // namespace tedit::protocol
