// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/repair.hpp"

#include <array>
#include <string>

#include "base/text.hpp"
#include "edit/make_edit.hpp"
#include "mesh/quality.hpp"

namespace tedit::cad {

namespace {

/// How far the boundary may move, in terms of the edge length that was asked for.
constexpr std::array tolerances{0.0, 1e-3, 1e-2, 5e-2};

expected<checked_edit> improved(const ops::catalogue& plugins, const version_ptr& mesh,
                                double tolerance_m, const execution& run) {
  edit_request wanted;
  wanted.operation = "improve_mesh";
  wanted.parameters["surface_tolerance"] = tolerance_m;
  operation_place place;
  place.child.emplace();
  place.find_most = false;
  return make_edit(plugins, mesh, wanted, {}, place, run);
}

}  // namespace

expected<void> repair_part(imported_part& part, const execution& run) {
  double worst = radius_ratios(*part.version).min;
  if (worst >= least_quality)
    return {};
  const auto plugins = ops::load_default_catalogue(ops::plugin_source::built_in);
  for (std::size_t i = 0; i < tolerances.size() && worst < least_quality; ++i) {
    const double size = static_cast<double>(tolerances.size());
    const auto step = run.part(static_cast<double>(i) / size, static_cast<double>(i + 1) / size);
    const auto better =
      improved(plugins, part.version, tolerances[i] * part.report.size_mm * 1e-3, step);
    if (!better && better.error().code == ec::cancelled)
      return fail(better.error());
    if (!better)
      continue;
    part.version = better->version;
    if (const auto& done = better->report.optimisation)
      part.report.moved_mm += 1e3 * done->surface_deviation;
    worst = radius_ratios(*part.version).min;
  }
  if (worst < least_quality)
    part.warnings.push_back("the worst tet has a radius ratio of " + format_number("%.3g", worst) +
                            ", below " + format_number("%.2g", least_quality) +
                            ": stresses beside it are not to be trusted");
  return {};
}

}  // namespace tedit::cad
