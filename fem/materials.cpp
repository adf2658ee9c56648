// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cmath>

#include "fem/problem_parts.hpp"

namespace tedit::fem {

namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%g", value);
  return text;
}

expected<void> check_material(const material& m) {
  const auto refuse = [&](const std::string& why, const std::string& remedy) {
    return fail(ec::invalid_material, "material \"" + m.name + "\": " + why, remedy);
  };
  if (!(m.young_modulus_pa > 0) || !std::isfinite(m.young_modulus_pa))
    return refuse("Young's modulus is " + number(m.young_modulus_pa) + " Pa",
                  "It must be a positive number");
  if (!(m.poisson_ratio > -1 && m.poisson_ratio < 0.5))
    return refuse("Poisson's ratio is " + number(m.poisson_ratio),
                  "It must lie between -1 and 0.5, both excluded");
  if (!(m.density_kg_m3 >= 0) || !std::isfinite(m.density_kg_m3))
    return refuse("the density is " + number(m.density_kg_m3) + " kg/m3",
                  "It must not be negative");
  if (!(m.yield_strength_pa >= 0) || !std::isfinite(m.yield_strength_pa))
    return refuse("the yield strength is " + number(m.yield_strength_pa) + " Pa",
                  "It must not be negative");
  return {};
}

}  // namespace

expected<void> assign_materials(const mesh_version& mesh, const load_case& loads, problem& p) {
  if (loads.materials.empty())
    return fail(ec::invalid_material, "the load case has no material",
                "Give at least one, with Young's modulus and Poisson's ratio");
  std::map<region_id, std::uint32_t> by_region;
  std::int64_t fallback = -1;
  for (std::uint32_t i = 0; i < loads.materials.size(); ++i) {
    const auto& m = loads.materials[i];
    if (auto ok = check_material(m); !ok)
      return ok;
    const double nu = m.poisson_ratio;
    const double e = m.young_modulus_pa;
    p.constants.push_back({e * nu / ((1 + nu) * (1 - 2 * nu)), e / (2 * (1 + nu))});
    p.densities.push_back(m.density_kg_m3);
    p.yield_strengths.push_back(m.yield_strength_pa);
    if (m.regions.empty()) {
      if (fallback >= 0)
        return fail(ec::invalid_material,
                    "the materials \"" + loads.materials[fallback].name + "\" and \"" + m.name +
                      "\" both name no region",
                    "Only one material can stand for all remaining regions");
      fallback = i;
    }
    for (const auto region : m.regions)
      if (!by_region.emplace(region, i).second)
        return fail(ec::invalid_material, "region " + std::to_string(region) + " has two materials",
                    "Name each region in one material");
  }
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    if (!mesh.is_live_tet(t))
      continue;
    const auto found = by_region.find(mesh.region_of(t));
    if (found == by_region.end() && fallback < 0)
      return fail(ec::invalid_material,
                  "region " + std::to_string(mesh.region_of(t)) + " has no material",
                  "Name it in a material, or give one material without regions");
    p.element_materials.push_back(found == by_region.end() ? static_cast<std::uint32_t>(fallback)
                                                           : found->second);
  }
  return {};
}

}  // namespace tedit::fem
