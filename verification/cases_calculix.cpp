// SPDX-License-Identifier: AGPL-3.0-or-later
// Real parts side by side with CalculiX: the same nodes, elements, supports and nodal forces in an
// independent program with a direct solver. What differs is the solver's tolerance, rounding, and
// the 7 digits that CalculiX prints: 5e-7 of each number. The displacement's bound leaves room for
// thin parts, where our residual of 1e-9 weighs more.
#include "verification/agreement.hpp"
#include "verification/cases.hpp"

namespace tedit::verification {

namespace {

void compare(case_context& c, const fem::problem& p, const fem::solution& ours,
             const calculix_solution& theirs) {
  side_by_side_row row{c.part().name, c.order(), p.element_count(), p.node_count()};
  const auto found = compare_solutions(p, ours, theirs);
  row.displacement = found.displacement;
  row.reaction = found.reaction;
  row.surface_reaction = found.surface_reaction;
  row.compliance = found.compliance;
  row.program = theirs.program;
  const auto part = row.part + ": ";
  constexpr agreement_limits limits;
  c.at_most(part + "largest |du| / largest |u|", limits.displacement, row.displacement);
  c.at_most(part + "difference of the sum of reactions", limits.reaction, row.reaction);
  c.at_most(part + "largest difference of a surface's reaction", limits.reaction,
            row.surface_reaction);
  c.within(part + "compliance, J", found.compliance_j, ours.compliance_j, limits.compliance);
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
