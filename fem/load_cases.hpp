// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/solver.hpp"

namespace tedit::fem {

/// Loads and supports of one load case on a problem's nodes: the members of `problem` that
/// `set_conditions` fills.
struct conditions {
  std::string name;
  std::vector<std::string> warnings;  ///< Of its constraints and loads, each once.
  std::vector<double> loads;
  std::vector<std::array<double, 6>> filter;
  std::vector<double> prescribed;
  std::vector<node_holder> holders;
};

/// Several load cases on one mesh with one set of materials, so that all share one matrix.
struct case_set {
  fem::problem problem;           ///< With the conditions of the case that stands.
  std::vector<conditions> cases;  ///< In the order given, at least one. Of the case that stands
                                  ///< only the name counts: the rest is in `problem`.
  std::size_t standing = 0;       ///< Its index.

  /// Lets another case stand. No values are moved: views of them stay valid.
  void stand(std::size_t c);

  /// Lets a case stand when none does: all conditions are in `cases`.
  void let_stand(std::size_t c);

  /// Whichever case stands.
  [[nodiscard]] const std::vector<std::array<double, 6>>& filter_of(std::size_t c) const {
    return c == standing ? problem.filter : cases[c].filter;
  }
};

/// Moves the conditions of a load case out of a problem, which then has none.
[[nodiscard]] conditions take_conditions(problem& p, const load_case& of);

/// Errors: `invalid_argument` for no case at all; `invalid_material` for a case whose materials
/// differ from the first one's in more than their names.
[[nodiscard]] expected<void> check_cases(std::span<const load_case> loads);

/// Sets up all cases before anything is solved; the first one stands. `spare_corners`: see
/// `make_problem`. Errors: those of `check_cases` and `make_problem`; with several cases each names
/// its case. Cost: O(mesh) and O(nodes) per case.
[[nodiscard]] expected<case_set> make_cases(const mesh_version& mesh,
                                            std::span<const load_case> loads, int element_order = 1,
                                            std::uint32_t spare_corners = 0);

/// Puts other cases into a set of the same mesh and materials; the first one stands. Errors: those
/// of `set_conditions`, named as above; then the set is not to be used.
[[nodiscard]] expected<void> set_cases(const mesh_version& mesh, std::span<const load_case> loads,
                                       case_set& set);

/// An error that starts with the load case it is about, when there are several.
[[nodiscard]] tl::unexpected<error> fail_in_case(std::span<const load_case> loads, std::size_t c,
                                                 error e);

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
  fem::envelope envelope;       ///< Empty for a single case: it would say the same again.
  double assembly_ms = 0;
  double setup_ms = 0;  ///< Of the hierarchies of the second and later supports, too.
  double solve_ms = 0;
  double recovery_ms = 0;
};

/// One frame while load cases converge.
struct cases_frame {
  int outer_round = 0;
  // Of the cases that are at work: the most iterations, the largest residual and error.
  int iterations = 0;
  double true_relative_residual = 1;
  double energy_error = 1;
  /// All cases as they are now, not `converged`. Costs a recovery of each. Empty when the cases
  /// have different supports: some have not begun then.
  std::function<expected<std::vector<solution>>()> recover;
};

using cases_callback = std::function<void(const cases_frame&)>;

/// A system to solve on, with the filter of the case that stands.
struct standing_system {
  const element_operator& k;
  linear_system& system;
  std::string device;      ///< Names it in the results.
  double assembly_ms = 0;  ///< What it took to come here, for the results.
  double setup_ms = 0;
  bool lost = false;  ///< The solve ended while the filter was exchanged: assemble another one.
};

/// Solves all cases: those with the same supports together (what one costs,
/// `linear_system::solve_many` says), those with others one group after the other on the same
/// matrix, beginning with the case that stands. `settings`: one for each case, which differ in
/// their starts. Another case may stand afterwards, always the one whose filter the system has.
/// Errors: those of `solve`; with several cases one that is about a load case names it.
[[nodiscard]] expected<solved_cases> solve_cases(case_set& set, standing_system& on,
                                                 std::vector<solve_settings> settings,
                                                 const execution& run,
                                                 const cases_callback& on_frame = {});

/// The same on a system that is assembled for it.
[[nodiscard]] expected<solved_cases> solve_cases(case_set& set, backend& device,
                                                 const solve_settings& settings,
                                                 const execution& run);

}  // namespace tedit::fem
