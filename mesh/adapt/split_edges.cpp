// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/adapt/split_edges.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/adapt/edge_splitter.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

/// Volume of a tet by the cube of the length that its edges may have, in the mean: measured, see
/// bench/FIGURES.md.
constexpr double volume_share = 0.0095;
/// No part has so many tets. Sizes below rounding end here, too.
constexpr double countless = 1e15;
/// Of what chords may be off: nearer to a wall an end is on it.
constexpr double end_share = 1e-2;

double longest_edge(const std::array<vec3, 4>& p) {
  double longest = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      longest = std::max(longest, norm(p[i] - p[j]));
  return longest;
}

/// m: beyond it edges of that length are short enough.
double furthest(double size, double longest) {
  return std::max(0.0, longest - size) / size_growth;
}

/// The integral of 1 / size^3 over a tet of volume 1 with these distances at its corners: by the
/// formula of Hermite and Genocchi six times the divided difference of the third antiderivative.
double mean_density(double size, std::array<double, 4> distance) {
  std::ranges::sort(distance);
  std::array<double, 4> u{};
  std::array<double, 4> f{};
  for (int i = 0; i < 4; ++i) {
    u[i] = size + size_growth * distance[i];
    // Differences of equal numbers are none.
    if (i > 0)
      u[i] = std::max(u[i], 1.01 * u[i - 1]);
    f[i] = std::log(u[i]) / 2;
  }
  for (int order = 1; order < 4; ++order)
    for (int i = 3; i >= order; --i)
      f[i] = (f[i] - f[i - 1]) / (u[i] - u[i - order]);
  return 6 * f[3];
}

split_rule::test longer_than(const std::vector<double>& sizes) {
  return [&sizes](const edge_splitter&, const splitter_edge& e) {
    return e.length > std::min(sizes[e.a], sizes[e.b]);
  };
}

}  // namespace

double tets_after_split(const mesh_version& mesh, const split_settings& settings) {
  double longest_of_all = 0;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t))
      longest_of_all = std::max(longest_of_all, longest_edge(mesh.corners(t)));
  const auto distance =
    pick_distance(mesh, settings.pick).at_vertices(mesh, furthest(settings.size, longest_of_all));
  double sum = 0;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    if (!mesh.is_live_tet(t))
      continue;
    const auto p = mesh.corners(t);
    std::array<double, 4> off{};
    for (int i = 0; i < 4; ++i)
      off[i] = distance[mesh.tet_at(t).v[i]];
    // A ball may lie inside a tet, away from its corners.
    if (settings.pick.at)
      for (auto& d : off)
        d = std::max(0.0, d - longest_edge(p) / 2);
    const double pieces =
      std::abs(signed_volume(p)) / volume_share * mean_density(settings.size, off);
    if (!(pieces < countless))
      return countless;
    sum += std::max(1.0, pieces);
  }
  return sum;
}

expected<split_report> split_edges(const mesh_version& base, adapt_mesh& mesh,
                                   const split_settings& settings, const execution& run) {
  double longest = 0;
  for (std::uint32_t t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live(t))
      longest = std::max(longest, longest_edge(mesh.corners(t)));
  const double far = furthest(settings.size, longest);
  const pick_distance off(base, settings.pick);
  const auto size_at = [&](double distance) { return settings.size + size_growth * distance; };
  std::vector<double> distance = off.at_vertices(base, far);
  std::vector<double> sizes;
  for (const auto d : distance)
    sizes.push_back(size_at(d));
  const auto give_size = [&](vec3 place, std::uint32_t a, std::uint32_t b) {
    const double bound =
      std::min(distance[a] + norm(place - mesh.at(a)), distance[b] + norm(place - mesh.at(b)));
    distance.push_back(off(place, std::min(far, bound * (1 + 1e-9))));
    sizes.push_back(size_at(distance.back()));
  };
  // What was expected is right within a factor, so that there is some room.
  wall_places walls(base);
  return edge_splitter(mesh, walls, {longer_than(sizes), give_size},
                       settings.most_tets + settings.most_tets / 2, run)
    .split_all();
}

expected<split_report> split_edges(const mesh_version& base, adapt_mesh& mesh,
                                   std::vector<double> sizes, std::size_t most_tets,
                                   const execution& run) {
  const auto between = [&](vec3, std::uint32_t a, std::uint32_t b) {
    sizes.push_back(0.5 * (sizes[a] + sizes[b]));
  };
  wall_places walls(base);
  return edge_splitter(mesh, walls, {longer_than(sizes), between}, most_tets, run).split_all();
}

expected<split_report> split_chords(const mesh_version& base, adapt_mesh& mesh,
                                    const chord_settings& settings, const execution& run) {
  wall_places walls(base, settings.is_round, settings.near);
  const auto is_off = [&](const edge_splitter& splitter, const splitter_edge& e) {
    return settings.near.meets(box_of(std::array{mesh.at(e.a), mesh.at(e.b)})) &&
           std::ranges::any_of(splitter.walls_at(e), [&](surface_id wall) {
             // An end that could not be put on its wall would be halved at for ever.
             const double near = end_share * settings.most_off;
             return settings.is_round(wall) &&
                    walls.off(wall, 0.5 * (mesh.at(e.a) + mesh.at(e.b))) > settings.most_off &&
                    walls.off(wall, mesh.at(e.a)) < near && walls.off(wall, mesh.at(e.b)) < near;
           });
  };
  return edge_splitter(mesh, walls,
                       {is_off, [](vec3, std::uint32_t, std::uint32_t) {}, settings.least_quality},
                       settings.most_tets, run)
    .split_all();
}

}  // namespace tedit
