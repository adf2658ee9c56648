// SPDX-License-Identifier: AGPL-3.0-or-later
#include <unordered_set>

#include "base/byte_stream.hpp"
#include "mesh/version.hpp"

namespace tedit {

namespace {

// Little-endian on every machine that this runs on; the tag makes another one fail loudly.
constexpr std::uint32_t manifest_tag = 0x314D4554;  // "TEM1"

}  // namespace

std::vector<std::byte> manifest::to_bytes() const {
  byte_writer out;
  out.number(manifest_tag);
  out.number(static_cast<std::uint64_t>(arrays.size()));
  for (const auto& row : arrays) {
    out.number(row.size);
    out.number(static_cast<std::uint64_t>(row.pages.size()));
    for (const auto& id : row.pages) {
      out.number(id.high);
      out.number(id.low);
    }
  }
  out.number(static_cast<std::uint64_t>(surfaces.size()));
  for (const auto& row : surfaces) {
    out.number(row.id);
    out.text(row.name);
  }
  out.number(static_cast<std::uint64_t>(regions.size()));
  for (const auto& row : regions) {
    out.number(row.id);
    out.text(row.name);
  }
  for (const auto value : counts)
    out.number(value);
  return std::move(out.bytes);
}

expected<manifest> manifest::from_bytes(std::span<const std::byte> bytes) {
  byte_reader in(bytes);
  manifest list;
  if (in.number<std::uint32_t>() != manifest_tag)
    return fail(ec::protocol_error, "these bytes are not a version's manifest");
  const auto array_count = in.count(16);
  for (std::size_t i = 0; i < array_count && in.ok; ++i) {
    array_row row;
    row.size = in.number<std::uint64_t>();
    row.pages.resize(in.count(16));
    for (auto& id : row.pages) {
      id.high = in.number<std::uint64_t>();
      id.low = in.number<std::uint64_t>();
    }
    list.arrays.push_back(std::move(row));
  }
  const auto surface_count = in.count(12);
  for (std::size_t i = 0; i < surface_count && in.ok; ++i) {
    const auto id = in.number<surface_id>();
    list.surfaces.push_back({id, in.text()});
  }
  const auto region_count = in.count(8);
  for (std::size_t i = 0; i < region_count && in.ok; ++i) {
    const auto id = in.number<region_id>();
    list.regions.push_back({id, in.text()});
  }
  for (auto& value : list.counts)
    value = in.number<std::uint32_t>();
  if (!in.ok || !in.at_end())
    return fail(ec::protocol_error, "a version's manifest is cut off or has the wrong length");
  return list;
}

std::vector<hash128> manifest::page_ids() const {
  std::vector<hash128> result;
  std::unordered_set<hash128> seen;
  for (const auto& row : arrays)
    for (const auto& id : row.pages)
      if (seen.insert(id).second)
        result.push_back(id);
  return result;
}

}  // namespace tedit
