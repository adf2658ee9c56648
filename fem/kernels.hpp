// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/execution.hpp"
#include "fem/problem_update.hpp"

namespace tedit::fem {

/// Which device does the work.
struct device_info {
  std::string name;    ///< "cpu", "llvmpipe (LLVM 15.0.6, 256 bits)", "NVIDIA H200", ...
  std::string kind;    ///< "native", "software", "integrated", "discrete".
  std::string driver;  ///< Driver name and version; empty for native.
  std::uint64_t memory_bytes = 0;  ///< 0 when unknown.
  /// What a person should know about how it was chosen: which others failed. Mostly empty.
  std::string notice = {};
};

/// How an inner solve ended.
struct inner_result {
  int iterations = 0;
  /// sqrt(delta / delta_0) of the preconditioned recurrence: steers the loop, never an accuracy
  /// claim.
  double recurrence_reduction = 1;
  /// A bound of the energy norm sqrt(e.Ke) of what is left of the error; N^.5 m^.5. As sure as the
  /// system knows its smallest eigenvalue, from the solves before.
  double energy = 0;
  double gained = 0;        ///< By how much e.Ke has fallen, N m.
  bool broke_down = false;  ///< p.Kp <= 0, r.z <= 0 or a number that is not finite.
};

/// One right-hand side of several for the same matrix.
struct inner_case {
  std::span<const double> residual;  ///< N, 3 per node.
  std::span<double> correction;      ///< m, 3 per node; written.
  double reduction = 1e-4;           ///< It ends when sqrt(r.Br) has fallen by this,
  double energy = 0;                 ///< or sqrt(e.Ke) is below this, N^.5 m^.5,
  double share = 0;                  ///< or below this times the root of what was gained,
  double residual_reduction = 0;     ///< or when |r| has fallen by this.
};

/// A matrix on a device, with its filter and preconditioner: assembled once per version.
class linear_system {
public:
  virtual ~linear_system() = default;

  /// Solves S K S d = S r for the correction d of each case, starting from d = 0, by preconditioned
  /// conjugate gradients (MPCG) until the case's own goal or for `max_iterations`; results in their
  /// order. A case's answer does not depend on the others beyond rounding. Checks `run.cancel` at
  /// least every 50 ms. Errors: `cancelled`, `device_lost`, `out_of_memory`.
  [[nodiscard]] virtual expected<std::vector<inner_result>> solve_many(
    std::span<const inner_case> cases, int max_iterations, const execution& run) = 0;

  /// `solve_many` of one case.
  [[nodiscard]] expected<inner_result> solve(const inner_case& one, int max_iterations,
                                             const execution& run) {
    const auto results = solve_many({&one, 1}, max_iterations, run);
    if (!results)
      return fail(results.error());
    return results->front();
  }

  /// The last correction did not reduce the true residual: make the preconditioner safer, if there
  /// is anything to make safer.
  virtual void distrust() {}

  /// Replaces the constraint filter; the matrix stays. Cost: O(nodes).
  [[nodiscard]] virtual expected<void> set_filter(
    std::span<const std::array<double, 6>> filter) = 0;

  /// The problem was carried on by `problem_updater`, and its loads and constraints are set: renews
  /// the rows of `change.nodes` and what stands on them; `corners` has the elements' corners now.
  /// False when this system cannot: it is lost then, assemble another one. Cost: the change.
  [[nodiscard]] virtual expected<bool> update(const problem_change& change,
                                              const incidence& corners) {
    static_cast<void>(change);
    static_cast<void>(corners);
    return false;
  }

  /// y = K x in the device's own precision and storage: for tests against the native backend.
  [[nodiscard]] virtual expected<void> multiply(std::span<const double> x, std::span<double> y) = 0;

  /// Milliseconds of the stages of `assemble`: pattern and values.
  [[nodiscard]] virtual double assembly_ms() const = 0;

  /// Bytes held on the device.
  [[nodiscard]] virtual std::uint64_t device_bytes() const = 0;

  /// Bytes that the last `assemble`, `set_filter` or `update` sent to the device, vectors excepted.
  [[nodiscard]] virtual std::uint64_t uploaded_bytes() const { return 0; }
};

/// A place where problems are assembled and solved. The native one is the tests' oracle and the
/// fallback without a GPU.
class backend {
public:
  virtual ~backend() = default;

  [[nodiscard]] virtual const device_info& info() const = 0;

  /// Builds sparsity pattern, stiffness blocks (by gather, no atomics) and preconditioner, all on
  /// the host, and sends a device what it needs of them (docs/decisions/0007). The problem must
  /// outlive the system. Errors: `out_of_memory` (estimated before allocating), `device_lost`,
  /// `device_unavailable` for a part in more separate pieces than the device takes,
  /// `not_converged` when the preconditioner cannot be set up, `cancelled`.
  [[nodiscard]] virtual expected<std::unique_ptr<linear_system>> assemble(const problem& p,
                                                                          const execution& run) = 0;
};

}  // namespace tedit::fem
