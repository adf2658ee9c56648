// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/vulkan_cycle.hpp"

#include <bit>

namespace tedit::fem {

namespace {

constexpr std::uint64_t block_bytes = 9 * 16;

rigid_level::block6 scaled(const rigid_level::block6& block, double factor) {
  rigid_level::block6 result;
  std::ranges::transform(block, result.begin(), [&](float v) {
    return static_cast<float>(factor * static_cast<double>(v));
  });
  return result;
}

rigid_level::block6 transposed(const rigid_level::block6& block) {
  rigid_level::block6 result;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      result[6 * i + j] = block[6 * j + i];
  return result;
}

/// Entry k of row i at k * rows + i, three columns each; see dense.comp.
std::vector<device_float4> packed_dense(const std::vector<float>& inverse, std::size_t size,
                                        double scale) {
  std::vector<device_float4> result(size / 3 * size);
  for (std::size_t k = 0; k < size / 3; ++k)
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        result[k * size + i][c] =
          static_cast<float>(scale * static_cast<double>(inverse[i * size + 3 * k + c]));
  return result;
}

}  // namespace

// -- rows of rigid motions ---------------------------------------------------------------

template <class Entry>
vulkan_rigid_rows::vulkan_rigid_rows(vulkan_memory& memory, std::span<const std::uint32_t> first,
                                     Entry&& entry) {
  const auto rows = static_cast<std::uint32_t>(first.size() - 1);
  const std::uint64_t most = memory.most_per_piece() / block_bytes;
  for (std::uint32_t row = 0; row < rows;) {
    std::uint32_t last = row + 1;
    while (last < rows && first[last + 1] - first[row] <= most)
      ++last;
    std::vector<std::uint32_t> begin;
    std::vector<std::uint32_t> columns;
    std::vector<rigid_level::block6> blocks;
    for (auto i = row; i <= last; ++i)
      begin.push_back(first[i] - first[row]);
    for (auto s = first[row]; s < first[last]; ++s) {
      const auto [column, block] = entry(s);
      columns.push_back(column);
      blocks.push_back(block);
    }
    parts_.push_back({row, last - row, memory.put(begin), memory.put(columns), memory.put(blocks)});
    row = last;
  }
}

void vulkan_rigid_rows::add(vulkan_program& program, std::uint32_t mode, const row_buffers& at,
                            cycle_push push) const {
  for (const auto& part : parts_) {
    push.first_row = part.first_row;
    push.rows = part.rows;
    program.add(program.kernels().rigid_rows[mode],
                {{0, &part.first},
                 {1, &part.columns},
                 {2, at.x},
                 {3, at.r},
                 {4, at.diagonal ? at.diagonal : at.x},
                 {5, at.other ? at.other : at.r},
                 {6, at.z ? at.z : at.r},
                 {8, &part.blocks}},
                push);
  }
}

// -- levels of rigid motions -------------------------------------------------------------

vulkan_rigid_cycle::vulkan_rigid_cycle(vulkan_memory& memory, const hierarchy& h,
                                       const cycle_settings& settings, double scale)
    : settings_(settings) {
  for (const auto& from : h.levels)
    upload(memory, from, &from == &h.levels.back(), scale);
  const std::size_t size = std::size_t{6} * h.levels.back().nodes();
  dense_ = memory.put(packed_dense(dense_inverse(*h.coarsest, size), size, scale));
}

void vulkan_rigid_cycle::upload(vulkan_memory& memory, const rigid_level& from, bool last,
                                double scale) {
  auto& to = levels_.emplace_back();
  to.host = &from;
  const std::uint64_t bytes = std::uint64_t{32} * from.nodes();
  to.right = memory.room(bytes);
  to.z = memory.room(bytes);
  if (last)
    return;
  for (auto* vector : {&to.again, &to.residual, &to.first, &to.second})
    *vector = memory.room(bytes);
  std::vector<rigid_level::block6> inverse;
  for (const auto& block : from.inverse)
    inverse.push_back(scaled(block, scale));
  to.inverse = memory.put(inverse);
  to.matrix.emplace(memory, from.rows.starts(), [&](std::uint32_t s) {
    return std::pair(from.column[s], scaled(from.block[s], 1 / scale));
  });
  to.up.emplace(memory, from.prolongation_rows.starts(), [&](std::uint32_t s) {
    return std::pair(from.prolongation_column[s], from.prolongation[s]);
  });
  to.down.emplace(memory, from.entries.places.starts(), [&](std::uint32_t s) {
    const auto at = from.entries.item[s];
    return std::pair(from.entry_row[at], transposed(from.prolongation[at]));
  });
}

void vulkan_rigid_cycle::move(vulkan_program& program, level& l, chebyshev_weights weights,
                              float enter) {
  cycle_push push{};
  push.before = weights.before;
  push.fresh = weights.fresh;
  push.enter = enter;
  l.matrix->add(
    program, TEDIT_MOVE,
    {.x = l.step, .r = &l.residual, .diagonal = &l.inverse, .other = l.other, .z = &l.z}, push);
  std::swap(l.step, l.other);
}

void vulkan_rigid_cycle::solve(vulkan_program& program, std::size_t at) {
  auto& l = levels_[at];
  if (at + 1 == levels_.size()) {
    cycle_push push{};
    push.rows = 6 * l.host->nodes();
    push.count = 2 * l.host->nodes();
    program.add(program.kernels().dense, {{0, &dense_}, {2, &l.right}, {6, &l.z}}, push);
    return;
  }
  once(program, at, l.right, false);
  for (int again = 1; again < settings_.repeats; ++again) {
    l.matrix->add(program, TEDIT_RESIDUAL, {.x = &l.z, .r = &l.right, .other = &l.again}, {});
    once(program, at, l.again, true);
  }
}

void vulkan_rigid_cycle::once(vulkan_program& program, std::size_t at, const gpu::buffer& right,
                              bool again) {
  auto& l = levels_[at];
  const float lambda = l.host->lambda;
  cycle_push push{};
  push.rows = l.host->nodes();
  push.fresh = chebyshev_start(lambda);
  push.enter = again ? 1 : 0;
  program.add(program.kernels().rigid_start,
              {{2, &right}, {3, &l.residual}, {4, &l.inverse}, {5, l.step}, {6, &l.z}}, push);
  for (int k = 2; k <= settings_.rigid_degree; ++k)
    move(program, l, chebyshev_step(k, lambda), 0);
  l.matrix->add(program, TEDIT_RESIDUAL, {.x = l.step, .r = &l.residual, .other = &l.residual}, {});
  auto& next = levels_[at + 1];
  l.down->add(program, TEDIT_MULTIPLY, {.x = &l.residual, .r = &next.right}, {});
  solve(program, at + 1);
  l.up->add(program, TEDIT_MULTIPLY, {.x = &next.z, .r = l.step}, {});
  move(program, l, {0, chebyshev_start(lambda)}, 1);
  for (int k = 2; k <= settings_.rigid_degree; ++k)
    move(program, l, chebyshev_step(k, lambda), 0);
}

// -- cycles ------------------------------------------------------------------------------

vulkan_cycle::vulkan_cycle(vulkan_memory& memory, const row_operator& k, const hierarchy& h,
                           filter_span filter, const cycle_settings& settings, double scale)
    : settings_(settings),
      nodes_(k.rows()),
      aggregates_(h.levels.front().nodes()),
      smoother_(memory, k, h.smoother, filter, scale),
      rigid_(memory, h, settings, scale) {
  std::vector<std::array<std::uint32_t, 4>> arms(nodes_);
  for (std::size_t n = 0; n < nodes_; ++n) {
    for (int i = 0; i < 3; ++i)
      arms[n][i] = std::bit_cast<std::uint32_t>(h.arm[n][i]);
    arms[n][3] = h.aggregate[n];
  }
  arms_ = memory.put(arms);
  member_first_ = memory.put(h.members.places.starts());
  members_ = memory.put(h.members.item);
}

void vulkan_cycle::add(vulkan_program& program, const gpu::buffer& right, const gpu::buffer& z) {
  const auto& kernels = program.kernels();
  smoother_.from_zero(program, settings_.node_degree, right, z);
  cycle_push push{};
  push.rows = aggregates_;
  program.add(kernels.rigid_down,
              {{0, &member_first_},
               {1, &members_},
               {2, &arms_},
               {3, &smoother_.residual()},
               {6, &rigid_.right()}},
              push);
  rigid_.add(program);
  push.rows = nodes_;
  push.count = aggregates_;
  program.add(kernels.rigid_up,
              {{0, &arms_}, {2, &rigid_.z()}, {4, &smoother_.filter()}, {5, &smoother_.step()}},
              push);
  smoother_.correction(program, settings_.node_degree, z);
}

vulkan_quadratic_cycle::vulkan_quadratic_cycle(vulkan_memory& memory, const row_operator& k,
                                               const node_smoother& s, const edge_transfer& edges,
                                               filter_span filter, vulkan_cycle& corners,
                                               int degree, double scale)
    : nodes_(k.rows()),
      corner_count_(static_cast<std::uint32_t>(edges.corners())),
      degree_(degree),
      smoother_(memory, k, s, filter, scale),
      corners_(corners) {
  std::vector<std::uint32_t> middles;
  for (const auto side : edges.middles.item)
    middles.push_back(corner_count_ + side / 2);
  ends_ = memory.put(edges.ends);
  middle_first_ = memory.put(edges.middles.places.starts());
  middles_ = memory.put(middles);
  coarse_right_ = memory.room(16 * std::uint64_t{corner_count_});
  coarse_ = memory.room(16 * std::uint64_t{corner_count_});
}

void vulkan_quadratic_cycle::add(vulkan_program& program, const gpu::buffer& right,
                                 const gpu::buffer& z) {
  const auto& kernels = program.kernels();
  smoother_.from_zero(program, degree_, right, z);
  cycle_push push{};
  push.rows = corner_count_;
  program.add(
    kernels.edge_down,
    {{0, &middle_first_}, {1, &middles_}, {3, &smoother_.residual()}, {6, &coarse_right_}}, push);
  corners_.add(program, coarse_right_, coarse_);
  push.rows = nodes_;
  push.count = corner_count_;
  program.add(kernels.edge_up,
              {{0, &ends_}, {2, &coarse_}, {4, &smoother_.filter()}, {5, &smoother_.step()}}, push);
  smoother_.correction(program, degree_, z);
}

}  // namespace tedit::fem
