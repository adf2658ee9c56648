// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/smoother.hpp"

#include <bit>

namespace tedit::fem::vulkan {

namespace {

constexpr std::uint64_t square_bytes = 48;

/// Column and nine values by rows.
using square_words = std::array<std::uint32_t, 12>;

/// The blocks of the inverse of a cluster, row by row of its nodes.
std::vector<square_words> blocks_of(const std::vector<float>& inverse,
                                    std::span<const std::uint32_t> nodes, double scale) {
  const std::size_t count = nodes.size();
  std::vector<square_words> result;
  result.reserve(count * count);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = 0; b < count; ++b) {
      auto& block = result.emplace_back(square_words{nodes[b]});
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          block[1 + 3 * i + j] = std::bit_cast<std::uint32_t>(static_cast<float>(
            scale * static_cast<double>(inverse[(3 * a + i) * 3 * count + 3 * b + j])));
    }
  return result;
}

}  // namespace

smoother::smoother(device_memory& memory, const row_operator& k, const node_smoother& s,
                   filter_span filter, double scale)
    : k_(k), smoother_(s), scale_(scale) {
  const auto room = with_spare(s.inverse.size());
  inverse_ = memory.put(packed_symmetric(std::span(s.inverse), scale), room);
  filter_ = memory.put(packed_symmetric(filter, 1), room);
  for (auto* vector : {&residual_, &first_, &second_})
    *vector = memory.room(16 * room);
  upload_clusters(memory);
}

void smoother::widen(device_memory& memory, std::uint32_t cases) {
  const auto room = inverse_.bytes() / 32;
  for (auto* vector : {&residual_, &first_, &second_})
    memory.replace(*vector, 16 * cases * room);
}

void smoother::update(filter_span filter, std::span<const std::uint32_t> nodes,
                      device_changes& changes) {
  changes.items(inverse_, smoother_.changed,
                [&](std::uint32_t n) { return packed_six(smoother_.inverse[n].data(), scale_); });
  changes.items(filter_, nodes, [&](std::uint32_t n) { return packed_six(filter[n].data(), 1); });
  if (32 * smoother_.inverse.size() > inverse_.bytes())
    changes.refuse();
  auto& last = clusters_.back();
  last.count = smoother_.clusters.nodes.owners() - last.first;
  std::span<const std::uint32_t> changed = smoother_.clusters.changed;
  for (auto& part : clusters_) {
    std::size_t inside = 0;
    while (inside < changed.size() && changed[inside] < part.first + part.count)
      ++inside;
    update_part(part, changed.first(inside), changes);
    changed = changed.subspan(inside);
  }
}

// -- clusters ----------------------------------------------------------------------------

std::uint32_t smoother::size_of(std::size_t cluster) const {
  return smoother_.clusters.nodes.places.length(cluster);
}

void smoother::upload_clusters(device_memory& memory) {
  const std::uint64_t most = memory.most_per_piece() / square_bytes;
  const auto clusters = static_cast<std::uint32_t>(smoother_.clusters.inverse.size());
  std::uint32_t first = 0;
  std::uint64_t blocks = 0;
  for (std::uint32_t c = 0; c < clusters; ++c) {
    const auto more = std::uint64_t{size_of(c)} * size_of(c);
    if (c > first && blocks + more > most - most / 8) {
      add_part(memory, first, c);
      first = c;
      blocks = 0;
    }
    blocks += more;
  }
  add_part(memory, first, clusters);  // Empty without clusters: an edit may make some.
}

void smoother::add_part(device_memory& memory, std::uint32_t first, std::uint32_t last) {
  auto& part = clusters_.emplace_back();
  part.first = first;
  part.count = last - first;
  std::vector<std::uint32_t> rows;
  std::vector<std::uint32_t> squares;
  std::vector<square_words> blocks;
  for (auto c = first; c < last; ++c) {
    check_cancelled();
    rows.push_back(size_of(c));
    squares.push_back(size_of(c) * size_of(c));
    const auto more =
      blocks_of(smoother_.clusters.inverse[c], smoother_.clusters.nodes.of(c), scale_);
    blocks.insert(blocks.end(), more.begin(), more.end());
  }
  part.rows = roomy_places(rows, 4, ~0ull);
  part.places = roomy_places(squares, 4, memory.most_per_piece() / square_bytes);
  part.host_table.resize(part.rows.used());
  for (std::uint32_t c = 0; c < part.count; ++c)
    fill_table(part, c);
  part.table = memory.put(part.host_table, part.rows.room());
  part.blocks = memory.put(blocks, part.places.room());
}

