// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>

#include "base/text.hpp"
#include "mesh/distances.hpp"
#include "mesh/facet_pages.hpp"
#include "mesh/place_text.hpp"
#include "ops/shapes/deform/deform_zone.hpp"

namespace tedit::ops {

namespace {

/// Length of the sum of the area vectors by the sum of their lengths: below it facets face so many
/// ways that their mean is no direction that a person has in mind.
constexpr double least_common = 0.3;

drag_handle gathered(const mesh_version& mesh, std::vector<facet_id> facets) {
  drag_handle result;
  result.facets = std::move(facets);
  for (const auto f : result.facets) {
    const auto& facet = mesh.facet(f);
    result.vertices.insert(result.vertices.end(), facet.v.begin(), facet.v.end());
    result.surfaces.push_back(facet.surface);
    const vec3 area = area_vector(mesh, facet);
    result.area += norm(area);
    result.area_vector += area;
  }
  std::ranges::sort(result.vertices);
  result.vertices.erase(std::ranges::unique(result.vertices).begin(), result.vertices.end());
  std::ranges::sort(result.surfaces);
  result.surfaces.erase(std::ranges::unique(result.surfaces).begin(), result.surfaces.end());
  return result;
}

double distance_of(const mesh_version& mesh, facet_id f, vec3 p) {
  const auto& v = mesh.facet(f).v;
  return point_to_triangle(p, mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]));
}

double mean_edge(const mesh_version& mesh, facet_id f) {
  const auto& v = mesh.facet(f).v;
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    sum += norm(mesh.position(v[(i + 1) % 3]) - mesh.position(v[i]));
  return sum / 3;
}

/// The one nearest to the place, on these surfaces where some are named; `no_id`: there is none.
facet_id nearest_facet(const mesh_version& mesh, vec3 place,
                       const std::vector<surface_id>& surfaces) {
  facet_id nearest = no_id;
  double least = 1e300;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f) ||
        (!surfaces.empty() && !std::ranges::count(surfaces, mesh.facet(f).surface)))
      continue;
    if (const double d = distance_of(mesh, f, place); d < least)
      std::tie(least, nearest) = std::pair(d, f);
  }
  return nearest;
}

/// Those of `first`'s surfaces whose corners are all within the radius and that hang together with
/// `first` over edges; `first` always.
std::vector<facet_id> patch_from(const mesh_version& mesh, facet_id first, vec3 place,
                                 double radius, const std::vector<surface_id>& surfaces) {
  std::map<std::pair<vertex_id, vertex_id>, std::vector<facet_id>> over;
  const auto edge = [&](facet_id f, int i) {
    const auto& v = mesh.facet(f).v;
    return std::pair(std::minmax(v[i], v[(i + 1) % 3]));
  };
  box around;
  around.add(place);
  for_each_facet_near(mesh, around.grown(radius), [&](facet_id f) {
    const auto& facet = mesh.facet(f);
    const bool within = std::ranges::all_of(
      facet.v, [&](vertex_id v) { return norm(mesh.position(v) - place) <= radius; });
    if (f != first && (!within || !(facet.surface == mesh.facet(first).surface ||
                                    std::ranges::count(surfaces, facet.surface))))
      return;
    for (int i = 0; i < 3; ++i)
      over[edge(f, i)].push_back(f);
  });
  std::set<facet_id> found{first};
  std::vector<facet_id> queue{first};
  for (std::size_t next = 0; next < queue.size(); ++next)
    for (int i = 0; i < 3; ++i)
      for (const auto f : over[edge(queue[next], i)])
        if (found.insert(f).second)
          queue.push_back(f);
  return {found.begin(), found.end()};
}

}  // namespace

expected<vec3> drag_handle::normal() const {
  if (!(norm(area_vector) >= least_common * area))
    return fail(ec::invalid_parameter, "what is dragged faces so many ways that it has no normal",
                "Say which way it goes: by_mm=x,y,z");
  return normalized(area_vector);
}

expected<drag_handle> handle_of(const mesh_version& mesh, const std::vector<surface_id>& surfaces) {
  const auto sizes = surface_sizes(mesh);
  for (const auto id : surfaces)
    if (!sizes.contains(id))
      return fail(ec::empty_selection,
                  "surface " + std::to_string(id) + " has no facet on the outside of the part",
                  "Select a surface of the boundary");
  return gathered(mesh, facets_of(mesh, surfaces));
}

expected<drag_handle> handle_at(const mesh_version& mesh, vec3 place, double radius,
                                const std::vector<surface_id>& surfaces) {
  const auto first = nearest_facet(mesh, place, surfaces);
  if (first == no_id)
    return fail(ec::empty_selection, "the selected surfaces have no facet on the outside",
                "Select a surface of the boundary");
  if (radius == 0)
    radius = 2 * mean_edge(mesh, first);
  if (const double off = distance_of(mesh, first, place); off > radius)
    return fail(ec::empty_selection,
                "the place " + place_text(place) + " is " + format_number("%.4g", 1e3 * off) +
                  " mm off the wall, further than the radius of " +
                  format_number("%.4g", 1e3 * radius) + " mm",
                "Give a place on the wall, or a larger radius");
  return gathered(mesh, patch_from(mesh, first, place, radius, surfaces));
}

}  // namespace tedit::ops
