// SPDX-License-Identifier: AGPL-3.0-or-later
#include <set>

#include "base/number_range.hpp"
#include "fem/polled.hpp"
#include "fem/problem_parts.hpp"

namespace tedit::fem {

namespace {

expected<void> check_material(const material& m) {
  const auto check = [&](const char* what, double value, const number_range& range) {
    return check_number(value, range, "material \"" + m.name + "\": " + what, ec::invalid_material);
  };
  // What single precision can hold, with room for lengths and volumes.
  if (auto ok = check("Young's modulus", m.young_modulus_pa, {1e-9, 1e18, "Pa"}); !ok)
    return ok;
  if (!(m.poisson_ratio > -1 && m.poisson_ratio < 0.5))
    return fail(ec::invalid_material,
                "material \"" + m.name + "\": Poisson's ratio is " + number_text(m.poisson_ratio),
                "It must lie between -1 and 0.5, both excluded");
  if (auto ok = check("the density", m.density_kg_m3, {0, largest_number, "kg/m3"}); !ok)
    return ok;
  return check("the yield strength", m.yield_strength_pa, {0, largest_number, "Pa"});
}

}  // namespace

region_materials materials_of_regions(const load_case& loads) {
  region_materials result;
  for (std::uint32_t i = 0; i < loads.materials.size(); ++i) {
    if (loads.materials[i].regions.empty())
      result.fallback = i;
    for (const auto region : loads.materials[i].regions)
      result.named.emplace(region, i);
  }
  return result;
}

tl::unexpected<error> refuse_region(region_id region) {
  return fail(ec::invalid_material, "region " + std::to_string(region) + " has no material",
              "Name it in a material, or give one material without regions");
}

expected<void> assign_materials(const mesh_version& mesh, const load_case& loads, problem& p) {
  if (loads.materials.empty())
    return fail(ec::invalid_material, "the load case has no material",
                "Give at least one, with Young's modulus and Poisson's ratio");
  std::set<region_id> named;
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
      if (!named.insert(region).second)
        return fail(ec::invalid_material, "region " + std::to_string(region) + " has two materials",
                    "Name each region in one material");
  }
  const auto materials = materials_of_regions(loads);
  auto refused = no_id;  // The first tet in a region without material.
  polled_for(mesh.tet_slots(), [&](std::size_t slot) {
    const auto t = static_cast<tet_id>(slot);
    if (!mesh.is_live_tet(t))
      return;
    p.element_materials.push_back(materials.of(mesh.region_of(t)));
    if (p.element_materials.back() == no_id && refused == no_id)
      refused = t;
  });
  if (refused != no_id)
    return refuse_region(mesh.region_of(refused));
  return {};
}

}  // namespace tedit::fem
