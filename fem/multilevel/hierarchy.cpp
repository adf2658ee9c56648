// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/hierarchy.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fem/multilevel/galerkin.hpp"
#include "fem/multilevel/lanczos.hpp"
#include "fem/multilevel/node_smoother.hpp"
#include "fem/polled.hpp"

namespace tedit::fem {

namespace {

node_graph graph_of(const block_matrix& k) {
  node_graph graph;
  graph.first.assign(k.rows() + 1, 0);
  polled_for(k.rows(),
             [&](std::size_t n) { graph.first[n + 1] = graph.first[n] + k.places.length(n); });
  polled_resize(graph.column, graph.first.back());
  polled_resize(graph.weight, graph.first.back());
  std::vector<float> scale(k.rows());
  parallel_for(k.rows(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n)
      scale[n] = coupling_scale(k, n);
  });
  parallel_for(k.rows(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n)
      for (std::uint32_t s = k.begin(n), to = graph.first[n]; s < k.end(n); ++s, ++to) {
        graph.column[to] = k.column[s];
        graph.weight[to] = block_norm(k, s) * scale[n] * scale[k.column[s]];
      }
  });
  return graph;
}

/// Where bulk stiffness hides shear stiffness behind the rounding of a block. At a Poisson's ratio
/// of 0.49 (49) rounded values took as many iterations, at 0.499 up to five times as many.
bool nearly_incompressible(const lame_constants& c) {
  return c.lambda > 60 * c.mu;
}

}  // namespace

std::uint64_t hierarchy::bytes() const {
  std::uint64_t sum =
    smoother.inverse.size() * 24 + exact_rows.size() + aggregate.size() * 16 + filter.size() * 24;
  for (const auto& c : smoother.clusters.inverse)
    sum += c.size() * 4;
  for (const auto& level : levels)
    sum += (level.block.size() + level.inverse.size() + level.prolongation.size()) * 144;
  return sum;
}

bool hierarchy::crowded() const {
  return members.places.crowded() || smoother.clusters.nodes.places.crowded() ||
         std::ranges::any_of(levels, [](const rigid_level& level) {
           return level.rows.crowded() || level.prolongation_rows.crowded() ||
                  level.entries.places.crowded();
         });
}

void raise_lambda(node_smoother& smoother, int nodes_per_element) {
  smoother.lambda = std::max(static_cast<float>(nodes_per_element), smoother.lambda);
}

void raise_lambdas(hierarchy& h) {
  raise_lambda(h.smoother, 4);
  h.memory->read_exactly = true;
  h.exact_rows.assign(h.arm.size(), 1);
  for (auto& level : h.levels)
    level.lambda *= 1.5F;
}

void mark_exact_rows(const block_matrix& k, hierarchy& h) {
  if (h.memory->read_exactly) {
    h.exact_rows.assign(k.rows(), 1);
    return;
  }
  h.exact_rows.clear();
  const auto& clusters = h.smoother.clusters.nodes;
  for (std::uint32_t c = 0; c < clusters.owners(); ++c)
    for (const auto n : clusters.of(c)) {
      h.exact_rows.resize(k.rows(), 0);
      h.exact_rows[n] = 1;
      for (const auto beside : k.places.of(n, k.column))
        h.exact_rows[beside] = 1;
    }
}

std::vector<float> dense_inverse(const coarsest_solver& solver, std::size_t unknowns) {
  std::vector<float> result(unknowns * unknowns);
  parallel_for(
    unknowns,
    [&](std::size_t first, std::size_t last, std::size_t) {
      std::vector<float> unit(unknowns);
      for (std::size_t i = first; i < last; ++i) {
        unit[i] = 1;
        solver.solve(unit, std::span(result).subspan(i * unknowns, unknowns));
        unit[i] = 0;
      }
    },
    32);
  for (std::size_t i = 0; i < unknowns; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const float mean = (result[i * unknowns + j] + result[j * unknowns + i]) / 2;
      result[i * unknowns + j] = result[j * unknowns + i] = mean;
    }
  return result;
}

expected<hierarchy> build_hierarchy(const problem& p, const block_matrix& k, filter_span filter,
                                    const multilevel_settings& settings, const execution& run) {
  hierarchy result;
  const auto held = wholly_held(filter.first(k.rows()));
  const auto clusters = cluster_slivers(p, held, 64, settings.sliver_condition);
  result.smoother = make_node_smoother(k, filter, clusters);
  result.memory = std::make_shared<hierarchy_memory>();
  result.memory->cluster_of = clusters.of;
  result.memory->read_exactly =
    !settings.rounded || std::ranges::any_of(p.constants, nearly_incompressible);
  mark_exact_rows(k, result);
  const auto lambda = largest_ritz_value(
    3 * k.rows(), 1, settings.lambda_steps,
    [&](const float* x, float* y) {
      for_rows(smoothed_matrix{k, result.exact_rows}, x,
               [&](std::size_t i, float4 row) { store3(row, y + 3 * i); });
    },
    [&](const float* x, float* y) { apply_inverse(result.smoother, 1, x, y); });
  result.smoother.lambda = settings.lambda_safety * lambda;
  if (run.cancel.cancelled())
    return fail(ec::cancelled, "the solve was cancelled");
  const auto aggregates = aggregate_mis2(graph_of(k), held, clusters.of, settings.weak_edge);
  result.aggregate = aggregates.of;
  result.members = member_lists(aggregates.of, aggregates.count);
  result.arm.resize(k.rows());
  auto& frames = result.memory->levels.emplace_back().frames;
  frames.resize(aggregates.count);
  parallel_for(
    aggregates.count,
    [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t a = begin; a < end; ++a)
        frames[a] = frame_of(p, result.members.of(a));
    },
    256);
  for (std::size_t a = 0; a < aggregates.count; ++a)
    for (const auto n : result.members.of(a))
      store_transfer(p, filter, frames[a], n, result);
  auto& first = result.levels.emplace_back();
  constexpr std::size_t usual_blocks = 32;  // Of a row.
  reserve_for_edits(first.column, usual_blocks * aggregates.count);
  reserve_for_edits(first.block, usual_blocks * aggregates.count);
  std::vector<std::uint32_t> rows(aggregates.count);
  std::iota(rows.begin(), rows.end(), 0u);
  make_galerkin_rows(k, rows, result);
  if (auto ok = add_rigid_levels(settings, run, result); !ok)
    return fail(ok.error());
  return result;
}

}  // namespace tedit::fem
