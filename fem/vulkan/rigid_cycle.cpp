// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/rigid_cycle.hpp"

#include "fem/polled.hpp"

namespace tedit::fem::vulkan {

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

/// Entry k of row i at k * rows + i, three columns each; see rigid_cycle_coarsest.comp.
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

rigid_rows::source matrix_rows(const rigid_level& level, double scale) {
  return {[&] { return level.nodes(); }, [&](std::uint32_t row) { return level.rows.length(row); },
          [&, scale](std::uint32_t row, std::uint32_t k) {
            const auto at = level.rows.begin(row) + k;
            return std::pair(level.column[at], scaled(level.block[at], scale));
          }};
}

rigid_rows::source prolongation_rows(const rigid_level& level) {
  const auto& rows = level.prolongation_rows;
  return {[&] { return static_cast<std::uint32_t>(rows.size()); },
          [&](std::uint32_t row) { return rows.length(row); },
          [&](std::uint32_t row, std::uint32_t k) {
            const auto at = rows.begin(row) + k;
            return std::pair(level.prolongation_column[at], level.prolongation[at]);
          }};
}

rigid_rows::source restriction_rows(const rigid_level& level) {
  return {[&] { return level.entries.owners(); },
          [&](std::uint32_t row) { return level.entries.places.length(row); },
          [&](std::uint32_t row, std::uint32_t k) {
            const auto at = level.entries.of(row)[k];
            return std::pair(level.entry_row[at], transposed(level.prolongation[at]));
          }};
}

}  // namespace

// -- rows of rigid motions ---------------------------------------------------------------

rigid_rows::rigid_rows(device_memory& memory, source from) : from_(std::move(from)) {
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

void rigid_rows::add_piece(device_memory& memory, std::uint32_t first_row,
                           std::span<const std::uint32_t> lengths) {
  auto& part = parts_.emplace_back();
  part.first_row = first_row;
  part.rows = static_cast<std::uint32_t>(lengths.size());
  part.table = row_table(memory, lengths, 4, memory.most_per_piece() / block_bytes);
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

void rigid_rows::append_row(std::uint32_t row, std::vector<std::uint32_t>& columns,
                            std::vector<rigid_level::block6>& blocks) const {
  for (std::uint32_t k = 0, count = from_.length(row); k < count; ++k) {
    const auto [column, block] = from_.entry(row, k);
    columns.push_back(column);
    blocks.push_back(block);
  }
}

void rigid_rows::update(std::span<const std::uint32_t> rows, device_changes& changes) {
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

void rigid_rows::add(device_program& program, std::uint32_t mode, const row_buffers& at,
                     row_push push) const {
  for (const auto& part : parts_) {
    push.first_row = part.first_row;
    push.rows = part.rows;
    program.add(program.kernels().rigid_cycle_rows[mode],
                at.with({{rigid_cycle_at::table, &part.table.table()},
                         {rigid_cycle_at::columns, &part.columns},
                         {rigid_cycle_at::blocks, &part.blocks}}),
                push);
  }
}

// -- levels of rigid motions -------------------------------------------------------------

rigid_cycle::rigid_cycle(device_memory& memory, const hierarchy& h, const cycle_settings& settings,
                         double scale)
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

void rigid_cycle::upload(device_memory& memory, const rigid_level& from, bool last) {
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

void rigid_cycle::widen(device_memory& memory, std::uint32_t cases) {
  for (auto& l : levels_)
    for (auto* vector : {&l.right, &l.z, &l.residual, &l.first, &l.second})
      if (vector->bytes() > 0)  // The coarsest level has two.
        memory.replace(*vector, vector->bytes() / cases_ * cases);
  cases_ = cases;
}

void rigid_cycle::update(const hierarchy& h, device_changes& changes) {
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

void rigid_cycle::move(device_program& program, level& l, chebyshev_weights weights, float enter) {
  l.matrix->add(program, TEDIT_MOVE,
                {.x = l.step, .r = &l.residual, .diagonal = &l.inverse, .next = l.other, .z = &l.z},
                {.before = weights.before, .fresh = weights.fresh, .enter = enter});
  std::swap(l.step, l.other);
}

void rigid_cycle::solve(device_program& program, std::size_t at) {
  auto& l = levels_[at];
  if (at + 1 == levels_.size()) {
    program.add(program.kernels().rigid_cycle_coarsest,
                row_buffers{.x = &l.right, .z = &l.z}.with({{rigid_cycle_at::inverse, &dense_}}),
                row_push{.rows = 6 * l.host->nodes(), .halves = 2 * l.host->nodes()});
    return;
  }
  const float lambda = l.host->lambda;
  program.add(
    program.kernels().rigid_cycle_start,
    row_buffers{.x = &l.right, .r = &l.residual, .diagonal = &l.inverse, .next = l.step, .z = &l.z}
      .with(),
    row_push{.rows = l.host->nodes(), .fresh = chebyshev_start(lambda)});
  for (int k = 2; k <= settings_.rigid_degree; ++k)
    move(program, l, chebyshev_step(k, lambda), 0);
  for (int visit = 0; visit < settings_.repeats; ++visit)
    correct(program, at);
}

void rigid_cycle::correct(device_program& program, std::size_t at) {
  auto& l = levels_[at];
  auto& next = levels_[at + 1];
  const float lambda = l.host->lambda;
  l.matrix->add(program, TEDIT_RESIDUAL, {.x = l.step, .r = &l.residual, .next = &l.residual}, {});
  l.down->add(program, TEDIT_MULTIPLY, {.x = &l.residual, .r = &next.right}, {});
  solve(program, at + 1);
  l.up->add(program, TEDIT_MULTIPLY, {.x = &next.z, .r = l.step}, {});
  move(program, l, {0, chebyshev_start(lambda)}, 1);
  for (int k = 2; k <= settings_.rigid_degree; ++k)
    move(program, l, chebyshev_step(k, lambda), 0);
}

}  // namespace tedit::fem::vulkan
