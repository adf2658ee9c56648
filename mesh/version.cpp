// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/version.hpp"

#include <algorithm>
#include <cstring>
#include <unordered_set>

#include "mesh/quality.hpp"

namespace tedit {

namespace {

/// Calls `visit(array)` for each array of a `mesh_data`, in manifest order.
template <class Data, class Visit>
void for_each_array(Data& data, Visit&& visit) {
  visit(data.positions);
  visit(data.vertex_tet);
  visit(data.tets);
  visit(data.tet_regions);
  visit(data.neighbours);
  visit(data.facets);
  visit(data.interfaces);
}

template <class Data, class Visit>
void for_each_order(Data& data, Visit&& visit) {
  visit(data.vertex_order);
  visit(data.tet_order);
}

constexpr std::size_t arrays_without_order = 7;
constexpr std::size_t arrays_with_order = 9;

manifest make_manifest(const mesh_data& data) {
  manifest list;
  const auto add = [&](const auto& array) {
    manifest::array_row row;
    row.size = array.size();
    row.pages.reserve(array.pages().size());
    for (const auto& p : array.pages())
      row.pages.push_back(p->id());
    list.arrays.push_back(std::move(row));
  };
  for_each_array(data, add);
  if (data.vertex_order.size() > 0 || data.tet_order.size() > 0)
    for_each_order(data, add);
  list.surfaces = data.surfaces;
  list.regions = data.regions;
  list.counts = {data.vertices,    data.live_tets, data.live_facets,
                 data.free_vertex, data.free_tet,  data.free_facet};
  return list;
}

}  // namespace

version_ptr mesh_version::create(mesh_data data) {
  auto result = std::shared_ptr<mesh_version>(new mesh_version);
  result->data_ = std::move(data);
  result->manifest_ = make_manifest(result->data_);
  result->id_ = hash_bytes(result->manifest_.to_bytes());
  return result;
}

expected<version_ptr> mesh_version::from_manifest(
  const manifest& list, const std::function<page_ptr(const hash128&)>& find) {
  mesh_data data;
  std::size_t index = 0;
  std::optional<error> failure;
  if (list.arrays.size() != arrays_without_order && list.arrays.size() != arrays_with_order)
    return fail(ec::invalid_mesh,
                "a manifest lists 7 or 9 arrays, this one " + std::to_string(list.arrays.size()));
  const auto take = [&](auto& array) {
    const auto& row = list.arrays[index++];
    // Beyond that the count of pages that a length needs could overflow, and fit.
    if (row.size > row.pages.size() * max_page_bytes && !failure)
      failure = error{ec::invalid_mesh, "an array is longer than its pages", {}, {}};
    std::vector<page_ptr> pages;
    for (const auto& id : row.pages) {
      pages.push_back(find(id));
      if (!pages.back() && !failure)
        failure = error{ec::not_found, "page " + to_hex(id) + " is missing", {}, {}};
    }
    if (failure)
      return;
    auto made = std::remove_cvref_t<decltype(array)>::from_pages(std::move(pages), row.size);
    if (made)
      array = std::move(*made);
    else
      failure = made.error();
  };
  for_each_array(data, take);
  if (list.arrays.size() == arrays_with_order)
    for_each_order(data, take);
  if (failure)
    return fail(*failure);
  data.surfaces = list.surfaces;
  data.regions = list.regions;
  data.vertices = list.counts[0];
  data.live_tets = list.counts[1];
  data.live_facets = list.counts[2];
  data.free_vertex = list.counts[3];
  data.free_tet = list.counts[4];
  data.free_facet = list.counts[5];
  return create(std::move(data));
}

void mesh_version::for_each_page(const std::function<void(const page_ptr&)>& visit) const {
  std::unordered_set<const page*> seen;
  const auto visit_pages = [&](const auto& array) {
    for (const auto& p : array.pages())
      if (seen.insert(p.get()).second)
        visit(p);
  };
  for_each_array(data_, visit_pages);
  for_each_order(data_, visit_pages);
}

const surface_info* mesh_version::find_surface(surface_id id) const {
  const auto row = std::ranges::lower_bound(data_.surfaces, id, {}, &surface_info::id);
  return row != data_.surfaces.end() && row->id == id ? &*row : nullptr;
}

std::array<vec3, 4> mesh_version::corners(tet_id t) const {
  const auto& v = data_.tets[t].v;
  return {position(v[0]), position(v[1]), position(v[2]), position(v[3])};
}

double total_volume(const mesh_version& mesh) {
  double sum = 0;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t))
      sum += signed_volume(mesh.corners(t));
  return sum;
}

void grow_star(const mesh_version& mesh, vertex_id v, tet_id from, std::vector<tet_id>& star) {
  const auto add = [&](tet_id t) {
    if (t < mesh.tet_slots() && std::ranges::count(mesh.tet_at(t).v, v) > 0 &&
        std::ranges::find(star, t) == star.end())
      star.push_back(t);
  };
  auto next = star.size();
  for (add(from); next < star.size(); ++next) {
    const auto& corner = mesh.tet_at(star[next]).v;
    for (int i = 0; i < 4; ++i)
      if (const auto behind = mesh.neighbours(star[next])[i]; corner[i] != v && !is_facet(behind))
        add(behind);
  }
}

std::vector<tet_id> tets_around(const mesh_version& mesh, std::span<const vertex_id> vertices) {
  std::unordered_set<tet_id> found;
  std::vector<tet_id> star;
  for (const auto v : vertices) {
    if (v >= mesh.vertex_slots() || !mesh.is_live_vertex(v))
      continue;
    star.clear();
    grow_star(mesh, v, mesh.incident_tet(v), star);
    found.insert(star.begin(), star.end());
  }
  std::vector<tet_id> result(found.begin(), found.end());
  std::ranges::sort(result);
  return result;
}

vec3 area_vector(vec3 a, vec3 b, vec3 c) {
  return 0.5 * cross(b - a, c - a);
}

vec3 area_vector(const mesh_version& mesh, const boundary_facet& facet) {
  return area_vector(mesh.position(facet.v[0]), mesh.position(facet.v[1]),
                     mesh.position(facet.v[2]));
}

}  // namespace tedit
