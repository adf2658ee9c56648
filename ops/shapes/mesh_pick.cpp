// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/mesh_pick.hpp"

#include "mesh/facet_pages.hpp"
#include "mesh/place_text.hpp"
#include "ops/tools/placement.hpp"

namespace tedit::ops {

mesh_pick pick_of(const selection& picked, const parameters& values) {
  mesh_pick result;
  result.surfaces = as_set(picked);
  result.at = vector_of(values, "at");
  result.radius = std::get<double>(values.at("radius"));
  return result;
}

expected<void> check_pick(const mesh_version& mesh, const mesh_pick& pick) {
  if (!pick.at && pick.surfaces.empty())
    return fail(ec::empty_selection, "neither a surface nor a place was given",
                "Select surfaces, or give a place: at_mm=10,20,5");
  const auto sizes = surface_sizes(mesh);
  for (const auto id : pick.surfaces)
    if (!pick.at && !sizes.contains(id))
      return fail(ec::empty_selection,
                  "surface " + std::to_string(id) + " has no facet on the outside of the part",
                  "Select a surface of the boundary");
  if (!pick.at)
    return {};
  std::vector<std::array<vec3, 3>> all;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f)) {
      const auto& v = mesh.facet(f).v;
      all.push_back({mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])});
    }
  const double off = facet_distance(std::move(all))(*pick.at, 1e30);
  if (off <= std::max(pick.radius, 1e-9) || in_material(mesh, *pick.at))
    return {};
  return fail(ec::empty_selection,
              "the place " + place_text(*pick.at) + " is " + size_text(off) + " off the part",
              "Give a place in or on the part, or a larger radius");
}

parameter_description pick_radius_parameter() {
  return {"radius", "Radius", "Around the place.", parameter_type::real, "m", 0.0, 10.0, {}, 0.0};
}

std::string size_text(double metres) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g mm", 1e3 * metres);
  return text;
}

}  // namespace tedit::ops
