// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/changes.hpp"

#include <tuple>

namespace tedit::fem::vulkan {

void device_changes::note(const gpu::buffer& to, std::uint64_t offset,
                          std::span<const std::byte> bytes) {
  if (offset + bytes.size() > to.bytes())
    return refuse();
  if (bytes.empty() || !fits_)
    return;
  patches_.push_back({&to, offset, bytes_.size(), bytes.size()});
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

expected<void> device_changes::send(const std::shared_ptr<gpu::kernel_layout>& layout) {
  std::ranges::sort(patches_, {},
                    [](const gpu::patch& p) { return std::tuple(p.to, p.to_offset); });
  std::vector<gpu::patch> merged;
  for (const auto& p : patches_)
    if (!merged.empty() && merged.back().to == p.to &&
        merged.back().to_offset + merged.back().bytes == p.to_offset &&
        merged.back().from_offset + merged.back().bytes == p.from_offset)
      merged.back().bytes += p.bytes;
    else
      merged.push_back(p);
  return gpu::upload(layout, merged, bytes_);
}

roomy_places::roomy_places(std::span<const std::uint32_t> lengths, std::uint32_t share,
                           std::uint64_t most)
    : places_(lengths) {
  const std::uint64_t used = places_.room();
  room_ = std::max(used, std::min(most, used + used / share + 1024));
}

row_table::row_table(device_memory& memory, std::span<const std::uint32_t> lengths,
                     std::uint32_t share, std::uint64_t most)
    : places_(lengths, share, most) {
  std::vector<std::array<std::uint32_t, 2>> pairs(lengths.size());
  for (std::uint32_t row = 0; row < pairs.size(); ++row)
    pairs[row] = pair_of(row);
  table_ = memory.put(pairs, with_spare(pairs.size()));
}

row_lists::row_lists(device_memory& memory, std::uint32_t rows, const source& from) {
  std::vector<std::uint32_t> items;
  std::vector<std::uint32_t> lengths(rows);
  polled_for(rows, [&](std::size_t row) {
    const auto before = items.size();
    from(static_cast<std::uint32_t>(row), items);
    lengths[row] = static_cast<std::uint32_t>(items.size() - before);
  });
  rows_ = row_table(memory, lengths, 16, memory.most_per_piece() / 4);
  items_ = memory.put(items, rows_.places().room());
}

void row_lists::update(std::span<const std::uint32_t> rows, std::uint32_t count, const source& from,
                       device_changes& changes) {
  std::vector<std::uint32_t> list;
  const auto list_of = [&](std::uint32_t row) -> const std::vector<std::uint32_t>& {
    list.clear();
    from(row, list);
    return list;
  };
  const auto length = [&](std::uint32_t row) {
    return static_cast<std::uint32_t>(list_of(row).size());
  };
  for (const auto row : rows_.update(rows, count, length, changes))
    changes.put(items_, rows_.places().begin(row), list_of(row));
}

}  // namespace tedit::fem::vulkan
