// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/optimisation_message.hpp"

#include <algorithm>

#include "tedit/v1/report.pb.h"

namespace tedit::protocol {

namespace {

void quality_to(const quality_figures& q, v1::MeshQuality* out) {
  out->set_tets(q.tets);
  out->mutable_dihedral_counts()->Assign(q.dihedral.begin(), q.dihedral.end());
  out->mutable_radius_ratio_counts()->Assign(q.ratio.begin(), q.ratio.end());
  out->set_min_radius_ratio(q.min_ratio);
  out->set_radius_ratio_1pct(q.ratio_1pct);
  out->set_mean_radius_ratio(q.mean_ratio);
  out->set_min_dihedral_deg(q.min_dihedral_deg);
  out->set_max_dihedral_deg(q.max_dihedral_deg);
  out->set_dihedral_1pct_deg(q.dihedral_1pct_deg);
}

quality_figures quality_from(const v1::MeshQuality& m) {
  quality_figures q;
  q.tets = m.tets();
  std::copy_n(m.dihedral_counts().begin(),
              std::min<std::size_t>(q.dihedral.size(), m.dihedral_counts_size()),
              q.dihedral.begin());
  std::copy_n(m.radius_ratio_counts().begin(),
              std::min<std::size_t>(q.ratio.size(), m.radius_ratio_counts_size()), q.ratio.begin());
  q.min_ratio = m.min_radius_ratio();
  q.ratio_1pct = m.radius_ratio_1pct();
  q.mean_ratio = m.mean_radius_ratio();
  q.min_dihedral_deg = m.min_dihedral_deg();
  q.max_dihedral_deg = m.max_dihedral_deg();
  q.dihedral_1pct_deg = m.dihedral_1pct_deg();
  return q;
}

}  // namespace

void to_message(const improve_report& report, v1::Optimisation* out) {
  quality_to(report.before.value_or(quality_figures{}), out->mutable_before());
  quality_to(report.after.value_or(quality_figures{}), out->mutable_after());
  out->set_surface_deviation_m(report.surface_deviation);
  out->set_flips(report.moves.flips);
  out->set_relocations(report.moves.relocations);
  out->set_collapses(report.moves.collapses);
  out->set_insertions(report.moves.insertions);
  out->set_harmonic_flips(report.moves.harmonic_flips);
  out->set_harmonic_relocations(report.moves.harmonic_relocations);
  out->set_boundary_flips(report.moves.boundary_flips);
  out->set_boundary_relocations(report.moves.boundary_relocations);
  out->set_boundary_collapses(report.moves.boundary_collapses);
}

improve_report from_message(const v1::Optimisation& m) {
  improve_report report;
  report.before = quality_from(m.before());
  report.after = quality_from(m.after());
  report.min_before = report.before->min_ratio;
  report.min_after = report.after->min_ratio;
  report.surface_deviation = m.surface_deviation_m();
  report.moves = {m.flips(),          m.relocations(),          m.collapses(),
                  m.insertions(),     m.harmonic_flips(),       m.harmonic_relocations(),
                  m.boundary_flips(), m.boundary_relocations(), m.boundary_collapses()};
  return report;
}

}  // namespace tedit::protocol
