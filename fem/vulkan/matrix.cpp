// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/matrix.hpp"

#include <cmath>
#include <cstring>

#include "base/parallel.hpp"
#include "fem/polled.hpp"

namespace tedit::fem::vulkan {

namespace {

constexpr std::uint64_t entry_bytes = 40;  // column and nine values: see split_block.glsl

/// The next power of two: divided by it, a number keeps all its digits.
double power_of_two(double x) {
  return std::exp2(std::ceil(std::log2(x)));
}

/// Which of `list` (ascending) lie in first .. last.
std::span<const std::uint32_t> within(std::span<const std::uint32_t> list, std::uint32_t first,
                                      std::uint32_t last) {
  const auto begin = std::ranges::lower_bound(list, first);
  return {begin, std::ranges::lower_bound(list, last)};
}

}  // namespace

device_scale::device_scale(const problem& p) {
  vec3 low{1e300, 1e300, 1e300};
  vec3 high = -low;
  for (const auto& x : p.nodes) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
  size = power_of_two(std::max({high.x - low.x, high.y - low.y, high.z - low.z}));
  for (const auto& m : p.constants)
    stiffness = std::max({stiffness, std::abs(m.lambda), m.mu});
  stiffness = power_of_two(stiffness);
}

/// Slices of rows that share a width, gathered into chunks that one binding can hold.
sliced_matrix::sliced_matrix(const kernel_set& kernels, device_memory& memory,
                             const block_matrix& k, const device_scale& scale)
    : memory_(memory),
      per_slice_(kernels.slice_rows),
      scale_(static_cast<float>(1 / scale.matrix())),
      rows_(static_cast<std::uint32_t>(k.rows())),
      exact_slices_((rows_ - 1) / per_slice_ + 1, 1) {
  const std::uint64_t most = memory_.most_per_piece() / entry_bytes;
  std::uint32_t first = 0;
  std::uint64_t sum = 0;
  std::vector<std::uint32_t> entries;
  for (std::uint32_t row = 0; row < rows_; row += per_slice_) {
    const auto more = entries_of(k, row);
    if (row > first && sum + more > most - most / 16) {
      add_chunk(k, first, entries);
      first = row;
      sum = 0;
      entries.clear();
    }
    entries.push_back(more);
    sum += more;
  }
  add_chunk(k, first, entries);
  slices_ = memory_.put(all_slices());
}

void sliced_matrix::add_chunk(const block_matrix& k, std::uint32_t first_row,
                              std::span<const std::uint32_t> entries) {
  auto& part = chunks_.emplace_back();
  const auto slices = static_cast<std::uint32_t>(entries.size());
  part.first_row = first_row;
  part.rows = std::min(rows_ - first_row, slices * per_slice_);
  part.slices = roomy_places(entries, 16, memory_.most_per_piece() / entry_bytes);
  std::vector<texel> texels;
  polled_resize(texels, std::size_t{part.slices.used()} / 2 * 5);
  parallel_for(
    slices,
    [&](std::size_t first, std::size_t last, std::size_t) {
      for (auto s = static_cast<std::uint32_t>(first); s < last; ++s)
        pack_slice(k, part, s, std::span(texels).subspan(part.slices.begin(s) / 2 * 5));
    },
    256);
  part.blocks = memory_.put(texels, (part.slices.room() + 1) / 2 * 5);
}

/// Entries of the slice that begins with this row: as wide as its longest row, in pairs.
std::uint32_t sliced_matrix::entries_of(const block_matrix& k, std::uint32_t first_row) const {
  std::uint32_t longest = 0;
  for (auto row = first_row; row < std::min(rows_, first_row + per_slice_); ++row)
    longest = std::max(longest, k.places.length(row));
  return (longest + longest % 2) * per_slice_;
}

/// Padding stands for the row itself: its difference is zero.
void sliced_matrix::pack_slice(const block_matrix& k, const chunk& part, std::uint32_t slice,
                               std::span<texel> to) const {
  const auto [first, marked_width] = slice_at(part, slice);
  const auto width = marked_width & ~TEDIT_EXACT_SLICE;
  std::ranges::fill(to.first(std::size_t{width} * per_slice_ / 2 * 5), texel{});
  for (std::uint32_t lane = 0; lane < per_slice_; ++lane) {
    const auto row = part.first_row + slice * per_slice_ + lane;
    const auto begin = row < rows_ ? k.begin(row) : 0;
    const auto length = row < rows_ ? k.places.length(row) : 0;
    for (std::uint32_t place = 0; place < width; ++place)
      if (place < length)
        pack_entry(k, begin + place, width, place, lane, to);
      else
        to[(place / 2 * 3 + place % 2) * per_slice_ + lane][0] = std::min(row, rows_ - 1);
  }
}

void sliced_matrix::pack_entry(const block_matrix& k, std::size_t entry, std::uint32_t width,
                               std::uint32_t place, std::uint32_t lane, std::span<texel> to) const {
  const auto block = k.block(entry);
  half_block high;
  half_block low;
  split_block({scale_ * load3(&block[0]), scale_ * load3(&block[3]), scale_ * load3(&block[6])},
              high, low);
  auto& head = to[(place / 2 * 3 + place % 2) * per_slice_ + lane];
  auto& tails = to[(place / 2 * 3 + 2) * per_slice_ + lane];
  auto& rest = to[(width / 2 * 3 + place) * per_slice_ + lane];
  head[0] = k.column[entry];
  std::memcpy(&head[1], &high[0], 12);
  std::memcpy(&tails[place % 2 * 2], &high[6], 4);
  tails[place % 2 * 2 + 1] = low[8] | std::uint32_t{high[8]} << 16;
  std::memcpy(&rest[0], &low[0], 16);
}

std::array<std::uint32_t, 2> sliced_matrix::slice_at(const chunk& part, std::uint32_t slice) const {
  const auto begin = part.slices.begin(slice);
  const auto width = (part.slices.end(slice) - begin) / per_slice_;
  const bool exact = exact_slices_[part.first_row / per_slice_ + slice] != 0;
  return {begin, width | (exact ? TEDIT_EXACT_SLICE : 0)};
}

std::vector<std::array<std::uint32_t, 2>> sliced_matrix::all_slices() const {
  std::vector<std::array<std::uint32_t, 2>> slices;
  for (const auto& part : chunks_)
    for (std::uint32_t s = 0; s < part.slices.rows(); ++s)
      slices.push_back(slice_at(part, s));
  return slices;
}

expected<void> sliced_matrix::read_exactly(std::span<const std::uint8_t> rows) {
  auto wanted = slices_of(rows);
  if (wanted == exact_slices_)
    return {};
  exact_slices_ = std::move(wanted);
  return memory_.upload(slices_, all_slices());
}

std::vector<std::uint8_t> sliced_matrix::slices_of(std::span<const std::uint8_t> rows) const {
  std::vector<std::uint8_t> result(exact_slices_.size());
  for (std::size_t row = 0; row < rows.size(); ++row)
    result[row / per_slice_] |= rows[row];
  return result;
}

// -- following an edit -------------------------------------------------------------------

void sliced_matrix::update(const block_matrix& k, std::span<const std::uint32_t> rows,
                           std::span<const std::uint8_t> exact, device_changes& changes) {
  const auto before = std::exchange(exact_slices_, slices_of(exact));
  for (auto& part : chunks_)
    update_chunk(k, part, within(rows, part.first_row, part.first_row + part.rows), before,
                 changes);
}

/// A slice keeps its width while its rows fit; wider ones move.
void sliced_matrix::update_chunk(const block_matrix& k, chunk& part,
                                 std::span<const std::uint32_t> rows,
                                 std::span<const std::uint8_t> before, device_changes& changes) {
  const auto entries = [&](std::uint32_t slice) {
    return entries_of(k, part.first_row + slice * per_slice_);
  };
  std::vector<std::uint32_t> dirty;
  for (const auto row : rows)
    dirty.push_back((row - part.first_row) / per_slice_);
  sort_unique(dirty);
  std::vector<std::uint32_t> wider;
  for (const auto slice : dirty)
    if (entries(slice) > part.slices.end(slice) - part.slices.begin(slice))
      wider.push_back(slice);
  auto in_table = part.slices.update(wider, part.slices.rows(), entries, changes);
  dirty.insert(dirty.end(), in_table.begin(), in_table.end());
  sort_unique(dirty);
  std::vector<texel> texels;
  for (const auto slice : dirty) {
    texels.resize((part.slices.end(slice) - part.slices.begin(slice)) / 2 * 5);
    pack_slice(k, part, slice, texels);
    changes.put(part.blocks, part.slices.begin(slice) / 2 * 5, texels);
  }
  const auto first_slice = part.first_row / per_slice_;
  for (auto& slice : in_table)
    slice += first_slice;
  for (auto slice = first_slice; slice < first_slice + part.slices.rows(); ++slice)
    if (before[slice] != exact_slices_[slice])
      in_table.push_back(slice);
  sort_unique(in_table);
  changes.items(slices_, in_table,
                [&](std::uint32_t slice) { return slice_at(part, slice - first_slice); });
}

// -- products ----------------------------------------------------------------------------

std::uint64_t sliced_matrix::read_bytes() const {
  std::uint64_t bytes = 0;
  for (const auto& part : chunks_)
    for (std::uint32_t s = 0; s < part.slices.rows(); ++s)
      bytes += 8 + entry_bytes * (part.slices.end(s) - part.slices.begin(s));
  return bytes;
}

std::uint32_t sliced_matrix::most_partials(const kernel_set& kernels) const {
  std::uint32_t sums = 0;
  for (const auto& part : chunks_)
    sums += kernels.most_sums(part.rows);
  return sums;
}

std::uint32_t sliced_matrix::reading_of(std::uint32_t mode) const {
  if (mode == TEDIT_MULTIPLY || std::ranges::find(exact_slices_, 0) == exact_slices_.end())
    return TEDIT_READ_EXACTLY;
  return std::ranges::find(exact_slices_, 1) != exact_slices_.end() ? TEDIT_READ_MIXED
                                                                    : TEDIT_READ_ROUNDED;
}

std::uint32_t sliced_matrix::add(device_program& program, std::uint32_t mode, const row_buffers& at,
                                 row_push push) const {
  push.first_sum = 0;
  const auto& kernel = program.kernels().matrix_rows[reading_of(mode)][mode];
  for (const auto& part : chunks_) {
    push.first_row = part.first_row;
    push.rows = part.rows;
    const auto places = at.with({{matrix_at::slices, &slices_}, {matrix_at::blocks, &part.blocks}});
    if (mode == TEDIT_MULTIPLY)
      push.first_sum += program.add_sum(kernel, places, push);
    else
      program.add(kernel, places, push);
  }
  return push.first_sum;
}

}  // namespace tedit::fem::vulkan
