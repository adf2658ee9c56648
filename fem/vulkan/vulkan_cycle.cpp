// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/vulkan_cycle.hpp"

#include <bit>

#include "fem/polled.hpp"

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

vulkan_rigid_rows::source matrix_rows(const rigid_level& level, double scale) {
  return {[&] { return level.nodes(); }, [&](std::uint32_t row) { return level.rows.length(row); },
          [&, scale](std::uint32_t row, std::uint32_t k) {
            const auto at = level.rows.begin(row) + k;
            return std::pair(level.column[at], scaled(level.block[at], scale));
          }};
}

vulkan_rigid_rows::source prolongation_rows(const rigid_level& level) {
  const auto& rows = level.prolongation_rows;
  return {[&] { return static_cast<std::uint32_t>(rows.size()); },
          [&](std::uint32_t row) { return rows.length(row); },
          [&](std::uint32_t row, std::uint32_t k) {
            const auto at = rows.begin(row) + k;
            return std::pair(level.prolongation_column[at], level.prolongation[at]);
          }};
}

vulkan_rigid_rows::source restriction_rows(const rigid_level& level) {
  return {[&] { return level.entries.owners(); },
          [&](std::uint32_t row) { return level.entries.places.length(row); },
          [&](std::uint32_t row, std::uint32_t k) {
            const auto at = level.entries.of(row)[k];
            return std::pair(level.entry_row[at], transposed(level.prolongation[at]));
          }};
}

}  // namespace

// -- rows of rigid motions ---------------------------------------------------------------

vulkan_rigid_rows::vulkan_rigid_rows(vulkan_memory& memory, source from) : from_(std::move(from)) {
  const auto rows = from_.rows();
  const std::uint64_t most = memory.most_per_piece() / block_bytes;
  for (std::uint32_t row = 0; row < rows;) {
    const auto first = row;
    std::vector<std::uint32_t> lengths;
    std::uint64_t entries = 0;
    for (; row < rows; ++row) {
      const auto length = from_.length(row);
      if (!lengths.empty() && entries + length > most - most / 8)
        break;
      lengths.push_back(length);
      entries += length;
    }
    add_piece(memory, first, lengths);
  }
}

void vulkan_rigid_rows::add_piece(vulkan_memory& memory, std::uint32_t first_row,
                                  std::span<const std::uint32_t> lengths) {
  auto& part = parts_.emplace_back();
  part.first_row = first_row;
  part.rows = static_cast<std::uint32_t>(lengths.size());
  part.table = vulkan_row_table(memory, lengths, 4, memory.most_per_piece() / block_bytes);
  std::vector<std::uint32_t> columns;
  std::vector<rigid_level::block6> blocks;
  polled_for(
    part.rows,
    [&](std::size_t row) {
      append_row(first_row + static_cast<std::uint32_t>(row), columns, blocks);
    },
    1024);
  part.columns = memory.put(columns, part.table.places().room());
  part.blocks = memory.put(blocks, part.table.places().room());
}

void vulkan_rigid_rows::append_row(std::uint32_t row, std::vector<std::uint32_t>& columns,
                                   std::vector<rigid_level::block6>& blocks) const {
  for (std::uint32_t k = 0, count = from_.length(row); k < count; ++k) {
    const auto [column, block] = from_.entry(row, k);
    columns.push_back(column);
    blocks.push_back(block);
  }
}

void vulkan_rigid_rows::update(std::span<const std::uint32_t> rows, vulkan_changes& changes) {
  parts_.back().rows = from_.rows() - parts_.back().first_row;
  auto at = rows.begin();
  for (auto& part : parts_) {
    std::vector<std::uint32_t> inside;
    for (; at != rows.end() && *at < part.first_row + part.rows; ++at)
      inside.push_back(*at - part.first_row);
    const auto length = [&](std::uint32_t row) { return from_.length(part.first_row + row); };
    for (const auto row : part.table.update(inside, part.rows, length, changes)) {
      std::vector<std::uint32_t> columns;
      std::vector<rigid_level::block6> blocks;
      append_row(part.first_row + row, columns, blocks);
      changes.put(part.columns, part.table.places().begin(row), columns);
      changes.put(part.blocks, part.table.places().begin(row), blocks);
    }
  }
}

