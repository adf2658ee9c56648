// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "fem/element_operator.hpp"
#include "fem/kernels.hpp"
#include "fem/solve_report.hpp"

namespace tedit::fem {

struct solution;

struct solve_settings {
  double tolerance =
    1e-6;  ///< True relative residual |S(f - Ku)| / |S(f - K z)| of a final result.
  /// Stop already when the estimated error in the energy norm is below this; 0: never. Such a
  /// result is not `converged`.
  double energy_tolerance = 0;
  /// Where the first frame is wanted: estimated relative error in the energy norm.
  double preview_energy = 1e-2;
  double inner_reduction =
    1e-4;  ///< Reduction of each inner solve; 1e-4 measured best in fp32 (bench/FIGURES.md).
  int max_inner_iterations = 20000;
  int max_outer_rounds = 20;
  /// A start value, 3 per node; empty for zero. It is scaled so that its energy error is least.
  std::vector<double> start;
};

/// One frame while a solve converges.
struct solve_frame {
  int outer_round = 0;
  int iterations = 0;
  double true_relative_residual = 1;
  double energy_error = 1;  ///< Estimated, relative; see `solution::energy_error`.
  /// Everything that a solution has, as it is now, not `converged`. Costs a recovery.
  std::function<expected<solution>()> recover;
};

/// What the constraints of one surface push on the part.
struct surface_reaction {
  surface_id surface = 0;
  vec3 force_n;
};

/// A node whose stress says how fine the mesh is, not how strong the part is. Rule and weakness:
/// fem/error_estimate.hpp.
struct singular_place {
  std::uint32_t node = 0;
  singularity kind = singularity::clamp_rim;
  vec3 at;
  double von_mises_pa = 0;
};

/// A solved problem. Arrays are indexed by the problem's nodes or elements. Nodal values of order 2
/// are means of the corner values of the elements around, by volume; mid nodes take the mean of
/// their ends.
struct solution {
  /// Cap of safety factors, so that a place without stress has a number, too.
  static constexpr double most_safety = 1e6;

  std::vector<double> displacement;  ///< m, 3 per node.
  std::vector<double> reactions;     ///< N, 3 per node: K u - f on constrained directions.
  // What follows is at corner nodes alone: stress and strain of quadratic tets in the middle of an
  // edge are the means of its ends.
  std::vector<double> nodal_stress;  ///< Pa, 6 per corner node.
  /// Pa: of the nodal stress; order 2: where materials meet the largest of any one.
  std::vector<double> von_mises;
  std::vector<double> nodal_strain;      ///< 6 as the stress; shears are engineering shears.
  std::vector<double> principal_stress;  ///< Pa, 3 per corner node, descending.
  /// Yield strength over von Mises stress, at most `most_safety`; 0 where the yield
  /// strength is unknown. Empty when it is unknown everywhere.
  std::vector<double> safety_factor;
  /// Estimated error of each element in the energy norm, sqrt(J): fem/error_estimate.hpp.
  std::vector<float> element_error;
  /// The same at each corner node, relative: the density of the error around it, sqrt(sum eta_e^2 /
  /// sum V_e) over its elements, over that of the energy of the whole part, sqrt((2 U + sum eta^2)
  /// / V). So 0.05 says that the error there is 5 % of the part's mean stress in that norm, and the
  /// mean square over the volume is `relative_error` squared. 0 at nodes without elements, and
  /// everywhere without any energy.
  std::vector<double> nodal_error;

  int element_order = 1;
  bool converged = false;  ///< The true residual is within the tolerance.
  int iterations = 0;
  /// Relative error in the energy norm against the exact solution of the equations: an upper bound
  /// as far as the system knows its smallest eigenvalue (fem/multilevel/energy_bound.hpp).
  double energy_error = 1;
  double true_relative_residual =
    1;  ///< Computed in fp64 on the host from the elements, independent of the device.
  double max_displacement_m = 0;
  vec3 max_displacement_at;
  double compliance_j =
    0;  ///< f.u, work of the loads (strain energy x 2 without prescribed motion).
  double max_von_mises_pa = 0;  ///< Order 1: largest element value. Order 2: largest nodal value.
  vec3 max_von_mises_at;        ///< Centroid of the element, or the node.
  std::uint32_t max_von_mises_element = no_id;  ///< Order 1: the element.
  double min_safety_factor = 0;  ///< Smallest nodal one; 0 when no yield strength is known.
  vec3 min_safety_factor_at;
  double strain_energy_j = 0;  ///< u.Ku / 2.
  double mass_kg = 0;          ///< 0 when a density is unknown.
  bool mass_known = false;
  double relative_error = 0;  ///< sqrt(sum eta_e^2 / (2 strain energy + sum eta_e^2)): an estimate.
  std::vector<singular_place> singular_places;      ///< By descending stress.
  std::vector<surface_reaction> surface_reactions;  ///< By surface; their sum is `reaction_n`.
  vec3 reaction_n;
  vec3 applied_n;

  double assembly_ms = 0;
  double setup_ms = 0;
  double solve_ms = 0;
  double recovery_ms = 0;
  std::string device;

  /// Linear tets lock in bending (docs/decisions/0004): results of order 1 are previews wherever
  /// they show, and so is what has not converged.
  [[nodiscard]] bool preview() const { return element_order < 2 || !converged; }
};

using frame_callback = std::function<void(const solve_frame&)>;

/// Assembles and solves: fp64 residuals on the host around the backend's inner solves (iterative
/// refinement), then recovery. `on_frame` is called after each outer round, from this thread.
/// Errors: those of the backend; `not_converged` with the residual that was reached; `cancelled`.
[[nodiscard]] expected<solution> solve(const problem& p, backend& device,
                                       const solve_settings& settings, const execution& run,
                                       const frame_callback& on_frame = {});

/// The same on a system that stands already; `device` names it in the result. Its filter must be
/// that of `p`.
[[nodiscard]] expected<solution> solve(const problem& p, const element_operator& k,
                                       linear_system& system, const std::string& device,
                                       const solve_settings& settings, const execution& run,
                                       const frame_callback& on_frame = {});

/// r = f - K u in fp64 from the elements, 3 values per node; multi-threaded, no matrix is stored.
void residual(const problem& p, std::span<const double> displacement, std::span<double> result);

/// Backends by name: "cpu", "lavapipe", "auto", or part of a device's name.
/// `auto` takes the fastest by a short measured trial, cached in $XDG_CACHE_HOME/tedit.
/// Errors: `device_unavailable` listing the devices that there are.
[[nodiscard]] expected<std::unique_ptr<backend>> open_backend(const std::string& name);

/// Every device that `open_backend` knows here, the native one included.
[[nodiscard]] std::vector<device_info> list_devices();

}  // namespace tedit::fem
