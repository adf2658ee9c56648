// SPDX-License-Identifier: AGPL-3.0-or-later
// Real parts side by side with CalculiX: the same nodes, elements, supports and nodal forces in an
// independent program with a direct solver. What differs is the solver's tolerance, rounding, and
// the 7 digits that CalculiX prints: 5e-7 of each number. The displacement's bound leaves room for
// thin parts, where our residual of 1e-9 weighs more.
#include <algorithm>
#include <cmath>

#include "fem/recovery.hpp"
#include "verification/calculix.hpp"
#include "verification/cases.hpp"
#include "verification/fields.hpp"

namespace tedit::verification {

namespace {

/// Largest |a - b| over all nodes, divided by the largest |b|.
double largest_difference(std::span<const double> a, std::span<const double> b) {
  double difference = 0;
  double scale = 0;
  for (std::size_t n = 0; n < a.size() / 3; ++n) {
    difference = std::max(difference, norm(node_value(a, n) - node_value(b, n)));
    scale = std::max(scale, norm(node_value(b, n)));
  }
  return difference / scale;
}

double work_of(std::span<const double> forces, std::span<const double> displacement) {
  double work = 0;
  for (std::size_t i = 0; i < forces.size(); ++i)
    work += forces[i] * displacement[i];
  return work;
}

/// Reactions of both, by surface and in total, over the sum of the magnitudes of the surfaces'
/// reactions: that is what rounding to 7 digits is proportional to.
struct reaction_differences {
  double total = 0;
  double surface = 0;  ///< The worst one.
};

reaction_differences compare_reactions(const fem::problem& p, const fem::solution& ours,
                                       std::span<const double> theirs) {
  const auto by_surface = fem::reactions_by_surface(p, theirs);
  reaction_differences worst;
  double scale = 0;
  vec3 total;
  for (std::size_t i = 0; i < by_surface.size(); ++i) {
    const vec3 difference = by_surface[i].force_n - ours.surface_reactions[i].force_n;
    scale += norm(by_surface[i].force_n);
    worst.surface = std::max(worst.surface, norm(difference));
    total += difference;
  }
  return {norm(total) / scale, worst.surface / scale};
}

void compare(case_context& c, const fem::problem& p, const fem::solution& ours,
             const calculix_solution& theirs) {
  side_by_side_row row{c.part().name, c.order(), p.element_count(), p.node_count()};
  row.displacement = largest_difference(ours.displacement, theirs.displacement);
  const auto reactions = compare_reactions(p, ours, theirs.reactions);
  row.reaction = reactions.total;
  row.surface_reaction = reactions.surface;
  const double compliance = work_of(p.loads, theirs.displacement);
  row.compliance = std::abs(ours.compliance_j / compliance - 1);
  row.program = theirs.program;
  const auto part = row.part + ": ";
  c.at_most(part + "largest |du| / largest |u|", 1e-5, row.displacement);
  c.at_most(part + "difference of the sum of reactions", 1e-6, row.reaction);
  c.at_most(part + "largest difference of a surface's reaction", 1e-6, row.surface_reaction);
  c.within(part + "compliance, J", compliance, ours.compliance_j, 1e-6);
  c.add_side_by_side(row, theirs.milliseconds);
}

expected<void> side_by_side(case_context& c) {
  const auto program = find_calculix();
  if (program.empty()) {
    c.leave_out("the program ccx is not installed: apt-get install " +
                std::string(calculix_package));
    return {};
  }
  const auto p = fem::make_problem(*c.part().mesh, c.part().loads, c.order());
  // A mesh that no program could solve is no disagreement.
  if (!p && p.error().code == ec::degenerate_tet) {
    c.leave_out(c.part().name + " is refused: " + p.error().message);
    return {};
  }
  if (!p)
    return fail(p.error());
  const auto ours = c.solve(*p);
  if (!ours)
    return fail(ours.error());
  const auto theirs = solve_with_calculix(program, *p, c.silent_execution());
  if (!theirs)
    return fail(theirs.error());
  compare(c, *p, *ours, *theirs);
  return {};
}

}  // namespace

std::vector<case_entry> calculix_cases() {
  return {{side_by_side_case,
           "CalculiX, C3D4 and C3D10",
           "an independent program with a direct solver on the same mesh, supports and loads: "
           "displacement at every node, reactions, compliance (`--calculix`).",
           {1, 2},
           side_by_side,
           true}};
}

}  // namespace tedit::verification
