// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/cut_volumes.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/quality.hpp"
#include "ops/tools/local_size.hpp"

namespace tedit::ops {

namespace {

/// What lies between the chords and the arcs of a coarse part's round walls may be as much as a
/// small edit: of that, no more than this share is put on with new vertices.
constexpr double most_put_on = 0.05;

}  // namespace

double wanted_change(const mesh_version& part, const cut_cavity& opened) {
  double change = opened.cut.volume_change;
  for (const auto t : opened.hollow.gone)
    change -= signed_volume(part.corners(t));
  return change;
}

bool changes_nothing(const mesh_version& part, const tool_surface& tool, const cut_cavity& opened) {
  // Points put on shared planes have moved by less than this share of the tool, or of the part
  // where the tool is a half-space; the part, which may be large, is measured last.
  const double change = std::abs(opened.cut.volume_change);
  return opened.hollow.gone.empty() &&
         change <= 1e-6 * enclosed_volume(tool.points, tool.triangles) &&
         change <= 1e-9 * total_volume(part);
}

bool is_small(double volume, const mesh_version& part, const tool_surface& tool,
              const cut_cavity& opened) {
  const double edit =
    std::min(std::abs(wanted_change(part, opened)), enclosed_volume(tool.points, tool.triangles));
  return std::abs(volume) <= most_put_on * edit;
}

boolean_result result_of(mesh_builder& builder, const mesh_version& part,
                         const mesh_version& mesh) {
  boolean_result result;
  result.candidate = builder.freeze();
  result.touched = builder.touched();
  result.volume_change = boundary_volume_change(mesh, *result.candidate);
  result.worst_before = worst_quality_before(part, *result.candidate, result.touched);
  result.worst_after = worst_quality(*result.candidate, result.touched);
  return result;
}

expected<void> volume_fits(const mesh_version& part, double size, const cut_cavity& opened,
                           double put_on, const boolean_result& result) {
  const double wanted =
    opened.hollow.tets.empty() ? result.volume_change : wanted_change(part, opened) + put_on;
  const double off = std::abs(result.volume_change - wanted);
  if (off > 1e-3 * std::abs(wanted) + 0.01 * size * size * size)
    return fail(ec::mesher_failed, "the volume that came out is not that of the tool");
  return {};
}

}  // namespace tedit::ops
