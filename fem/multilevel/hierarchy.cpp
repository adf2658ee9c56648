// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/hierarchy.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

#include "fem/multilevel/lanczos.hpp"
#include "fem/multilevel/node_smoother.hpp"
#include "fem/multilevel/rigid_levels.hpp"

namespace tedit::fem {

namespace {

constexpr std::size_t aggregates_per_chunk = 64;

float norm9(const float* v) {
  float sum = 0;
  for (int i = 0; i < 9; ++i)
    sum += v[i] * v[i];
  return std::sqrt(sum);
}

node_graph graph_of(const block_matrix& k) {
  node_graph graph{k.places.starts(), k.column, std::vector<float>(k.column.size())};
  const auto diagonal = diagonal_blocks(k);
  std::vector<float> scale(k.rows());
  for (std::size_t n = 0; n < k.rows(); ++n) {
    const auto& d = diagonal[n];
    const float square =
      d[0] * d[0] + d[3] * d[3] + d[5] * d[5] + 2 * (d[1] * d[1] + d[2] * d[2] + d[4] * d[4]);
    scale[n] = square > 0 ? 1 / std::sqrt(std::sqrt(square)) : 0;
  }
  parallel_for(k.rows(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n)
      for (auto s = k.begin(n); s < k.end(n); ++s)
        graph.weight[s] = norm9(&k.value[9 * std::size_t{s}]) * scale[n] * scale[k.column[s]];
  });
  return graph;
}

bool is_held(const std::array<double, 6>& s) {
  return s[0] + s[3] + s[5] < 1e-9;
}

bool is_free(const std::array<double, 6>& s) {
  return s[0] + s[3] + s[5] > 3 - 1e-9;
}

std::vector<rigid_frame> frames_of(const problem& p, const member_lists& members) {
  std::vector<rigid_frame> frames(members.owners());
  for (std::size_t a = 0; a < frames.size(); ++a) {
    const auto nodes = members.of(a);
    const auto count = static_cast<double>(nodes.size());
    for (const auto n : nodes)
      frames[a].centre += p.nodes[n] / count;
    double square = 0;
    for (const auto n : nodes)
      square += dot(p.nodes[n] - frames[a].centre, p.nodes[n] - frames[a].centre) / count;
    frames[a].radius = square > 0 ? std::sqrt(square) : 1;
  }
  return frames;
}

Eigen::Matrix3d symmetric(const std::array<double, 6>& s) {
  Eigen::Matrix3d m;
  m << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
  return m;
}

/// The coarse matrix P^T K P, row by row.
class galerkin_product {
public:
  galerkin_product(const problem& p, const block_matrix& k, filter_span filter, const hierarchy& h,
                   const std::vector<rigid_frame>& frames)
      : p_(p), k_(k), filter_(filter), h_(h), frames_(frames) {}

  void run(rigid_rows& rows, std::vector<matrix6>& keep) const {
    rows.column.resize(frames_.size());
    rows.block.resize(frames_.size());
    keep.resize(frames_.size());
    parallel_for(
      frames_.size(),
      [&](std::size_t first, std::size_t last, std::size_t) {
        for (std::size_t a = first; a < last; ++a) {
          row_sum sum;
          matrix6 gram = matrix6::Zero();
          for (const auto n : h_.members.of(a))
            add_node(n, gram, sum);
          keep[a] = remove_null_motions(gram, sum.at(static_cast<std::uint32_t>(a)));
          sum.finish(rows.column[a], rows.block[a]);
        }
      },
      aggregates_per_chunk);
  }

private:
  [[nodiscard]] matrix36 modes(std::uint32_t n) const {
    const auto& frame = frames_[h_.aggregate[n]];
    const matrix36 p = rigid_modes((p_.nodes[n] - frame.centre) / frame.radius);
    return is_free(filter_[n]) ? p : matrix36(symmetric(filter_[n]) * p);
  }

