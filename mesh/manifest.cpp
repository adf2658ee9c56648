// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <unordered_set>

#include "mesh/geometry_bytes.hpp"
#include "mesh/version.hpp"

namespace tedit {

namespace {

// Little-endian on every machine that this runs on; the tag makes another one fail loudly.
constexpr std::uint32_t manifest_tag = 0x314D4554;  // "TEM1"
/// Geometries of surfaces follow the counts.
constexpr std::uint32_t geometry_tag = 0x324D4554;  // "TEM2"

bool has_geometry(const surface_info& row) {
  return row.geometry.type != surface_geometry::kind::none;
}

void write_geometries(const std::vector<surface_info>& surfaces, byte_writer& out) {
  out.number(static_cast<std::uint64_t>(std::ranges::count_if(surfaces, has_geometry)));
  for (const auto& row : surfaces)
    if (has_geometry(row)) {
      out.number(row.id);
      write_geometry(row.geometry, out);
    }
}

/// False unless there are some, in the order of the surfaces, that can be.
bool read_geometries(byte_reader& in, std::vector<surface_info>& surfaces) {
  const auto count = in.count(sizeof(surface_id) + least_bytes_of_geometry);
  auto row = surfaces.begin();
  for (std::size_t i = 0; i < count; ++i) {
    const auto id = in.number<surface_id>();
    auto geometry = read_geometry(in);
    row = std::find_if(row, surfaces.end(), [&](const surface_info& r) { return r.id == id; });
    if (!geometry || geometry->type == surface_geometry::kind::none || row == surfaces.end())
      return false;
    row++->geometry = std::move(*geometry);
  }
  return count > 0;
}

}  // namespace

std::vector<std::byte> manifest::to_bytes() const {
  byte_writer out;
  const bool any_geometry = std::ranges::any_of(surfaces, has_geometry);
  out.number(any_geometry ? geometry_tag : manifest_tag);
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
  if (any_geometry)
    write_geometries(surfaces, out);
  return std::move(out.bytes);
}

expected<manifest> manifest::from_bytes(std::span<const std::byte> bytes) {
  byte_reader in(bytes);
  manifest list;
  const auto tag = in.number<std::uint32_t>();
  if (tag != manifest_tag && tag != geometry_tag)
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
  list.surfaces.reserve(surface_count);
  for (std::size_t i = 0; i < surface_count && in.ok; ++i) {
    const auto id = in.number<surface_id>();
    list.surfaces.push_back({id, in.text(), {}});
  }
  const auto region_count = in.count(8);
  for (std::size_t i = 0; i < region_count && in.ok; ++i) {
    const auto id = in.number<region_id>();
    list.regions.push_back({id, in.text()});
  }
  for (auto& value : list.counts)
    value = in.number<std::uint32_t>();
  const bool fits = tag == manifest_tag || read_geometries(in, list.surfaces);
  if (!in.ok || !in.at_end() || !fits)
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
