// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "base/execution.hpp"
#include "fem/multilevel/aggregation.hpp"
#include "fem/multilevel/block_rows.hpp"
#include "fem/multilevel/slivers.hpp"

namespace tedit::fem {

/// Lists of items per owner, ascending.
struct member_lists {
  row_places places;
  std::vector<std::uint32_t> item;

  member_lists() = default;
  /// `owner[i]` of every item i; `no_id` for items without one.
  member_lists(std::span<const std::uint32_t> owner, std::uint32_t owners);

  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t owner) const {
    return places.of(owner, item);
  }
  [[nodiscard]] std::uint32_t owners() const { return static_cast<std::uint32_t>(places.size()); }

  /// Gives an owner another list; owners up to it are added.
  void replace(std::uint32_t owner, std::span<const std::uint32_t> items);
};

/// Dense inverses of the nodes that slivers tie together, one symmetric matrix per cluster.
struct cluster_inverses {
  member_lists nodes;
  std::vector<std::vector<float>> inverse;  ///< (3n)^2 values each, row by row.
  std::vector<std::uint32_t> changed;       ///< By the last update, ascending.

  [[nodiscard]] bool empty() const { return inverse.empty(); }
};

/// What a Chebyshev smoother of a level with three unknowns a node needs.
struct node_smoother {
  std::vector<std::array<float, 6>> inverse;  ///< Filtered inverse blocks; zero for cluster nodes.
  cluster_inverses clusters;
  std::vector<std::uint32_t> changed;  ///< Nodes that the last update changed, ascending.
  float lambda = 1;  ///< Upper estimate of the largest eigenvalue of the smoothed operator.
};

/// One level of rigid-body unknowns: six per aggregate, three translations of its centre and three
/// rotations times its radius, all in the units of a displacement.
struct rigid_level {
  using block6 = std::array<float, 36>;  ///< Column by column.

  row_places rows;
  std::vector<std::uint32_t> column;  ///< The diagonal included.
  raw_vector<block6> block;
  raw_vector<block6> inverse;  ///< Of the diagonal blocks.
  float lambda = 1;

  /// The prolongation from the next level, empty at the coarsest.
  row_places prolongation_rows;
  std::vector<std::uint32_t> prolongation_column;
  raw_vector<block6> prolongation;
  /// The same entries by column, for the restriction: `entries.of(parent)`, and the row of each.
  member_lists entries;
  std::vector<std::uint32_t> entry_row;

  /// Rows that the last update changed, here and in `prolongation_rows`, and owners in the
  /// `entries` of the level below; ascending.
  std::vector<std::uint32_t> changed;

  [[nodiscard]] std::uint32_t nodes() const { return static_cast<std::uint32_t>(rows.size()); }
};

/// Solves the coarsest level directly; in double precision, on the host.
class coarsest_solver {
public:
  virtual ~coarsest_solver() = default;
  /// `result` may alias `right`.
  virtual void solve(std::span<const float> right, std::span<float> result) const = 0;
};

/// The inverse of the coarsest matrix with `unknowns` rows, row by row, for devices that multiply
/// with it. Cost: one solve per unknown, on all cores.
[[nodiscard]] std::vector<float> dense_inverse(const coarsest_solver& solver, std::size_t unknowns);

/// `multilevel_settings::sliver_condition` for quadratic tets, and the linear ones under them: 10 /
/// 8 / 7 / 5 gave 66 / 55 / 55 / 54 iterations on the base_so101 part and 46 / 46 / 46 / 50 on
/// heatsink_125. Linear tets alone do best with 10 (10 / 7 / 5: 25 / 27 / 28 on foot_cup).
inline constexpr double quadratic_sliver_condition = 7;

struct multilevel_settings {
  /// Edges below do not hold aggregates together: keeps aggregates within one material and one
  /// strip of a stretched mesh. 0.02 / 0.1 / 0.15 / 0.2 gave 28 / 26 / 24 / 22 iterations on the
  /// foot_cup part and larger coarse levels; 0.1 was the fastest.
  float weak_edge = 0.1F;
  /// Stop coarsening at this many aggregates. 300 took as many iterations, and 70 ms to factor at
  /// every set-up and edit.
  std::uint32_t coarsest = 100;
  int lambda_steps = 12;  ///< Lanczos steps of the eigenvalue estimates.
  float lambda_safety = 1.08F;
  double sliver_condition = 10;  ///< Tets beyond are clustered; 0: never.
  /// The smoother of the nodes reads the matrix rounded to eight bits of mantissa, half the bytes,
  /// but for `hierarchy::exact_rows`. For cycles that can.
  bool rounded = false;
};

