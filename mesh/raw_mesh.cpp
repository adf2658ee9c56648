// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/raw_mesh.hpp"

#include <algorithm>

#include "mesh/morton.hpp"

namespace tedit {

namespace {

/// The items 0 to `count` - 1 in the order of their places on the curve.
template <class PlaceOf>
std::vector<std::uint32_t> order_along(const morton_curve& curve, std::size_t count,
                                       const PlaceOf& place_of) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> places(count);
  for (std::size_t i = 0; i < count; ++i)
    places[i] = {curve.code(place_of(i)), static_cast<std::uint32_t>(i)};
  std::ranges::sort(places);
  std::vector<std::uint32_t> order(count);
  std::ranges::transform(places, order.begin(), [](const auto& place) { return place.second; });
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
