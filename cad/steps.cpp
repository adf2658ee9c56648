// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/steps.hpp"

#include <map>

#include "cad/step_makers.hpp"
#include "mesh/features/wall_shape.hpp"
#include "ops/loader/catalogue.hpp"
#include "ops/shapes/walls/carried_surfaces.hpp"

namespace tedit::cad {

cad_step on_surfaces(step_kind kind, const edit_made& edit, double distance) {
  cad_step step;
  step.kind = kind;
  step.surfaces.assign(edit.surfaces().begin(), edit.surfaces().end());
  step.distance_mm = distance * mm_of_metre;
  return step;
}

namespace {

step_or_reason nothing(const edit_made& edit) {
  return on_surfaces(step_kind::none, edit);
}

step_or_reason removal(const edit_made& edit) {
  return on_surfaces(step_kind::remove, edit);
}

/// Walls that move by `distance` (m, outward), with the fillets that the mesh lets go along.
cad_step shift_of(const edit_made& edit, double distance) {
  auto step = on_surfaces(step_kind::shift, edit, distance);
  auto walls = ops::fit_walls(edit.before, edit.surfaces());
  if (!walls)
    return step;
  for (const auto& [id, way] : ops::find_carried(edit.before, *walls, distance))
    step.carried.push_back(
      {static_cast<int>(id), {mm_of_metre * way.x, mm_of_metre * way.y, mm_of_metre * way.z}});
  return step;
}

step_or_reason erosion(const edit_made& edit) {
  const double depth = edit.number("depth");
  if (depth <= 0)
    return because("layers of tets were taken off, which is no length");
  return shift_of(edit, -depth);
}

step_or_reason thickening(const edit_made& edit) {
  return shift_of(edit, edit.number("depth"));
}

step_or_reason resizing(const edit_made& edit) {
  const auto wall = fit_wall(
    edit.before, facets_of(edit.before, std::array{edit.surfaces().front()}), {1e-3, true, false});
  if (!wall || wall->type != wall_shape::kind::cylinder)
    return because("the wall is no cylinder in the mesh");
  return shift_of(edit, wall->side * (edit.number("diameter") / 2 - wall->radius));
}

template <bool Convex>
step_or_reason rounding(const edit_made& edit) {
  auto step = on_surfaces(step_kind::round, edit, edit.number("radius"));
  step.convex = Convex;
  return step;
}

step_or_reason bending(const edit_made&) {
  return because(
    "deform bends walls point by point: there is no plane, cylinder or other surface of "
    "CAD that they would be");
}

using maker = step_or_reason (*)(const edit_made&);

/// Operations of which it is known what they are on a B-rep.
const std::map<std::string, maker>& makers() {
  static const std::map<std::string, maker> all{
    {"boss", boss_extrusion},     {"close", rounding<false>}, {"coarsen", nothing},
    {"combine", combining},       {"deform", bending},        {"drill", drilling},
    {"emboss", embossing},        {"erode", erosion},         {"fill_hole", removal},
    {"hollow", hollowing},        {"improve_mesh", nothing},  {"move", moving},
    {"open", rounding<true>},     {"pattern", repeating},     {"plane_cut", plane_cut},
    {"pocket", pocket_extrusion}, {"refine", nothing},        {"remove_surfaces", removal},
    {"resize_bore", resizing},    {"rib", ribbing},           {"sweep", sweeping},
    {"thicken", thickening},
  };
  return all;
}

}  // namespace

tl::expected<cad_step, std::string> step_of(const ops::operation_description& description,
                                            const mesh_version& before, const edit_request& wanted,
                                            const edit_report& report) {
  const auto made = makers().find(wanted.operation);
  if (made == makers().end())
    return because(
      "the operation " + wanted.operation +
      " is a plugin's, which works on meshes: what it does to a CAD model is not known");
  auto values = ops::complete_parameters(description, wanted.parameters, &before);
  if (!values)
    return because(values.error().message);
  const edit_made edit{before, wanted, report, std::move(*values)};
  if (edit.surfaces().empty() && wanted.surfaces.empty() && made->second == resizing)
    return because("no wall was given");
  return made->second(edit);
}

}  // namespace tedit::cad