  void add_node(std::uint32_t i, matrix6& gram, row_sum& sum) const {
    const matrix36 own = modes(i);
    gram += own.transpose() * own;
    // K_ij P_j first summed over the nodes j of each aggregate.
    std::array<std::uint32_t, 32> there{};
    std::array<matrix36, 32> part;
    std::size_t used = 0;
    Eigen::Matrix3d diagonal = Eigen::Matrix3d::Zero();
    const auto flush = [&] {
      for (std::size_t u = 0; u < used; ++u)
        sum.at(there[u]).noalias() += own.transpose() * part[u];
      used = 0;
    };
    for (auto s = k_.begin(i); s < k_.end(i); ++s) {
      const Eigen::Matrix3d block =
        Eigen::Map<const Eigen::Matrix3f>(&k_.value[9 * std::size_t{s}]).cast<double>();
      diagonal -= block;
      const auto j = k_.column[s];
      const auto to = h_.aggregate[j];
      if (to == no_id)
        continue;
      std::size_t u = 0;
      while (u < used && there[u] != to)
        ++u;
      if (u == used) {
        if (used == there.size())
          flush();
        u = used++;
        there[u] = to;
        part[u].setZero();
      }
      part[u].noalias() += block * modes(j);
    }
    flush();
    sum.at(h_.aggregate[i]).noalias() += own.transpose() * (diagonal * own);
  }

  const problem& p_;
  const block_matrix& k_;
  filter_span filter_;
  const hierarchy& h_;
  const std::vector<rigid_frame>& frames_;
};

void store_transfer(const problem& p, filter_span filter, const std::vector<rigid_frame>& frames,
                    hierarchy& h) {
  const std::size_t nodes = h.aggregate.size();
  h.arm.assign(nodes, {});
  bool filtered = false;
  for (std::size_t n = 0; n < nodes; ++n) {
    if (h.aggregate[n] == no_id)
      continue;
    const auto& frame = frames[h.aggregate[n]];
    const vec3 arm = (p.nodes[n] - frame.centre) / frame.radius;
    h.arm[n] = {static_cast<float>(arm.x), static_cast<float>(arm.y), static_cast<float>(arm.z)};
    filtered = filtered || !is_free(filter[n]);
  }
  if (!filtered)
    return;
  h.filter.resize(nodes);
  for (std::size_t n = 0; n < nodes; ++n)
    std::ranges::transform(filter[n], h.filter[n].begin(),
                           [](double s) { return static_cast<float>(s); });
}

}  // namespace

std::uint64_t hierarchy::bytes() const {
  std::uint64_t sum = smoother.inverse.size() * 24 + aggregate.size() * 16 + filter.size() * 24;
  for (const auto& c : smoother.clusters.inverse)
    sum += c.size() * 4;
  for (const auto& level : levels)
    sum += (level.block.size() + level.inverse.size() + level.prolongation.size()) * 144;
  return sum;
}

void raise_lambda(node_smoother& smoother, int nodes_per_element) {
  smoother.lambda = std::max(static_cast<float>(nodes_per_element), smoother.lambda);
}

void raise_lambdas(hierarchy& h) {
  raise_lambda(h.smoother, 4);
  for (auto& level : h.levels)
    level.lambda *= 1.5F;
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
  std::vector<std::uint8_t> held(k.rows());
  for (std::size_t n = 0; n < held.size(); ++n)
    held[n] = is_held(filter[n]) ? 1 : 0;
  sliver_clusters clusters;
  if (settings.sliver_condition > 0)
    clusters = cluster_slivers(p, held, 64, settings.sliver_condition);
  result.smoother = make_node_smoother(k, filter, clusters);
  const auto lambda = largest_ritz_value(
    3 * k.rows(), 1, settings.lambda_steps,
    [&](const float* x, float* y) {
      for_rows(k, x, [&](std::size_t i, float4 row) {
        store3(row, y + 3 * i);
        return 0.0F;
      });
    },
    [&](const float* x, float* y) { apply_inverse(result.smoother, 1, x, y); });
  result.smoother.lambda = settings.lambda_safety * lambda;
  if (run.cancel.cancelled())
    return fail(ec::cancelled, "the solve was cancelled");
  const auto aggregates = aggregate_mis2(graph_of(k), held, clusters.of, settings.weak_edge);
  result.aggregate = aggregates.of;
  result.members = member_lists(aggregates.of, aggregates.count);
  auto frames = frames_of(p, result.members);
  store_transfer(p, filter, frames, result);
  rigid_rows rows;
  std::vector<matrix6> keep;
  galerkin_product(p, k, filter, result, frames).run(rows, keep);
  if (auto ok = add_rigid_levels(std::move(rows), std::move(frames), std::move(keep), settings, run,
                                 result);
      !ok)
    return fail(ok.error());
  return result;
}

}  // namespace tedit::fem
