// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <future>
#include <map>
#include <memory>
#include <optional>

#include "fem/load_cases.hpp"
#include "fem/problem_update.hpp"

namespace tedit::fem {

/// Solves one thing after the other and keeps what the next solve can use: the assembled system
/// while mesh and materials stay (new loads or constraints never assemble again); where an edit
/// changed the mesh a little, the system with the rows that it touched renewed; and the last
/// displacement of each load case as a start. Holds one system; not for two threads at once.
///
/// A solve that is cancelled while the system follows an edit comes back at once. The system is
/// finished on a thread of its own, and the next solve waits for that and goes on from there.
class solve_session {
public:
  solve_session() = default;
  solve_session(const solve_session&) = delete;
  solve_session& operator=(const solve_session&) = delete;
  ~solve_session() { settle(); }

  struct result {
    fem::solution solution;
    bool assembled = true;         ///< False when the system of the last solve was used again.
    std::size_t renewed_rows = 0;  ///< Rows of it that an edit changed.
  };

  struct cases_result {
    solved_cases solved;
    bool assembled = true;  ///< As above.
    std::size_t renewed_rows = 0;
  };

  /// Solves load cases on one system, as `solve_cases` does. A case starts from the displacement
  /// that the one with its name had in the last solve, or else from the first one there. Errors:
  /// those of `make_cases` and `solve_cases`; what was kept stays usable or is dropped.
  [[nodiscard]] expected<cases_result> solve(const version_ptr& mesh,
                                             std::span<const load_case> loads, int element_order,
                                             backend& device, const solve_settings& settings,
                                             const execution& run,
                                             const cases_callback& on_frame = {});

  /// The same for one load case.
  [[nodiscard]] expected<result> solve(const version_ptr& mesh, const load_case& loads,
                                       int element_order, backend& device,
                                       const solve_settings& settings, const execution& run,
                                       const frame_callback& on_frame = {});

  /// Drops all that was kept: for a device that is lost.
  void forget();

  /// What the last solve was about, also while it sends frames. Not before the first one, nor after
  /// one that failed.
  [[nodiscard]] const case_set& last_set() const { return *set_; }
  [[nodiscard]] const problem& last_problem() const { return set_->problem; }

private:
  using case_list = std::span<const load_case>;
  /// Filters of nodes that are not free.
  using held_nodes = std::map<std::uint32_t, std::array<double, 6>>;

  /// A displacement of the last solve, on the present problem.
  struct kept_start {
    std::string name;  ///< Of its load case.
    std::vector<double> displacement = {};
  };

  void keep_start(const std::string& name, const std::vector<double>& displacement);

  [[nodiscard]] bool fits(case_list loads, int element_order, const backend& device) const;
  [[nodiscard]] expected<void> renew_conditions(case_list loads);
  [[nodiscard]] expected<void> prepare(const version_ptr& mesh, case_list loads, int element_order,
                                       backend& device, const execution& run);
  void drop_system();
  void settle();
  [[nodiscard]] expected<void> settle(const execution& run);
  [[nodiscard]] expected<bool> follow_beside(const version_ptr& mesh, case_list loads,
                                             const execution& run);
  [[nodiscard]] expected<bool> follow(const version_ptr& mesh, case_list loads);
  [[nodiscard]] std::vector<held_nodes> held() const;
  [[nodiscard]] expected<void> follow_conditions(case_list loads,
                                                 const std::vector<held_nodes>& before,
                                                 problem_change& changed);
  [[nodiscard]] expected<void> assemble(const version_ptr& mesh, case_list loads, int element_order,
                                        backend& device, const execution& run);
  [[nodiscard]] std::vector<solve_settings> with_starts(const solve_settings& settings) const;

  version_ptr mesh_;
  std::vector<material> materials_;
  const backend* device_ = nullptr;
  std::unique_ptr<case_set> set_;  ///< The case that stands has the filter of `system_`.
  std::unique_ptr<problem_updater> updater_;
  std::size_t renewed_rows_ = 0;  ///< By the last solve.
  bool assembled_ = false;
  std::unique_ptr<element_operator> operator_;
  std::unique_ptr<linear_system> system_;
  double assembly_ms_ = 0;
  double setup_ms_ = 0;
  std::vector<kept_start> starts_;  ///< Empty: none.
  /// `follow` at work on all of this, left by a solve that was cancelled.
  std::future<expected<bool>> following_;
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