void smoother::fill_table(cluster_part& part, std::uint32_t cluster) const {
  const auto nodes = smoother_.clusters.nodes.of(part.first + cluster);
  const auto count = static_cast<std::uint32_t>(nodes.size());
  for (std::uint32_t a = 0; a < count; ++a)
    part.host_table[part.rows.begin(cluster) + a] = {
      nodes[a], part.places.begin(cluster) + a * count, count, 0};
}

void smoother::update_part(cluster_part& part, std::span<const std::uint32_t> clusters,
                           device_changes& changes) const {
  std::vector<std::uint32_t> inside;
  std::vector<std::uint32_t> dirty_rows;
  for (const auto c : clusters)
    inside.push_back(c - part.first);
  const auto clear = [&](std::uint32_t first, std::uint32_t last) {
    for (auto row = first; row < last; ++row) {
      part.host_table[row] = {};
      dirty_rows.push_back(row);
    }
  };
  for (const auto c : inside)
    if (c < part.rows.rows())
      clear(part.rows.begin(c), part.rows.end(c));
  const auto size = [&](std::uint32_t c) { return size_of(part.first + c); };
  const auto square = [&](std::uint32_t c) { return size(c) * size(c); };
  auto dirty = part.rows.update(inside, part.count, size, changes);
  const auto moved = part.places.update(inside, part.count, square, changes);
  dirty.insert(dirty.end(), moved.begin(), moved.end());
  sort_unique(dirty);
  part.host_table.resize(part.rows.used());
  for (const auto c : dirty) {
    fill_table(part, c);
    for (auto row = part.rows.begin(c); row < part.rows.end(c); ++row)
      dirty_rows.push_back(row);
    changes.put(part.blocks, part.places.begin(c),
                blocks_of(smoother_.clusters.inverse[part.first + c],
                          smoother_.clusters.nodes.of(part.first + c), scale_));
  }
  sort_unique(dirty_rows);
  std::erase_if(dirty_rows, [&](std::uint32_t row) { return row >= part.host_table.size(); });
  changes.items(part.table, dirty_rows, [&](std::uint32_t row) { return part.host_table[row]; });
}

void smoother::add_clusters(device_program& program, float fresh, const gpu::buffer& step,
                            const gpu::buffer& z) const {
  for (const auto& part : clusters_) {
    program.add(
      program.kernels().smoother_clusters,
      row_buffers{.r = &residual_, .next = &step, .z = &z}.with(
        {{smoother_at::cluster_rows, &part.table}, {smoother_at::cluster_blocks, &part.blocks}}),
      row_push{.rows = part.rows.used(), .fresh = fresh});
  }
}

void smoother::move(device_program& program, chebyshev_weights weights, float enter,
                    const gpu::buffer& z) {
  k_.add(program, TEDIT_MOVE,
         {.x = step_, .r = &residual_, .diagonal = &inverse_, .next = other_, .z = &z},
         {.before = weights.before, .fresh = weights.fresh, .enter = enter});
  add_clusters(program, weights.fresh, *other_, z);
  std::swap(step_, other_);
}

void smoother::from_zero(device_program& program, int degree, const gpu::buffer& right,
                         const gpu::buffer& z) {
  const float fresh = chebyshev_start(smoother_.lambda);
  program.add(
    program.kernels().smoother_start,
    row_buffers{.x = &right, .r = &residual_, .diagonal = &inverse_, .next = step_, .z = &z}.with(),
    row_push{.rows = k_.rows(), .fresh = fresh});
  add_clusters(program, fresh, *step_, z);
  for (int i = 2; i <= degree; ++i)
    move(program, chebyshev_step(i, smoother_.lambda), 0, z);
  k_.add(program, TEDIT_RESIDUAL, {.x = step_, .r = &residual_, .diagonal = &filter_}, {});
}

void smoother::correction(device_program& program, int degree, const gpu::buffer& z) {
  move(program, {0, chebyshev_start(smoother_.lambda)}, 1, z);
  for (int i = 2; i <= degree; ++i)
    move(program, chebyshev_step(i, smoother_.lambda), 0, z);
}

}  // namespace tedit::fem::vulkan
