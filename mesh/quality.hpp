// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/version.hpp"

namespace tedit {

/// Signed volume det[b-a, c-a, d-a] / 6 in m^3; positive for a well oriented tet.
[[nodiscard]] double signed_volume(vec3 a, vec3 b, vec3 c, vec3 d);
[[nodiscard]] double signed_volume(const std::array<vec3, 4>& p);

/// q = 3 r_in / R_circ in [0,1]: 1 for the regular tet, 0 for a flat or inverted one.
/// Formula: 3 r / R with r = 3 V / sum A and R = sqrt(s(s-la)(s-lb)(s-lc)) / (6 V), where la, lb,
/// lc are the products of opposite edge lengths and s their half sum; so q = 54 V^2 / (sum A
/// sqrt(...)). The paper's Table 1 prints q / 3.
[[nodiscard]] double radius_ratio(vec3 a, vec3 b, vec3 c, vec3 d);
[[nodiscard]] double radius_ratio(const std::array<vec3, 4>& p);

/// eta = (sum |A_i|^2) / V in m, the energy of harmonic triangulations (Alexa 2019); +infinity when
/// V <= 0.
[[nodiscard]] double harmonic_energy(const std::array<vec3, 4>& p);

/// The six interior dihedral angles in rad, at edges 01, 02, 03, 12, 13, 23.
[[nodiscard]] std::array<double, 6> dihedral_angles(const std::array<vec3, 4>& p);

/// Minimum, median and maximum of a set of values; zeros for an empty set.
struct value_summary {
  double min = 0;
  double median = 0;
  double max = 0;
};
[[nodiscard]] value_summary summarize(std::vector<double> values);

/// Radius ratios of all live tets, or of the live ones among `tets`.
[[nodiscard]] value_summary radius_ratios(const mesh_version& mesh);
[[nodiscard]] value_summary radius_ratios(const mesh_version& mesh,
                                          const std::vector<tet_id>& tets);

}  // namespace tedit
