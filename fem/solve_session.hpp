// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "fem/problem_update.hpp"
#include "fem/solver.hpp"

namespace tedit::fem {

/// Solves one thing after the other and keeps what the next solve can use: the assembled system
/// while mesh and materials stay (new loads or constraints never assemble again); where an edit
/// changed the mesh a little, the system with the rows that it touched renewed; and the last
/// displacement as a start. Holds one system; not for two threads at once.
class solve_session {
public:
  struct result {
    fem::solution solution;
    bool assembled = true;         ///< False when the system of the last solve was used again.
    std::size_t renewed_rows = 0;  ///< Rows of it that an edit changed.
  };

  /// Errors: those of `make_problem` and `solve`; what was kept stays usable or is dropped.
  [[nodiscard]] expected<result> solve(const version_ptr& mesh, const load_case& loads,
                                       int element_order, backend& device,
                                       const solve_settings& settings, const execution& run,
                                       const frame_callback& on_frame = {});

  /// The problem of the last solve, also while it sends frames. Not before the first one.
  [[nodiscard]] const problem& last_problem() const { return *problem_; }

private:
  [[nodiscard]] bool fits(const load_case& loads, int element_order, const backend& device) const;
  [[nodiscard]] expected<void> renew_conditions(const load_case& loads);
  [[nodiscard]] expected<bool> follow(const version_ptr& mesh, const load_case& loads);
  [[nodiscard]] expected<void> assemble(const version_ptr& mesh, const load_case& loads,
                                        int element_order, backend& device, const execution& run);

  version_ptr mesh_;
  std::vector<material> materials_;
  const backend* device_ = nullptr;
  std::unique_ptr<problem> problem_;
  std::unique_ptr<problem_updater> updater_;
  std::size_t renewed_rows_ = 0;
  std::unique_ptr<element_operator> operator_;
  std::unique_ptr<linear_system> system_;
  double assembly_ms_ = 0;
  double setup_ms_ = 0;
  std::vector<double> displacement_;  ///< Of the last solve on `problem_`; empty: none.
};

/// The displacement of one problem carried over to another, of another version of the part: where a
/// vertex is at the same place as before, its value; in the middle of an edge that both have, too;
/// elsewhere the mean of the neighbours. 3 per node. Cost: O(nodes log nodes).
[[nodiscard]] std::vector<double> carry_over(const problem& from,
                                             std::span<const double> displacement,
                                             const problem& to);

/// Gives the `change.fresh` nodes the mean of their neighbours' values; `u` has the values of the
/// problem before the change. Cost: the change.
void fill_fresh(const problem& p, const problem_change& change, const incidence& corners,
                std::vector<double>& u);

}  // namespace tedit::fem
