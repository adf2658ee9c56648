// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/comparison.hpp"
#include "fem/load_case.hpp"
#include "mesh/version.hpp"

namespace tedit {

/// In what two load cases differ, one line each, by the names that a load case's file has:
/// "materials[steel].young_modulus_pa: 2.1e+11 -> 7e+10", "loads[1]: none -> force on 3". Materials
/// are compared by name, supports and loads by their place in the list; warnings are left out, as
/// they are said of each by itself. Empty: none. Cost: O(both).
[[nodiscard]] std::vector<std::string> differences_of(const fem::load_case& before,
                                                      const fem::load_case& after);

/// Volume by region, m^3. Cost: O(tets).
struct region_volume {
  region_id region = 0;
  double volume_m3 = 0;
};
[[nodiscard]] std::vector<region_volume> region_volumes(const mesh_version& mesh);

/// Mass by the materials of a load case, kg; nothing when a region has none or its density is
/// unknown. Cost: O(regions).
[[nodiscard]] std::optional<double> mass_of(std::span<const region_volume> volumes,
                                            const fem::load_case& loads);

}  // namespace tedit