void vulkan_rigid_rows::add(vulkan_program& program, std::uint32_t mode, const row_buffers& at,
                            cycle_push push) const {
  for (const auto& part : parts_) {
    push.first_row = part.first_row;
    push.rows = part.rows;
    program.add(program.kernels().rigid_rows[mode],
                {{0, &part.table.table()},
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
    : settings_(settings), scale_(scale) {
  for (const auto& from : h.levels)
    upload(memory, from, &from == &h.levels.back());
  const std::size_t size = std::size_t{6} * h.levels.back().nodes();
  // Edits add aggregates to the first level only.
  const std::size_t most =
    h.levels.size() > 1 ? size
                        : std::max<std::size_t>(size, std::min<std::size_t>(2 * size, 1200)) + 60;
  dense_ = memory.put(packed_dense(dense_inverse(*h.coarsest, size), size, scale), most / 3 * most);
}

void vulkan_rigid_cycle::upload(vulkan_memory& memory, const rigid_level& from, bool last) {
  auto& to = levels_.emplace_back();
  to.host = &from;
  const std::uint64_t bytes = 32 * with_spare(from.nodes());
  to.right = memory.room(bytes);
  to.z = memory.room(bytes);
  if (last)
    return;
  for (auto* vector : {&to.residual, &to.first, &to.second})
    *vector = memory.room(bytes);
  std::vector<rigid_level::block6> inverse;
  for (const auto& block : from.inverse)
    inverse.push_back(scaled(block, scale_));
  to.inverse = memory.put(inverse, with_spare(inverse.size()));
  to.matrix.emplace(memory, matrix_rows(from, 1 / scale_));
  to.up.emplace(memory, prolongation_rows(from));
  to.down.emplace(memory, restriction_rows(from));
}

void vulkan_rigid_cycle::widen(vulkan_memory& memory, std::uint32_t cases) {
  for (auto& l : levels_)
    for (auto* vector : {&l.right, &l.z, &l.residual, &l.first, &l.second})
      if (vector->bytes() > 0)  // The coarsest level has two.
        memory.replace(*vector, vector->bytes() / cases_ * cases);
  cases_ = cases;
}

void vulkan_rigid_cycle::update(const hierarchy& h, vulkan_changes& changes) {
  for (std::size_t l = 0; l + 1 < h.levels.size(); ++l) {
    const auto& from = h.levels[l];
    auto& to = levels_[l];
    changes.items(to.inverse, from.changed,
                  [&](std::uint32_t row) { return scaled(from.inverse[row], scale_); });
    to.matrix->update(from.changed, changes);
    to.up->update(from.changed, changes);
    to.down->update(h.levels[l + 1].changed, changes);
  }
  const std::size_t size = std::size_t{6} * h.levels.back().nodes();
  changes.put(dense_, 0, packed_dense(dense_inverse(*h.coarsest, size), size, scale_));
  for (const auto& l : levels_)
    if (32 * std::uint64_t{cases_} * l.host->nodes() > l.right.bytes())
      changes.refuse();
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
  const float lambda = l.host->lambda;
  cycle_push push{};
  push.rows = l.host->nodes();
  push.fresh = chebyshev_start(lambda);
  program.add(program.kernels().rigid_start,
              {{2, &l.right}, {3, &l.residual}, {4, &l.inverse}, {5, l.step}, {6, &l.z}}, push);
  for (int k = 2; k <= settings_.rigid_degree; ++k)
    move(program, l, chebyshev_step(k, lambda), 0);
  for (int visit = 0; visit < settings_.repeats; ++visit)
    correct(program, at);
}

void vulkan_rigid_cycle::correct(vulkan_program& program, std::size_t at) {
  auto& l = levels_[at];
  auto& next = levels_[at + 1];
  const float lambda = l.host->lambda;
  l.matrix->add(program, TEDIT_RESIDUAL, {.x = l.step, .r = &l.residual, .other = &l.residual}, {});
  l.down->add(program, TEDIT_MULTIPLY, {.x = &l.residual, .r = &next.right}, {});
  solve(program, at + 1);
  l.up->add(program, TEDIT_MULTIPLY, {.x = &next.z, .r = l.step}, {});
  move(program, l, {0, chebyshev_start(lambda)}, 1);
  for (int k = 2; k <= settings_.rigid_degree; ++k)
    move(program, l, chebyshev_step(k, lambda), 0);
}

// -- cycles ------------------------------------------------------------------------------

namespace {

vulkan_lists::source members_of(const hierarchy& h) {
  return [&h](std::uint32_t aggregate, std::vector<std::uint32_t>& list) {
    const auto nodes = h.members.of(aggregate);
    list.insert(list.end(), nodes.begin(), nodes.end());
  };
}

/// The nodes in the middle of the edges at each corner.
vulkan_lists::source middles_of(const edge_transfer& edges) {
  return [&edges](std::uint32_t corner, std::vector<std::uint32_t>& list) {
    for (const auto side : edges.middles.of(corner))
      list.push_back(static_cast<std::uint32_t>(edges.corners()) + side / 2);
  };
}

}  // namespace

vulkan_cycle::vulkan_cycle(vulkan_memory& memory, const row_operator& k, const hierarchy& h,
                           filter_span filter, const cycle_settings& settings, double scale)
    : hierarchy_(h),
      settings_(settings),
      nodes_(k.rows()),
      smoother_(memory, k, h.smoother, filter, scale),
      rigid_(memory, h, settings, scale) {
  std::vector<std::array<std::uint32_t, 4>> arms(nodes_);
  polled_for(nodes_, [&](std::size_t n) { arms[n] = arm_of(static_cast<std::uint32_t>(n)); });
  arms_ = memory.put(arms);
  members_ = vulkan_lists(memory, aggregates(), members_of(h));
}

std::array<std::uint32_t, 4> vulkan_cycle::arm_of(std::uint32_t node) const {
  std::array<std::uint32_t, 4> result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = std::bit_cast<std::uint32_t>(hierarchy_.arm[node][i]);
  result[3] = hierarchy_.aggregate[node];
  return result;
}

void vulkan_cycle::update(filter_span filter, std::span<const std::uint32_t> nodes,
                          vulkan_changes& changes) {
  smoother_.update(filter, nodes, changes);
  rigid_.update(hierarchy_, changes);
  changes.items(arms_, hierarchy_.changed, [this](std::uint32_t n) { return arm_of(n); });
  members_.update(hierarchy_.levels.front().changed, aggregates(), members_of(hierarchy_), changes);
}

void vulkan_cycle::add(vulkan_program& program, const gpu::buffer& right, const gpu::buffer& z) {
  const auto& kernels = program.kernels();
  smoother_.from_zero(program, settings_.node_degree, right, z);
  cycle_push push{};
  push.rows = aggregates();
  program.add(kernels.rigid_down,
              {{0, &members_.table()},
               {1, &members_.items()},
               {2, &arms_},
               {3, &smoother_.residual()},
               {6, &rigid_.right()}},
              push);
  rigid_.add(program);
  push.rows = nodes_;
  push.count = aggregates();
  push.fresh = settings_.over_correction;
  program.add(kernels.rigid_up,
              {{0, &arms_}, {2, &rigid_.z()}, {4, &smoother_.filter()}, {5, &smoother_.step()}},
              push);
  smoother_.correction(program, settings_.node_degree, z);
}

vulkan_quadratic_cycle::vulkan_quadratic_cycle(vulkan_memory& memory, const row_operator& k,
                                               const node_smoother& s, const edge_transfer& edges,
                                               filter_span filter, vulkan_cycle& corners,
                                               int degree, double scale)
    : k_(k),
      edges_(edges),
      corner_count_(static_cast<std::uint32_t>(edges.corners())),
      degree_(degree),
      smoother_(memory, k, s, filter, scale),
      corners_(corners) {
  ends_ = memory.put(edges.ends, with_spare(edges.ends.size()));
  coarse_right_ = memory.room(16 * std::uint64_t{corner_count_});
  coarse_ = memory.room(16 * std::uint64_t{corner_count_});
  middles_ = vulkan_lists(memory, corner_count_, middles_of(edges));
}

void vulkan_quadratic_cycle::update(filter_span filter, std::span<const std::uint32_t> nodes,
                                    std::size_t old_edges, vulkan_changes& changes) {
  smoother_.update(filter, nodes, changes);
  const std::vector added(edges_.ends.begin() + static_cast<std::ptrdiff_t>(old_edges),
                          edges_.ends.end());
  changes.put(ends_, old_edges, added);
  std::vector<std::uint32_t> corners;
  for (const auto& ends : added)
    corners.insert(corners.end(), ends.begin(), ends.end());
  sort_unique(corners);
  middles_.update(corners, corner_count_, middles_of(edges_), changes);
}

void vulkan_quadratic_cycle::add(vulkan_program& program, const gpu::buffer& right,
                                 const gpu::buffer& z) {
  const auto& kernels = program.kernels();
  smoother_.from_zero(program, degree_, right, z);
  cycle_push push{};
  push.rows = corner_count_;
  program.add(kernels.edge_down,
              {{0, &middles_.table()},
               {1, &middles_.items()},
               {3, &smoother_.residual()},
               {6, &coarse_right_}},
              push);
  corners_.add(program, coarse_right_, coarse_);
  push.rows = k_.rows();
  push.count = corner_count_;
  program.add(kernels.edge_up,
              {{0, &ends_}, {2, &coarse_}, {4, &smoother_.filter()}, {5, &smoother_.step()}}, push);
  smoother_.correction(program, degree_, z);
}

}  // namespace tedit::fem
