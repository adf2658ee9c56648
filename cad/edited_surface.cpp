// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/edited_surface.hpp"

#include <algorithm>
#include <unordered_map>

namespace tedit::cad {

namespace {

/// A facet by its corners, smallest first, and its surface.
using facet_key = std::array<std::int64_t, 4>;

template <class Visit>
void for_each_facet(const mesh_version& mesh, const Visit& visit) {
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      visit(mesh.facet(f).v, mesh.facet(f).surface);
  for (std::size_t i = 0; i < mesh.data().interfaces.size(); ++i)
    visit(mesh.data().interfaces[i].v, mesh.data().interfaces[i].surface);
}

/// Vertices of an edited mesh by those that were on the boundary before, in the same place: a half
/// that was taken out and put back has others there.
class earlier_vertices {
public:
  earlier_vertices(const mesh_version& before, const mesh_version& after)
      : before_(before), after_(after) {
    std::vector<bool> seen(before.vertex_slots());
    for_each_facet(before, [&](const auto& corners, surface_id) {
      for (const auto v : corners)
        if (!seen[v]) {
          seen[v] = true;
          places_.push_back({place(before.position(v)), v});
        }
    });
    std::ranges::sort(places_);
  }

  /// Of `after`. Below 0 where none was there.
  std::int64_t operator()(vertex_id v) const {
    if (v < before_.vertex_slots() && before_.is_live_vertex(v) &&
        before_.position(v) == after_.position(v))
      return v;
    const auto at = place(after_.position(v));
    const auto found = std::ranges::lower_bound(places_, at, {}, &std::pair<key, vertex_id>::first);
    return found != places_.end() && found->first == at ? found->second : -1 - std::int64_t{v};
  }

private:
  using key = std::array<double, 3>;
  static key place(vec3 p) { return {p.x, p.y, p.z}; }

  const mesh_version& before_;
  const mesh_version& after_;
  std::vector<std::pair<key, vertex_id>> places_;  ///< Ascending.
};

template <class Vertex>
facet_key key_of(const std::array<vertex_id, 3>& corners, surface_id surface,
                 const Vertex& vertex) {
  std::array<std::int64_t, 3> v{vertex(corners[0]), vertex(corners[1]), vertex(corners[2])};
  std::ranges::sort(v);
  return {v[0], v[1], v[2], surface};
}

/// Ascending.
template <class Vertex>
std::vector<facet_key> keys_of(const mesh_version& mesh, const Vertex& vertex) {
  std::vector<facet_key> keys;
  for_each_facet(
    mesh, [&](const auto& v, surface_id surface) { keys.push_back(key_of(v, surface, vertex)); });
  std::ranges::sort(keys);
  return keys;
}

/// Points by the vertex of a version.
class point_table {
public:
  point_table(const mesh_version& mesh, edited_surface& into) : mesh_(mesh), into_(into) {}

  std::int32_t operator()(vertex_id v) {
    const auto [found, is_new] = places_.emplace(v, static_cast<std::int32_t>(into_.points.size()));
    if (is_new) {
      const auto p = mesh_.position(v);
      into_.points.push_back({mm_of_metre * p.x, mm_of_metre * p.y, mm_of_metre * p.z});
    }
    return found->second;
  }

private:
  const mesh_version& mesh_;
  edited_surface& into_;
  std::unordered_map<vertex_id, std::int32_t> places_;
};

}  // namespace

edited_surface surface_after(const mesh_version& before, const mesh_version& after) {
  edited_surface result;
  const earlier_vertices earlier(before, after);
  const auto itself = [](vertex_id v) { return std::int64_t{v}; };
  const auto old_keys = keys_of(before, itself);
  const auto new_keys = keys_of(after, earlier);
  point_table old_points(before, result);
  for_each_facet(before, [&](const auto& v, surface_id surface) {
    if (!std::ranges::binary_search(new_keys, key_of(v, surface, itself)))
      result.triangles.push_back({old_points(v[0]), old_points(v[1]), old_points(v[2]),
                                  static_cast<std::int32_t>(surface), triangle_gone});
  });
  // Those that were there come first: the last ones are the fresh ones.
  point_table points(after, result);
  for_each_facet(after, [&](const auto& v, surface_id) {
    for (const auto one : v)
      if (earlier(one) >= 0)
        points(one);
  });
  const auto not_fresh = result.points.size();
  for_each_facet(after, [&](const auto& v, surface_id surface) {
    const bool is_made = !std::ranges::binary_search(old_keys, key_of(v, surface, earlier));
    result.triangles.push_back({points(v[0]), points(v[1]), points(v[2]),
                                static_cast<std::int32_t>(surface),
                                is_made ? triangle_made : triangle_kept});
  });
  result.fresh = result.points.size() - not_fresh;
  return result;
}

std::size_t count_bodies(const mesh_version& mesh) {
  std::vector<bool> seen(mesh.tet_slots());
  std::vector<tet_id> open;
  std::size_t bodies = 0;
  for (tet_id first = 0; first < mesh.tet_slots(); ++first) {
    if (seen[first] || !mesh.is_live_tet(first))
      continue;
    ++bodies;
    seen[first] = true;
    open.push_back(first);
    while (!open.empty()) {
      const auto t = open.back();
      open.pop_back();
      for (const auto next : mesh.neighbours(t))
        if (!is_facet(next) && !seen[next] && mesh.region_of(next) == mesh.region_of(t)) {
          seen[next] = true;
          open.push_back(next);
        }
    }
  }
  return bodies;
}

}  // namespace tedit::cad
