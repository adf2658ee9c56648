// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/raw_mesh.hpp"

#include <algorithm>
#include <numeric>

#include "mesh/morton.hpp"

namespace tedit {

namespace {

/// 10 bits of each coordinate: cells much smaller than what lies in one page of a mesh.
constexpr int key_bits = 30;
constexpr int digit_bits = 10;

/// The items 0 to `count` - 1 in the order of their places on the curve, those of one cell as they
/// were: a radix sort, as sorting by comparison takes three times as long.
template <class PlaceOf>
std::vector<std::uint32_t> order_along(const morton_curve& curve, std::size_t count,
                                       const PlaceOf& place_of) {
  struct item {
    std::uint32_t key;
    std::uint32_t index;
  };
  std::vector<item> items(count);
  for (std::size_t i = 0; i < count; ++i)
    items[i] = {static_cast<std::uint32_t>(curve.code(place_of(i)) >> (63 - key_bits)),
                static_cast<std::uint32_t>(i)};
  std::vector<item> sorted(count);
  for (int shift = 0; shift < key_bits; shift += digit_bits) {
    const auto digit = [&](const item& one) {
      return (one.key >> shift) & ((1U << digit_bits) - 1);
    };
    std::array<std::uint32_t, (1U << digit_bits) + 1> begin{};
    for (const auto& one : items)
      ++begin[digit(one) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    for (const auto& one : items)
      sorted[begin[digit(one)]++] = one;
    items.swap(sorted);
  }
  std::vector<std::uint32_t> order(count);
  std::ranges::transform(items, order.begin(), &item::index);
  return order;
}

template <class T>
void put_in_order(std::vector<T>& items, const std::vector<std::uint32_t>& order) {
  std::vector<T> result;
  result.reserve(items.size());
  for (const auto i : order)
    result.push_back(items[i]);
  items = std::move(result);
}

void renumber(raw_mesh& raw, const std::vector<vertex_id>& slot_of) {
  for (auto& t : raw.tets)
    for (auto& v : t.v)
      v = slot_of[v];
  for (auto& triangle : raw.triangles)
    for (auto& v : triangle.v)
      v = slot_of[v];
}

}  // namespace

void keep_vertices(raw_mesh& raw, const std::vector<bool>& is_used) {
  std::vector<vertex_id> slot_of(raw.positions.size(), no_id);
  vertex_id used = 0;
  for (std::size_t v = 0; v < slot_of.size(); ++v) {
    if (!is_used[v])
      continue;
    raw.positions[used] = raw.positions[v];
    if (!raw.node_numbers.empty())
      raw.node_numbers[used] = raw.node_numbers[v];
    slot_of[v] = used++;
  }
  if (used == raw.positions.size())
    return;
  raw.positions.resize(used);
  if (!raw.node_numbers.empty())
    raw.node_numbers.resize(used);
  renumber(raw, slot_of);
}

std::pair<std::vector<std::uint32_t>, std::vector<std::uint32_t>> sort_along_curve(raw_mesh& raw) {
  box extents;
  for (const auto& p : raw.positions)
    extents.add(p);
  const morton_curve curve(extents);
  auto vertices =
    order_along(curve, raw.positions.size(), [&](std::size_t v) { return raw.positions[v]; });
  auto tets = order_along(curve, raw.tets.size(), [&](std::size_t t) {
    vec3 middle{};
    for (const auto v : raw.tets[t].v)
      middle = middle + 0.25 * raw.positions[v];
    return middle;
  });
  std::vector<vertex_id> slot_of(vertices.size());
  for (vertex_id v = 0; v < vertices.size(); ++v)
    slot_of[vertices[v]] = v;
  put_in_order(raw.positions, vertices);
  put_in_order(raw.tets, tets);
  put_in_order(raw.tet_regions, tets);
  renumber(raw, slot_of);
  return {std::move(vertices), std::move(tets)};
}

}  // namespace tedit
