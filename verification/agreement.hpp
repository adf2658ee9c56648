// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "fem/solver.hpp"
#include "verification/calculix.hpp"

/// How far our solution of a problem and CalculiX's agree.
namespace tedit::verification {

/// Differences, relative: of the displacement to the largest one, of reactions to the sum of all
/// surfaces' magnitudes, which is what rounding to 7 digits is proportional to.
struct agreement {
  double displacement = 0;      ///< The largest difference at a node.
  double reaction = 0;          ///< Of the sum of all reactions.
  double surface_reaction = 0;  ///< The largest difference of a surface.
  double compliance_j = 0;      ///< CalculiX's.
  double compliance = 0;        ///< The relative difference of ours.
};

/// What one may be for both to be right: our residual of 1e-9, which weighs more on thin parts, and
/// the digits that CalculiX prints.
struct agreement_limits {
  double displacement = 1e-5;
  double reaction = 1e-6;
  double compliance = 1e-6;
  double stress = 1e-4;
};

/// Cost: O(nodes).
[[nodiscard]] agreement compare_solutions(const fem::problem& p, const fem::solution& ours,
                                          const calculix_solution& theirs);

/// Stress at the corner nodes, where each program takes means of its own of the elements around:
/// ours weighs them by volume, CalculiX's all alike.
struct stress_agreement {
  /// The largest difference of von Mises stress, over the largest of CalculiX, when ours is taken
  /// as CalculiX takes it: what is left is a difference of stress, not of means.
  double same_means = 0;
  double own_means = 0;         ///< The same of what each program shows.
  double own_means_median = 0;  ///< Half of the nodes differ by less.
  vec3 own_means_at;            ///< Where they differ most.
  double most_ours_pa = 0;      ///< The largest von Mises stress that each shows.
  double most_theirs_pa = 0;
};

/// @pre `theirs.stress` is there. Cost: O(mesh).
[[nodiscard]] stress_agreement compare_stress(const fem::problem& p, const fem::solution& ours,
                                              const calculix_solution& theirs);

/// Stress at the corner nodes, Pa, 6 each: the mean of the elements around, all alike, as
/// CalculiX's `extrapolate.f` makes it.
[[nodiscard]] std::vector<double> plain_nodal_stress(const fem::problem& p,
                                                     std::span<const double> displacement);

}  // namespace tedit::verification
