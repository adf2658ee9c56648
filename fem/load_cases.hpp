// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/solver.hpp"

namespace tedit::fem {

/// Loads and supports of one load case on a problem's nodes: the members of `problem` that
/// `set_conditions` fills.
struct conditions {
  std::string name;
  std::vector<double> loads;
  std::vector<std::array<double, 6>> filter;
  std::vector<double> prescribed;
  std::vector<node_holder> holders;
};

/// Several load cases on one mesh with one set of materials, so that all share one matrix.
struct case_set {
  fem::problem problem;           ///< With the conditions of the first case.
  std::vector<conditions> cases;  ///< In the order given, at least one.
};

/// Sets up all cases before anything is solved. Errors: those of `make_problem`, each naming the
/// load case; `invalid_argument` for no case at all; `invalid_material` for a case whose materials
/// differ from the first one's in more than their names. Cost: O(mesh) and O(nodes) per case.
[[nodiscard]] expected<case_set> make_cases(const mesh_version& mesh,
                                            std::span<const load_case> loads,
                                            int element_order = 1);

/// The most dangerous value of several load cases, with its place and the index of its case.
struct case_extreme {
  double value = 0;
  vec3 at;
  std::size_t of = 0;
};

/// What is worst over several load cases. Arrays are indexed by the problem's nodes; of equal
/// values the first case counts.
struct envelope {
  std::vector<double> von_mises;              ///< Pa: the largest of the cases' nodal values.
  std::vector<std::uint32_t> von_mises_case;  ///< Which case it is of.
  std::vector<double> safety_factor;  ///< The smallest; 0 where no yield strength is known. Empty
                                      ///< when it is unknown everywhere.
  std::vector<std::uint32_t> safety_factor_case;
  case_extreme max_von_mises;      ///< Pa; element or node as in `solution::max_von_mises_pa`.
  case_extreme max_displacement;   ///< m.
  case_extreme min_safety_factor;  ///< Value 0 when no yield strength is known.
};

/// At least one case, all of one problem. Cost: O(nodes) per case.
[[nodiscard]] envelope make_envelope(std::span<const solution> cases);

/// Load cases that were solved together.
struct solved_cases {
  std::vector<solution> cases;  ///< In the order given. Their times are shares of the whole.
  fem::envelope envelope;
  double assembly_ms = 0;
  double setup_ms = 0;  ///< Of the hierarchies of the second and later supports, too.
  double solve_ms = 0;
  double recovery_ms = 0;
};

/// Assembles once and solves all cases: those with the same supports together (what one costs,
/// `linear_system::solve_many` says), those with others one group after the other on the same
/// matrix. While it works, the set's problem takes the conditions of one case after the other; it
/// ends with those of the first. Errors: those of `solve`; one that is about a load case names it.
[[nodiscard]] expected<solved_cases> solve_cases(case_set& set, backend& device,
                                                 const solve_settings& settings,
                                                 const execution& run);

}  // namespace tedit::fem