/// How often a level's correction is repeated, and how long smoothers are.
struct cycle_settings {
  int quadratic_degree = 2;  ///< Chebyshev degree on quadratic tets.
  int node_degree = 2;       ///< On linear tets.
  int rigid_degree = 2;      ///< On the levels of rigid motions.
  int repeats = 2;           ///< Visits from each rigid level to the next one: 1 is a V, 2 a W.
  /// The correction of the rigid motions is multiplied by it: their prolongation is not smoothed,
  /// so that the coarse matrix is too stiff (Braess 1995). 1 / 1.3 / 1.6 gave 27 / 26 / 26
  /// iterations on the foot_cup part, 29 / 26 / 26 on fork_thin, 26 / 24 / 23 on holes_block.
  float over_correction = 1.5F;
};

/// An aggregation hierarchy with rigid-body modes over a matrix of linear tets (after Vanek et al.
/// 1996, with scaled modes so that all entries are of order one). The prolongation of a node is S
/// [I,
/// -[arm]x] with arm = (x - centre) / radius of its aggregate, not smoothed and not stored; the
/// levels above are small, and smoothed once: unsmoothed they doubled the iterations.
struct hierarchy_memory;

struct hierarchy {
  node_smoother smoother;  ///< Of the matrix itself.
  /// 1 for rows of it that the smoother does not read rounded: those of sliver clusters and beside
  /// them, for their inverses are exact and their blocks cancel; all where the settings or a nearly
  /// incompressible material say so, and after `raise_lambdas`. Empty: none.
  std::vector<std::uint8_t> exact_rows;
  std::vector<std::uint32_t> aggregate;   ///< Of each node; `no_id` for held ones.
  std::vector<std::array<float, 3>> arm;  ///< Of each node.
  std::vector<std::array<float, 6>>
    filter;                            ///< S of each node; empty: every aggregated node is free.
  member_lists members;                ///< Nodes of each aggregate.
  std::vector<std::uint32_t> changed;  ///< Nodes whose aggregate or arm the last update changed.
  std::vector<rigid_level> levels;
  std::unique_ptr<coarsest_solver> coarsest;
  std::shared_ptr<hierarchy_memory> memory;  ///< What `update_hierarchy` needs.

  [[nodiscard]] std::uint64_t bytes() const;
  /// Updates have left so many holes that building anew is better.
  [[nodiscard]] bool crowded() const;
};

/// Smoothers need an upper bound of the largest eigenvalue, and Lanczos gives lower ones: when the
/// cycle turns out not to be positive definite, take a bound that always holds (a product over an
/// element's nodes cannot exceed their number: Fried 1972), and more on the rigid levels.
void raise_lambda(node_smoother& smoother, int nodes_per_element);
/// The smoother reads the matrix exactly from then on, too.
void raise_lambdas(hierarchy& h);

/// Finds `h.exact_rows` after sliver clusters or rows changed. Cost: O(nodes) bytes, clusters'
/// rows.
void mark_exact_rows(const block_matrix& k, hierarchy& h);

/// S of each node: xx, xy, xz, yy, yz, zz, as in `problem`.
using filter_span = std::span<const std::array<double, 6>>;

/// Builds the hierarchy of the matrix `k` of the linear tets at the corners of `p`, filtered by
/// `filter` (of the corners).
/// Errors: `cancelled`; `not_converged` when the coarsest matrix has no factors. Cost: O(nodes),
/// about 15 products with the matrix.
[[nodiscard]] expected<hierarchy> build_hierarchy(const problem& p, const block_matrix& k,
                                                  filter_span filter,
                                                  const multilevel_settings& settings,
                                                  const execution& run);

/// Re-forms what the rows of `nodes` (ascending) touch, after these rows or filters changed: their
/// blocks, sliver clusters and aggregates, the coarse rows around, and so upwards. New nodes may
/// have been added. As good as a hierarchy built anew; a stale one needed 53 to 195 iterations
/// where a fresh one needed 25. `corners` has the elements' corners. Cost: what is touched, and a
/// factorisation of the coarsest matrix. Errors: `not_converged` when that has no factors; then `h`
/// is not to be used.
[[nodiscard]] expected<void> update_hierarchy(const problem& p, const incidence& corners,
                                              const block_matrix& k, filter_span filter,
                                              std::span<const std::uint32_t> nodes,
                                              const multilevel_settings& settings, hierarchy& h);

}  // namespace tedit::fem
