// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/step_makers.hpp"
#include "mesh/features/select.hpp"
#include "ops/pattern/pattern.hpp"
#include "ops/tools/local_size.hpp"

namespace tedit::cad {

namespace {

step_motion in_mm(const ops::motion& way) {
  step_motion result;
  for (std::size_t k = 0; k < 3; ++k)
    result.columns[k] = {way.columns[k].x, way.columns[k].y, way.columns[k].z};
  result.shift = {mm_of_metre * way.shift.x, mm_of_metre * way.shift.y, mm_of_metre * way.shift.z};
  return result;
}

/// Where the feature comes to lie.
box extent_after(const mesh_version& mesh, const std::vector<surface_id>& surfaces,
                 const ops::motion& way) {
  box extent;
  for (const auto f : facets_of(mesh, surfaces))
    for (const auto v : mesh.facet(f).v)
      extent.add(way(mesh.position(v)));
  return extent;
}

/// As the operations complete a pick: a hole, else a boss.
bool is_hole(const mesh_version& mesh, surface_id pick) {
  return select_surfaces(mesh, {.kind = feature_kind::hole, .surfaces = {pick}}, {}).has_value();
}

step_or_reason copies(const edit_made& edit, const std::vector<ops::motion>& motions) {
  if (edit.surfaces().empty() || edit.wanted.surfaces.empty())
    return because("no wall was given");
  auto step = on_surfaces(step_kind::copy, edit);
  step.is_hole = is_hole(edit.before, edit.wanted.surfaces.front());
  for (const auto& way : motions)
    step.motions.push_back(in_mm(way));
  step.edge_mm =
    mm_of_metre *
    ops::local_size(edit.before, extent_after(edit.before, edit.surfaces(), motions.front()));
  return step;
}

}  // namespace

step_or_reason moving(const edit_made& edit) {
  const auto by = ops::vector_of(edit.values, "by").value_or(vec3{});
  auto step = copies(edit, {ops::shift_by(by)});
  if (step)
    step->leaves = !std::get<bool>(edit.values.at("copy"));
  return step;
}

step_or_reason repeating(const edit_made& edit) {
  const auto motions = ops::pattern_motions(edit.values);
  if (!motions)
    return because(motions.error().message);
  return copies(edit, *motions);
}

}  // namespace tedit::cad
