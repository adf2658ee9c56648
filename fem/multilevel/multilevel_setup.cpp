// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/multilevel_setup.hpp"

#include <algorithm>

#include "fem/multilevel/lanczos.hpp"
#include "fem/multilevel/node_smoother.hpp"

namespace tedit::fem {

multilevel_setup::multilevel_setup(const problem& p, const multilevel_settings& settings)
    : problem_(p), settings_(settings), blocks_(assemble_blocks(p, incidence(p, 4))) {}

expected<void> multilevel_setup::prepare(filter_span filter, const product& k,
                                         const execution& run) {
  auto built = build_hierarchy(problem_, blocks_, at_corners(filter), settings_, run);
  if (!built)
    return fail(built.error());
  hierarchy_ = std::move(*built);
  return problem_.element_order == 1 ? expected<void>{} : prepare_quadratic(filter, k);
}

expected<void> multilevel_setup::prepare_quadratic(filter_span filter, const product& k) {
  edges_ = make_edge_transfer(problem_);
  auto clusters = cluster_slivers(problem_, wholly_held(filter), 100, settings_.sliver_condition);
  smoother_ = make_quadratic_smoother(problem_, filter, clusters);
  cluster_of_ = std::move(clusters.of);
  expected<void> status;
  const float largest = largest_ritz_value(
    problem_.dofs(), 1, settings_.lambda_steps,
    [&](const float* x, float* y) {
      if (status)  // The first failure counts, and a device that hangs is asked once.
        status = k(x, y);
    },
    [&](const float* x, float* y) { apply_inverse(smoother_, 1, x, y); });
  smoother_.lambda = settings_.lambda_safety * largest;
  return status;
}

bool multilevel_setup::update(const problem_change& change, const incidence& corners) {
  if (blocks_.places.crowded() || hierarchy_.crowded() || edges_.middles.places.crowded())
    return false;
  const filter_span filter = problem_.filter;
  update_blocks(problem_, corners, changed_corners(change), blocks_);
  if (!update_hierarchy(problem_, corners, blocks_, at_corners(filter), changed_corners(change),
                        settings_, hierarchy_))
    return false;
  if (problem_.element_order == 1)
    return true;
  update_edge_transfer(problem_, edges_);
  update_quadratic_smoother(problem_, corners, filter, change.nodes, settings_, cluster_of_,
                            smoother_);
  return true;
}

void multilevel_setup::raise_bounds() {
  raise_lambda(smoother_, 10);
  raise_lambdas(hierarchy_);
}

std::uint64_t multilevel_setup::bytes() const {
  return blocks_.bytes() + hierarchy_.bytes() + 24 * smoother_.inverse.size();
}

std::span<const std::uint32_t> multilevel_setup::changed_corners(
  const problem_change& change) const {
  return {change.nodes.begin(), std::ranges::lower_bound(
                                  change.nodes, static_cast<std::uint32_t>(problem_.corner_count))};
}

}  // namespace tedit::fem
