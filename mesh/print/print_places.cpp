// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/print/print_places.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace tedit {

namespace {

/// A directed edge of a facet, its smaller corner first.
struct facet_edge {
  vertex_id low;
  vertex_id high;
  bool forward;
  std::uint32_t facet;

  [[nodiscard]] auto key() const { return std::pair(low, high); }
};

void add_edges(const boundary_facet& facet, std::uint32_t number, std::vector<facet_edge>& edges) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto a = facet.v[i];
    const auto b = facet.v[(i + 1) % 3];
    edges.push_back({std::min(a, b), std::max(a, b), a < b, number});
  }
}

/// Calls `visit` with the first and one behind the last of the edges between two corners.
template <class Visit>
void for_each_edge(std::vector<facet_edge>& edges, const Visit& visit) {
  std::ranges::sort(edges, {}, &facet_edge::key);
  for (std::size_t i = 0; i < edges.size();) {
    auto last = i + 1;
    while (last < edges.size() && edges[last].key() == edges[i].key())
      ++last;
    visit(i, last);
    i = last;
  }
}

std::uint32_t root_in(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i)
    i = parent[i] = parent[parent[i]];
  return i;
}

void unite_in(std::vector<std::uint32_t>& parent, std::uint32_t i, std::uint32_t j) {
  i = root_in(parent, i);
  j = root_in(parent, j);
  parent[std::max(i, j)] = std::min(i, j);
}

}  // namespace

shells::shells(const mesh_version& mesh) {
  std::vector<facet_edge> edges;
  std::vector<std::uint32_t> parent(mesh.vertex_slots());
  std::iota(parent.begin(), parent.end(), 0U);
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f)) {
      const auto& v = mesh.facet(f).v;
      add_edges(mesh.facet(f), f, edges);
      unite_in(parent, v[0], v[1]);
      unite_in(parent, v[1], v[2]);
    }
  for_each_edge(edges, [&](std::size_t first, std::size_t last) {
    const auto forward = std::count_if(edges.begin() + static_cast<std::ptrdiff_t>(first),
                                       edges.begin() + static_cast<std::ptrdiff_t>(last),
                                       [](const facet_edge& edge) { return edge.forward; });
    open_edges += 2 * static_cast<std::size_t>(forward) != last - first;
    hinge_edges += last - first > 2;
  });
  // From a corner of the shell itself, exact far from the origin.
  std::map<std::uint32_t, double> volumes;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f)) {
      const auto& v = mesh.facet(f).v;
      const auto shell = root_in(parent, v[0]);
      const vec3 origin = mesh.position(shell);
      volumes[shell] += dot(mesh.position(v[0]) - origin,
                            cross(mesh.position(v[1]) - origin, mesh.position(v[2]) - origin));
    }
  for (const auto& [shell, volume] : volumes)
    ++(volume < 0 ? inward : outward);
}

place_finder::place_finder(const mesh_version& mesh, bool least_is_worst)
    : mesh_(mesh), least_is_worst_(least_is_worst), row_of_(mesh.facet_slots(), no_id) {}

void place_finder::add(facet_id facet, double area, double worst, vec3 at) {
  const auto row = static_cast<std::uint32_t>(rows_.size());
  row_of_[facet] = row;
  parent_.push_back(row);
  rows_.push_back({facet, area, worst, at});
}

void place_finder::join(facet_id one, facet_id two) {
  if (row_of_[one] != no_id && row_of_[two] != no_id)
    unite_in(parent_, row_of_[one], row_of_[two]);
}

void place_finder::unite_neighbours() {
  std::vector<facet_edge> edges;
  for (std::uint32_t i = 0; i < rows_.size(); ++i)
    add_edges(mesh_.facet(rows_[i].facet), i, edges);
  for_each_edge(edges, [&](std::size_t first, std::size_t last) {
    for (auto k = first + 1; k < last; ++k)
      unite_in(parent_, edges[first].facet, edges[k].facet);
  });
}

std::vector<print_place> place_finder::places() {
  unite_neighbours();
  std::map<std::uint32_t, print_place> found;
  for (std::uint32_t i = 0; i < rows_.size(); ++i) {
    const auto& row = rows_[i];
    auto& place = found[root_in(parent_, i)];
    const bool is_worse = least_is_worst_ ? row.worst < place.worst : row.worst > place.worst;
    if (place.facets == 0 || is_worse) {
      place.worst = row.worst;
      place.at = row.at;
    }
    ++place.facets;
    place.area += row.area;
    place.surfaces.push_back(mesh_.facet(row.facet).surface);
  }
  std::vector<print_place> result;
  for (auto& [root, place] : found) {
    std::ranges::sort(place.surfaces);
    const auto repeated = std::ranges::unique(place.surfaces);
    place.surfaces.erase(repeated.begin(), repeated.end());
    result.push_back(std::move(place));
  }
  std::ranges::stable_sort(result, std::ranges::greater{}, &print_place::area);
  return result;
}

}  // namespace tedit
