// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/vulkan_smoother.hpp"

#include <bit>

namespace tedit::fem {

namespace {

constexpr std::uint64_t entry_bytes = 48;

/// Column and nine values by rows.
using entry = std::array<std::uint32_t, 12>;

/// Block (a, b) of the inverse of a cluster with `count` nodes.
entry block_of(const std::vector<float>& inverse, std::size_t count, std::size_t a, std::size_t b,
               std::uint32_t column, double scale) {
  entry result{column};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      result[1 + 3 * i + j] = std::bit_cast<std::uint32_t>(static_cast<float>(
        scale * static_cast<double>(inverse[(3 * a + i) * 3 * count + 3 * b + j])));
  return result;
}

}  // namespace

vulkan_smoother::vulkan_smoother(vulkan_memory& memory, const row_operator& k,
                                 const node_smoother& s, filter_span filter, double scale)
    : k_(k), smoother_(s) {
  inverse_ = memory.put(packed_symmetric(std::span(s.inverse), scale));
  filter_ = memory.put(packed_symmetric(filter, 1));
  for (auto* vector : {&residual_, &first_, &second_})
    *vector = memory.room(16 * s.inverse.size());
  upload_clusters(memory, s.clusters, scale);
}

void vulkan_smoother::upload_clusters(vulkan_memory& memory, const cluster_inverses& clusters,
                                      double scale) {
  std::vector<std::array<std::uint32_t, 4>> table;
  std::vector<entry> blocks;
  const auto close = [&] {
    if (table.empty())
      return;
    clusters_.push_back(
      {static_cast<std::uint32_t>(table.size()), memory.put(table), memory.put(blocks)});
    table.clear();
    blocks.clear();
  };
  for (std::size_t c = 0; c < clusters.inverse.size(); ++c) {
    const auto nodes = clusters.nodes.of(c);
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      if ((blocks.size() + nodes.size()) * entry_bytes > memory.most_per_piece())
        close();
      table.push_back({nodes[a], static_cast<std::uint32_t>(blocks.size()),
                       static_cast<std::uint32_t>(nodes.size()), 0});
      for (std::size_t b = 0; b < nodes.size(); ++b)
        blocks.push_back(block_of(clusters.inverse[c], nodes.size(), a, b, nodes[b], scale));
    }
  }
  close();
}

void vulkan_smoother::add_clusters(vulkan_program& program, float fresh, const gpu::buffer& step,
                                   const gpu::buffer& z) const {
  for (const auto& part : clusters_) {
    cycle_push push{};
    push.rows = part.rows;
    push.fresh = fresh;
    program.add(program.kernels().cluster_rows,
                {{0, &part.table}, {1, &part.blocks}, {3, &residual_}, {5, &step}, {6, &z}}, push);
  }
}

void vulkan_smoother::move(vulkan_program& program, chebyshev_weights weights, float enter,
                           const gpu::buffer& z) {
  cycle_push push{};
  push.before = weights.before;
  push.fresh = weights.fresh;
  push.enter = enter;
  k_.add(program, TEDIT_MOVE,
         {.x = step_, .r = &residual_, .diagonal = &inverse_, .other = other_, .z = &z}, push);
  add_clusters(program, weights.fresh, *other_, z);
  std::swap(step_, other_);
}

void vulkan_smoother::from_zero(vulkan_program& program, int degree, const gpu::buffer& right,
                                const gpu::buffer& z) {
  cycle_push push{};
  push.rows = k_.rows();
  push.fresh = chebyshev_start(smoother_.lambda);
  program.add(program.kernels().node_start,
              {{2, &right}, {3, &residual_}, {4, &inverse_}, {5, step_}, {6, &z}}, push);
  add_clusters(program, push.fresh, *step_, z);
  for (int i = 2; i <= degree; ++i)
    move(program, chebyshev_step(i, smoother_.lambda), 0, z);
  k_.add(program, TEDIT_RESIDUAL, {.x = step_, .r = &residual_, .diagonal = &filter_}, {});
}

void vulkan_smoother::correction(vulkan_program& program, int degree, const gpu::buffer& z) {
  move(program, {0, chebyshev_start(smoother_.lambda)}, 1, z);
  for (int i = 2; i <= degree; ++i)
    move(program, chebyshev_step(i, smoother_.lambda), 0, z);
}

}  // namespace tedit::fem
