// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/raw_vector.hpp"
#include "fem/solver.hpp"

/// The outer iteration in double precision around a backend's inner solves; internal to fem/.
namespace tedit::fem {

/// Loads and supports of one case, as in `problem`; what they show must outlive the view.
struct conditions_view {
  std::string name;  ///< For errors; empty when there is only one case.
  std::span<const double> loads;
  std::span<const std::array<double, 6>> filter;
  std::span<const double> prescribed;
};

/// A message that starts with the load case it is about; an empty name changes nothing.
[[nodiscard]] std::string in_case(const std::string& name, const std::string& message);

/// Errors: `invalid_argument` for a tolerance that is not positive, an energy tolerance below 0 or
/// a start of another length.
[[nodiscard]] expected<void> check_settings(const problem& p, const solve_settings& settings);

/// How far one load case has come. The true residual is its own, whatever it is solved with.
class refinement {
public:
  /// Starts from the prescribed displacement, plus the multiple of the start value that has the
  /// least energy of the error. `out` takes displacement, residual and iterations. All arguments
  /// must outlive this.
  refinement(conditions_view conditions, const element_operator& k, const solve_settings& settings,
             solution& out);

  /// Errors: `invalid_load` when the case begins with no finite number.
  [[nodiscard]] expected<void> check_start() const;

  [[nodiscard]] bool done() const;
  [[nodiscard]] bool gave_up() const;
  [[nodiscard]] double progress() const;  ///< In [0, 1].
  [[nodiscard]] const solution& state() const { return *out_; }

  /// The next inner solve; `early`: end it where a first frame is wanted.
  [[nodiscard]] inner_case next(bool early);

  /// Adds the correction of the inner solve that `next` asked for. A correction that made things
  /// worse is taken back, except the first one. Returns whether it was worth its while.
  [[nodiscard]] bool take(const inner_result& inner);

  /// Errors: `not_converged` with the case and the residual that was reached.
  [[nodiscard]] tl::unexpected<error> not_converged() const;

private:
  [[nodiscard]] std::size_t nodes() const { return conditions_.filter.size(); }
  [[nodiscard]] double start_residual();
  void add_start();
  [[nodiscard]] double residual_norm();
  void add_correction(double factor);

  conditions_view conditions_;
  const element_operator* k_;
  const solve_settings* settings_;
  solution* out_;
  raw_vector<double> residual_;
  raw_vector<double> correction_;
  double norm_ = 0;    ///< Of the residual.
  double scale_ = 1;   ///< Of the last correction.
  double energy_ = 0;  ///< sqrt(u.Ku) of the displacement.
  double reference_ = 0;
  int round_ = 0;
  int stalled_ = 0;
};

/// Inner solves of all cases that are not done, until all are. `on_round(round)` is called after
/// each round that is not the last; empty: not wanted. Errors: those of the system; `invalid_load`
/// for a case that begins with no finite number; `not_converged`.
[[nodiscard]] expected<void> refine(std::span<refinement> cases, linear_system& system,
                                    const solve_settings& settings, const execution& run,
                                    const std::function<void(int round)>& on_round = {});

}  // namespace tedit::fem
