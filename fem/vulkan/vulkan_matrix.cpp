// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/vulkan_matrix.hpp"

#include <cmath>

#include "base/guard.hpp"
#include "base/stopwatch.hpp"
#include "fem/polled.hpp"

namespace tedit::fem {

namespace {

/// Of the first submission: about 25 ms on a slow device.
constexpr std::uint32_t first_rows = 2048;

constexpr std::uint64_t entry_bytes = 40;  // column and nine values: see split_block.glsl

/// Entries of a slice of rows, the longest of which has so many; they come in pairs.
std::uint32_t entries_of(std::uint32_t longest, std::uint32_t rows) {
  return (longest + longest % 2) * rows;
}

std::array<std::uint32_t, 4> corners_of(const problem& p, std::uint32_t element) {
  std::array<std::uint32_t, 4> result;
  std::copy_n(&p.element_nodes[static_cast<std::size_t>(p.nodes_per_element) * element], 4,
              result.begin());
  return result;
}

/// The elements around a node, as element * 4 + local node.
vulkan_lists::source around(const problem& p, const incidence& corners) {
  const auto per = static_cast<std::uint32_t>(p.nodes_per_element);
  return [per, &corners](std::uint32_t node, std::vector<std::uint32_t>& list) {
    for (const auto corner : corners.of_node(node))
      list.push_back(corner / per * 4 + corner % per);
  };
}

/// Which of `list` (ascending) lie in first .. last.
std::span<const std::uint32_t> within(std::span<const std::uint32_t> list, std::uint32_t first,
                                      std::uint32_t last) {
  const auto begin = std::ranges::lower_bound(list, first);
  return {begin, std::ranges::lower_bound(list, last)};
}

/// The next power of two: divided by it, a number keeps all its digits.
double power_of_two(double x) {
  return std::exp2(std::ceil(std::log2(x)));
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
  centre = 0.5 * (low + high);
  for (const auto& m : p.constants)
    stiffness = std::max({stiffness, std::abs(m.lambda), m.mu});
  stiffness = power_of_two(stiffness);
}

vulkan_matrix::vulkan_matrix(const cycle_kernels& kernels, vulkan_memory& memory, const problem& p,
                             const device_scale& scale)
    : shapes_(kernels),
      memory_(memory),
      scale_(scale),
      nodes_(static_cast<std::uint32_t>(p.corner_count)),
      elements_(static_cast<std::uint32_t>(p.element_count())) {}

expected<std::unique_ptr<vulkan_matrix>> vulkan_matrix::make(
  std::shared_ptr<gpu::device> on, const cycle_kernels& kernels, vulkan_memory& memory,
  const problem& p, const incidence& corners, const device_scale& scale) {
  std::unique_ptr<vulkan_matrix> result(new vulkan_matrix(kernels, memory, p, scale));
  if (auto ok = result->build(std::move(on), p, corners); !ok)
    return fail(ok.error());
  return result;
}

expected<void> vulkan_matrix::build(std::shared_ptr<gpu::device> on, const problem& p,
                                    const incidence& corners) {
  std::size_t most_corners = 0;
  polled_for(p.corner_count, [&](std::size_t n) {
    most_corners = std::max(most_corners, corners.of_node(n).size());
  });
  // Around an inner node t tets have t/2 + 2 other corners; t + 3 is safe on a boundary.
  // Rounded up, so that similar parts share compiled kernels.
  most_columns_ = (static_cast<std::uint32_t>(most_corners + 3) + 31) / 32 * 32;
  auto kernels = make_elasticity_kernels(std::move(on), shapes_, most_columns_);
  if (!kernels)
    return fail(kernels.error());
  kernels_ = std::move(*kernels);
  if (auto ok = upload_mesh(p, corners); !ok)
    return ok;
  const auto columns = count_columns();
  if (!columns)
    return fail(columns.error());
  if (auto ok = cut_chunks(*columns); !ok)
    return ok;
  for (const auto& part : chunks_)
    if (auto ok = dispatch(kernels_.assemble_rows, part.blocks, part.rows, part.first_row); !ok)
      return ok;
  return {};
}

device_float4 vulkan_matrix::position(const problem& p, std::uint32_t node, bool leading) const {
  const vec3 x = (1 / scale_.size) * (p.nodes[node] - scale_.centre);
  const std::array<double, 3> exact{x.x, x.y, x.z};
  device_float4 result{};
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = static_cast<float>(exact[i]);
    if (!leading)  // What single precision loses.
      result[i] = static_cast<float>(exact[i] - static_cast<double>(result[i]));
  }
  return result;
}

std::array<float, 2> vulkan_matrix::lame(const problem& p, std::uint32_t element) const {
  const auto& m = p.constants[p.element_materials[element]];
  return {static_cast<float>(m.lambda / scale_.stiffness),
          static_cast<float>(m.mu / scale_.stiffness)};
}

expected<void> vulkan_matrix::upload_mesh(const problem& p, const incidence& corners) {
  std::vector<device_float4> high(nodes_);
  std::vector<device_float4> low(nodes_);
  polled_for(nodes_, [&](std::size_t i) {
    const auto n = static_cast<std::uint32_t>(i);
    high[n] = position(p, n, true);
    low[n] = position(p, n, false);
  });
  std::vector<std::array<std::uint32_t, 4>> nodes(elements_);
  std::vector<std::array<float, 2>> constants(elements_);
  polled_for(elements_, [&](std::size_t i) {
    const auto e = static_cast<std::uint32_t>(i);
    nodes[e] = corners_of(p, e);
    constants[e] = lame(p, e);
  });
  position_high_ = memory_.put(high);
  position_low_ = memory_.put(low);
  element_nodes_ = memory_.put(nodes, with_spare(elements_));
  element_lame_ = memory_.put(constants, with_spare(elements_));
  corners_ = vulkan_lists(memory_, nodes_, around(p, corners));
  // Slices hold either one count per row or two numbers per slice.
  slices_ = memory_.room(8 * (std::uint64_t{nodes_} + 1));
  return memory_.status();
}

expected<void> vulkan_matrix::dispatch(const gpu::kernel& k, const gpu::buffer& blocks,
                                       std::uint32_t rows, std::uint32_t first,
                                       const gpu::buffer* listed) {
  auto pool = gpu::binding_pool::make(kernels_.layout, 1);
  if (!pool)
    return fail(pool.error());
  const std::array<const gpu::buffer*, TEDIT_BINDINGS> all{
    &position_high_, &position_low_,    &element_nodes_,
    &element_lame_,  &corners_.table(), &corners_.items(),
    &slices_,        &blocks,           listed ? listed : &slices_};
  const auto set = pool->bind(all);
  if (!set)
    return fail(set.error());
  // At most 65535 groups a dispatch are guaranteed; slow devices get fewer, by measured time.
  const std::uint32_t most = 65535 * shapes_.group_size;
  std::uint32_t fit = first_rows;
  for (std::uint32_t done = 0; done < rows;) {
    check_cancelled();
    const push_constants push{first + done, std::min({fit, most, rows - done}), listed ? 1u : 0u};
    const stopwatch clock;
    if (auto ok = dispatch_rows(k, *set, push); !ok)
      return ok;
    done += push.rows;
    const double now = vulkan_program::submission_ms / std::max(clock.milliseconds(), 1e-3);
    fit = static_cast<std::uint32_t>(std::clamp(now, 0.25, 4.0) * push.rows) + shapes_.group_size;
  }
  return {};
}

expected<void> vulkan_matrix::dispatch_rows(const gpu::kernel& k, VkDescriptorSet set,
                                            const push_constants& push) {
  auto work = gpu::commands::begin(kernels_.layout);
  if (!work)
    return fail(work.error());
  work->use(set);
  work->dispatch(k, (push.rows + shapes_.group_size - 1) / shapes_.group_size, &push);
  if (auto ok = work->end(); !ok)
    return ok;
  return work->run();
}

expected<std::vector<std::uint32_t>> vulkan_matrix::count_columns() {
  if (auto ok = dispatch(kernels_.count_columns, slices_, nodes_); !ok)
    return fail(ok.error());
  std::vector<std::uint32_t> columns(nodes_);
  if (auto ok = memory_.download(slices_, columns); !ok)
    return fail(ok.error());
  return columns;
}

/// Slices of rows that share a width, gathered into chunks that one binding can hold.
expected<void> vulkan_matrix::cut_chunks(const std::vector<std::uint32_t>& columns) {
  const std::uint32_t per_slice = shapes_.slice_rows;
  const std::uint64_t most = memory_.most_per_piece() / entry_bytes;
  std::uint32_t first = 0;
  std::uint64_t sum = 0;
  std::vector<std::uint32_t> entries;
  for (std::uint32_t row = 0; row < nodes_; row += per_slice) {
    const auto last = std::min(nodes_, row + per_slice);
    const auto width = *std::max_element(columns.begin() + row, columns.begin() + last);
    const auto more = entries_of(width, per_slice);
    if (row > first && sum + more > most - most / 16) {
      add_chunk(first, row - first, entries);
      first = row;
      sum = 0;
      entries.clear();
    }
    entries.push_back(more);
    sum += more;
  }
  add_chunk(first, nodes_ - first, entries);
  exact_slices_.assign((nodes_ - 1) / per_slice + 1, 1);
  return upload_slices();
}

expected<void> vulkan_matrix::upload_slices() {
  std::vector<std::array<std::uint32_t, 2>> slices;
  for (const auto& part : chunks_)
    for (std::uint32_t s = 0; s < part.slices.rows(); ++s)
      slices.push_back(slice_at(part, s));
  if (auto ok = memory_.status(); !ok)
    return ok;
  return memory_.upload(slices_, slices);
}

expected<void> vulkan_matrix::read_exactly(std::span<const std::uint8_t> rows) {
  auto wanted = slices_of(rows);
  if (wanted == exact_slices_)
    return {};
  exact_slices_ = std::move(wanted);
  return upload_slices();
}

std::vector<std::uint8_t> vulkan_matrix::slices_of(std::span<const std::uint8_t> rows) const {
  std::vector<std::uint8_t> result((nodes_ - 1) / shapes_.slice_rows + 1);
  for (std::size_t row = 0; row < rows.size(); ++row)
    result[row / shapes_.slice_rows] |= rows[row];
  return result;
}

void vulkan_matrix::add_chunk(std::uint32_t first_row, std::uint32_t rows,
                              std::span<const std::uint32_t> entries) {
  auto& part = chunks_.emplace_back();
  part.first_row = first_row;
  part.rows = rows;
  part.slices = roomy_places(entries, 16, memory_.most_per_piece() / entry_bytes);
  part.blocks = memory_.room(part.slices.room() * entry_bytes);
}

std::array<std::uint32_t, 2> vulkan_matrix::slice_at(const chunk& part, std::uint32_t slice) const {
  const auto begin = part.slices.begin(slice);
  const auto width = (part.slices.end(slice) - begin) / shapes_.slice_rows;
  const bool exact = exact_slices_[part.first_row / shapes_.slice_rows + slice] != 0;
  return {begin, width | (exact ? TEDIT_EXACT_SLICE : 0)};
}

// -- following an edit -------------------------------------------------------------------

void vulkan_matrix::update(const problem& p, const incidence& corners, const row_places& lengths,
                           std::span<const std::uint8_t> exact, const problem_change& change,
                           vulkan_changes& changes) {
  const auto nodes = within(change.nodes, 0, nodes_);
  for (const auto n : nodes)
    if (lengths.length(n) > most_columns_)
      return changes.refuse();
  update_mesh(p, corners, change, changes);
  const auto before = std::exchange(exact_slices_, slices_of(exact));
  for (auto& part : chunks_)
    update_chunk(part, within(nodes, part.first_row, part.first_row + part.rows), lengths, before,
                 changes);
}

void vulkan_matrix::update_mesh(const problem& p, const incidence& corners,
                                const problem_change& change, vulkan_changes& changes) {
  elements_ = static_cast<std::uint32_t>(p.element_count());
  if (16 * std::uint64_t{elements_} > element_nodes_.bytes())
    return changes.refuse();
  const auto fresh = within(change.fresh, 0, nodes_);
  const auto elements = within(change.elements, 0, elements_);
  changes.items(position_high_, fresh, [&](std::uint32_t n) { return position(p, n, true); });
  changes.items(position_low_, fresh, [&](std::uint32_t n) { return position(p, n, false); });
  changes.items(element_nodes_, elements, [&](std::uint32_t e) { return corners_of(p, e); });
  changes.items(element_lame_, elements, [&](std::uint32_t e) { return lame(p, e); });
  corners_.update(within(change.nodes, 0, nodes_), nodes_, around(p, corners), changes);
}

/// A slice keeps its width while its rows fit; wider ones move, and all their rows are gathered.
void vulkan_matrix::update_chunk(chunk& part, std::span<const std::uint32_t> nodes,
                                 const row_places& lengths, std::span<const std::uint8_t> before,
                                 vulkan_changes& changes) {
  const auto per_slice = shapes_.slice_rows;
  const auto end = part.first_row + part.rows;
  const auto entries = [&](std::uint32_t slice) {
    std::uint32_t width = 0;
    for (auto row = part.first_row + slice * per_slice, i = 0u; i < per_slice && row < end;
         ++row, ++i)
      width = std::max(width, lengths.length(row));
    return entries_of(width, per_slice);
  };
  std::vector<std::uint32_t> wider;
  for (const auto n : nodes) {
    const auto slice = (n - part.first_row) / per_slice;
    if (lengths.length(n) * per_slice > part.slices.end(slice) - part.slices.begin(slice))
      wider.push_back(slice);
  }
  sort_unique(wider);
  const auto moved = part.slices.update(wider, part.slices.rows(), entries, changes);
  part.listed.assign(nodes.begin(), nodes.end());
  std::vector<std::uint32_t> table_rows;
  for (const auto slice : moved) {
    table_rows.push_back(part.first_row / per_slice + slice);
    for (auto row = part.first_row + slice * per_slice, i = 0u; i < per_slice && row < end;
         ++row, ++i)
      part.listed.push_back(row);
  }
  sort_unique(part.listed);
  const auto first_slice = part.first_row / per_slice;
  for (std::uint32_t slice = 0; slice < part.slices.rows(); ++slice)
    if (before[first_slice + slice] != exact_slices_[first_slice + slice])
      table_rows.push_back(first_slice + slice);
  sort_unique(table_rows);
  changes.items(slices_, table_rows,
                [&](std::uint32_t slice) { return slice_at(part, slice - first_slice); });
}

expected<void> vulkan_matrix::gather_again() {
  for (auto& part : chunks_) {
    if (part.listed.empty())
      continue;
    const auto count = static_cast<std::uint32_t>(part.listed.size());
    auto list = memory_.put(std::exchange(part.listed, {}));
    if (auto ok = memory_.status(); !ok)
      return ok;
    if (auto ok = dispatch(kernels_.assemble_rows, part.blocks, count, 0, &list); !ok)
      return ok;
    memory_.give_back(list);
  }
  return {};
}

std::uint64_t vulkan_matrix::read_bytes() const {
  std::uint64_t bytes = 0;
  for (const auto& part : chunks_)
    for (std::uint32_t s = 0; s < part.slices.rows(); ++s)
      bytes += 8 + entry_bytes * (part.slices.end(s) - part.slices.begin(s));
  return bytes;
}

std::uint32_t vulkan_matrix::most_partials(const cycle_kernels& kernels) const {
  std::uint32_t sums = 0;
  for (const auto& part : chunks_)
    sums += kernels.most_sums(part.rows);
  return sums;
}

std::uint32_t vulkan_matrix::reading_of(std::uint32_t mode) const {
  if (mode == TEDIT_MULTIPLY || std::ranges::find(exact_slices_, 0) == exact_slices_.end())
    return TEDIT_READ_EXACTLY;
  return std::ranges::find(exact_slices_, 1) != exact_slices_.end() ? TEDIT_READ_MIXED
                                                                    : TEDIT_READ_ROUNDED;
}

std::uint32_t vulkan_matrix::add(vulkan_program& program, std::uint32_t mode, const row_buffers& at,
                                 cycle_push push) const {
  push.place = 0;
  const auto& kernel = program.kernels().node_rows[reading_of(mode)][mode];
  for (const auto& part : chunks_) {
    push.first_row = part.first_row;
    push.rows = part.rows;
    const std::initializer_list<vulkan_program::place> places{
      {0, &slices_},
      {1, &part.blocks},
      {2, at.x},
      {3, at.r},
      {4, at.diagonal ? at.diagonal : &slices_},
      {5, at.other ? at.other : &slices_},
      {6, at.z ? at.z : &slices_},
      {7, at.partials ? at.partials : &slices_}};
    if (mode == TEDIT_MULTIPLY)
      push.place += program.add_sum(kernel, places, push);
    else
      program.add(kernel, places, push);
  }
  return push.place;
}

}  // namespace tedit::fem
