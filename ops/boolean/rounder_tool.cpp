// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/rounder_tool.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/features/known_wall.hpp"
#include "mesh/features/round_fit.hpp"

namespace tedit::ops {

namespace {

/// An edge is halved so often.
constexpr int most_rounds = 4;

using tool_corner = std::uint32_t;
using tool_edge = std::array<tool_corner, 2>;
using tool_triangle = std::array<tool_corner, 3>;

tool_edge chord_edge_of(const tool_triangle& t, int k) {
  return {std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])};
}

class chord_halver {
public:
  chord_halver(const tool_surface& tool, double most_off) : tool_(tool), most_off_(most_off) {
    for (std::size_t face = 0; face < tool.names.size(); ++face)
      walls_.push_back(wall_of(face));
  }

  std::optional<tool_surface> run() {
    for (int round = 0; round < most_rounds && halve(); ++round)
      is_halved_ = true;
    return is_halved_ ? std::optional(std::move(tool_)) : std::nullopt;
  }

private:
  [[nodiscard]] std::optional<exact_wall> wall_of(std::size_t face) const {
    const auto& geometry = tool_.geometry(face);
    if (geometry.type == surface_geometry::kind::none ||
        geometry.type == surface_geometry::kind::plane)
      return std::nullopt;
    std::vector<tool_triangle> triangles;
    for (std::size_t i = 0; i < tool_.triangles.size(); ++i)
      if (tool_.faces[i] == face)
        triangles.push_back(tool_.triangles[i]);
    return triangles.empty() ? std::nullopt
                             : known_wall(geometry, with_own_points(tool_.points, triangles));
  }

  bool halve() {
    std::map<tool_edge, std::vector<std::size_t>> beside;
    for (std::size_t i = 0; i < tool_.triangles.size(); ++i)
      for (int k = 0; k < 3; ++k)
        beside[chord_edge_of(tool_.triangles[i], k)].push_back(i);
    std::map<tool_edge, tool_corner> middles;
    for (const auto& [e, triangles] : beside)
      if (const auto place = middle_of(e, triangles)) {
        middles.emplace(e, static_cast<tool_corner>(tool_.points.size()));
        tool_.points.push_back(*place);
      }
    const std::size_t before = tool_.triangles.size();
    for (std::size_t i = 0; i < before; ++i)
      split(i, middles);
    return !middles.empty();
  }

  /// On all faces beside the edge; nothing where it is no chord, or there is no such place.
  [[nodiscard]] std::optional<vec3> middle_of(const tool_edge& e,
                                              const std::vector<std::size_t>& triangles) const {
    const vec3 middle = 0.5 * (tool_.points[e[0]] + tool_.points[e[1]]);
    std::vector<wall_demand> demands;
    double off = 0;
    for (const auto i : triangles) {
      const auto& wall = walls_[tool_.faces[i]];
      const auto& t = tool_.triangles[i];
      if (!wall)
        demands.push_back(
          {nullptr, middle,
           normalized(area_vector(tool_.points[t[0]], tool_.points[t[1]], tool_.points[t[2]])),
           false});
      else if (demands.empty() || demands.back().wall != &*wall)
        demands.push_back({&*wall, {}, {}, false});
      if (wall)
        off = std::max(off, std::abs(wall->distance(middle)));
    }
    if (off <= most_off_)
      return std::nullopt;
    const auto place = place_on_walls(demands, middle);
    return place.found ? std::optional(place.at) : std::nullopt;
  }

  /// Into two, three or four, by how many of its edges are halved.
  void split(std::size_t i, const std::map<tool_edge, tool_corner>& middles) {
    auto t = tool_.triangles[i];
    const auto middle = [&](int k) {
      const auto found = middles.find(chord_edge_of(t, k));
      return found == middles.end() ? std::optional<tool_corner>() : found->second;
    };
    std::array<std::optional<tool_corner>, 3> m{middle(0), middle(1), middle(2)};
    const auto halved = std::ranges::count_if(m, [](const auto& one) { return one.has_value(); });
    if (halved == 0)
      return;
    // First the edge that is halved alone, or the two that begin and end at one corner.
    while (halved == 1 ? !m[0] : halved == 2 && m[1].has_value()) {
      std::ranges::rotate(t, t.begin() + 1);
      std::ranges::rotate(m, m.begin() + 1);
    }
    if (halved == 1) {
      put(i, {t[0], *m[0], t[2]});
      add(i, {*m[0], t[1], t[2]});
      return;
    }
    put(i, {t[0], *m[0], *m[2]});
    if (halved == 3) {
      add(i, {*m[0], t[1], *m[1]});
      add(i, {*m[1], t[2], *m[2]});
      add(i, {*m[0], *m[1], *m[2]});
      return;
    }
    add(i, {*m[0], t[1], t[2]});
    add(i, {*m[0], t[2], *m[2]});
  }

  void put(std::size_t i, const tool_triangle& t) { tool_.triangles[i] = t; }
  void add(std::size_t i, const tool_triangle& t) {
    tool_.triangles.push_back(t);
    tool_.faces.push_back(tool_.faces[i]);
  }

  tool_surface tool_;
  double most_off_;
  std::vector<std::optional<exact_wall>> walls_;  ///< Of each face: none of flat ones.
  bool is_halved_ = false;
};

}  // namespace

std::optional<tool_surface> with_shorter_chords(const tool_surface& tool, double most_off) {
  return chord_halver(tool, most_off).run();
}

}  // namespace tedit::ops
