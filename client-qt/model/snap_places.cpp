// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/snap_places.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <map>

#include "client-qt/model/quantities.hpp"
#include "client-qt/model/round_edges.hpp"

namespace tedit::desktop {

namespace {

struct snap_phrases {
  Q_DECLARE_TR_FUNCTIONS(snap_places)
};

constexpr double flat_cosine = 0.99996;  // Half a degree.

/// What the facets of one surface are together.
struct wall_sums {
  vec3 moments;  // Of areas.
  vec3 normals;
  double area = 0;
  std::vector<vec3> units;

  [[nodiscard]] bool is_flat() const {
    const vec3 mean = normalized(normals);
    return area > 0 && std::ranges::all_of(units, [&](const vec3& n) {
             return dot(n, mean) > flat_cosine || norm(n) == 0;
           });
  }
};

using walls_of_edge = std::pair<surface_id, surface_id>;

struct part_walls {
  std::map<surface_id, wall_sums> sums;
  std::map<walls_of_edge, std::vector<mesh_edge>> edges;
};

part_walls walls_of(const client::surface_model& part) {
  part_walls result;
  std::map<mesh_edge, surface_id> open;
  part.facets().for_each([&](std::uint32_t, const client::surface_facet& facet) {
    std::array<vec3, 3> c;
    for (std::size_t k = 0; k < 3; ++k)
      if (const auto* p = part.positions().find(facet.v[k]))
        c[k] = *p;
    const vec3 twice = cross(c[1] - c[0], c[2] - c[0]);
    auto& sums = result.sums[facet.surface];
    sums.moments += norm(twice) * (c[0] + c[1] + c[2]) / 3;
    sums.normals += twice;
    sums.area += norm(twice);
    sums.units.push_back(normalized(twice));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(facet.v[k], facet.v[(k + 1) % 3]);
      const auto [other, is_new] = open.try_emplace({a, b}, facet.surface);
      if (!is_new && other->second != facet.surface)
        result.edges[std::minmax(other->second, facet.surface)].emplace_back(a, b);
    }
  });
  return result;
}

void sort_once(std::vector<surface_id>& ids) {
  std::ranges::sort(ids);
  const auto repeats = std::ranges::unique(ids);
  ids.erase(repeats.begin(), repeats.end());
}

/// Of halves of one rim the second says nothing new, but belongs to it.
void add_edge_centre(std::vector<snap_place>& to, snap_place found) {
  sort_once(found.surfaces);
  for (auto& one : to)
    if (one.radius > 0 && norm(one.at - found.at) < 0.02 * found.radius &&
        std::abs(one.radius - found.radius) < 0.02 * found.radius) {
      one.surfaces.insert(one.surfaces.end(), found.surfaces.begin(), found.surfaces.end());
      return sort_once(one.surfaces);
    }
  to.push_back(std::move(found));
}

std::optional<round_edge> edge_of(const client::surface_model& part,
                                  const std::vector<vertex_id>& chain) {
  std::vector<vec3> points;
  for (const auto vertex : chain)
    if (const auto* p = part.positions().find(vertex))
      points.push_back(*p);
  return round_edge_of(points);
}

using wall_normals = std::map<surface_id, vec3>;

/// A rim is whole where a flat wall meets all that is not flat; arcs between two fillets, and those
/// that run on into straight edges, are found by the pair.
void add_edge_centres(const client::surface_model& part, const part_walls& walls,
                      const wall_normals& flat, std::vector<snap_place>& to) {
  std::map<surface_id, std::vector<mesh_edge>> rims;
  std::map<mesh_edge, surface_id> beyond;
  for (const auto& [pair, edges] : walls.edges) {
    const bool first = flat.contains(pair.first);
    if (first == flat.contains(pair.second))
      continue;
    auto& rim = rims[first ? pair.first : pair.second];
    rim.insert(rim.end(), edges.begin(), edges.end());
    for (const auto& one : edges)
      beyond[one] = first ? pair.second : pair.first;
  }
  for (const auto& [wall, edges] : rims)
    for (const auto& chain : chains_of(edges)) {
      const auto found = edge_of(part, chain);
      if (!found)
        continue;
      snap_place place{found->middle, wall, flat.at(wall), {wall}, found->radius};
      for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        place.surfaces.push_back(beyond.at(std::minmax(chain[i], chain[i + 1])));
      add_edge_centre(to, std::move(place));
    }
  for (const auto& [pair, edges] : walls.edges)
    for (const auto& chain : chains_of(edges)) {
      const auto found = edge_of(part, chain);
      if (!found)
        continue;
      snap_place place{found->middle, {}, {}, {pair.first, pair.second}, found->radius};
      for (const auto id : {pair.second, pair.first})
        if (const auto wall = flat.find(id); wall != flat.end()) {
          place.wall = id;
          place.normal = wall->second;
        }
      add_edge_centre(to, std::move(place));
    }
}

}  // namespace

std::vector<snap_place> snap_places(const client::surface_model& part) {
  std::vector<snap_place> result;
  const auto walls = walls_of(part);
  wall_normals normals;
  for (const auto& [id, sums] : walls.sums)
    if (sums.is_flat()) {
      normals[id] = normalized(sums.normals);
      result.push_back({sums.moments / sums.area, id, normals[id], {id}});
    }
  add_edge_centres(part, walls, normals, result);
  return result;
}

QString words_of(const snap_place& place) {
  return place.radius > 0
           ? snap_phrases::tr("centre of a round edge, Ø %1").arg(length(2 * place.radius))
           : snap_phrases::tr("centre of surface %1").arg(place.surfaces.front());
}

namespace {

/// Onto a line through the middle of a wall along one of the part's axes, within reach.
std::optional<snapped_place> onto_middle_line(const snap_place& wall, const lens& by,
                                              const vec3& at) {
  const double reach = snap_reach * by.metres_per_pixel(at);
  for (const vec3& axis : {vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}}) {
    const double off = dot(wall.at - at, axis);
    if (std::abs(dot(axis, wall.normal)) < 1e-3 && std::abs(off) < reach)
      return snapped_place{
        at + off * axis, wall.wall,
        snap_phrases::tr("on the middle line of surface %1").arg(wall.surfaces.front())};
  }
  return std::nullopt;
}

}  // namespace

std::optional<snapped_place> snap(const std::vector<snap_place>& places, QPointF pointer,
                                  const lens& by, const vec3& at, surface_id surface,
                                  const std::function<bool(const snap_place&)>& sees) {
  const snap_place* best = nullptr;
  double least = snap_reach;
  for (const auto& one : places)
    if (const double far = pixels_between(by.to_screen(one.at), pointer);
        far < least && sees(one)) {
      least = far;
      best = &one;
    }
  if (best)
    return snapped_place{best->at, best->wall, words_of(*best)};
  for (const auto& one : places)
    if (one.radius == 0 && one.surfaces.front() == surface)
      return onto_middle_line(one, by, at);
  return std::nullopt;
}

}  // namespace tedit::desktop
