// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <span>
#include <vector>

#include "scan/mesher/ground.hpp"

namespace tedit::scan {

/// A closed surface of triangles in patches, to be changed in small steps that keep it closed and
/// its lines (between patches, and creases) whole.
class working_surface {
public:
  explicit working_surface(const ground& base);

  using vertex = std::uint32_t;

  [[nodiscard]] std::size_t triangle_count() const { return triangles_.size(); }
  [[nodiscard]] bool is_live(std::uint32_t t) const { return live_[t]; }
  [[nodiscard]] const triangle_corners& corners(std::uint32_t t) const { return triangles_[t]; }
  [[nodiscard]] std::uint32_t patch(std::uint32_t t) const { return patches_[t]; }
  [[nodiscard]] std::size_t point_count() const { return points_.size(); }
  [[nodiscard]] const vec3& point(vertex v) const { return points_[v]; }
  void move(vertex v, vec3 to) { points_[v] = to; }
  /// Triangles at a vertex; none where it is gone.
  [[nodiscard]] const std::vector<std::uint32_t>& around(vertex v) const { return of_[v]; }
  /// Those at an edge.
  [[nodiscard]] std::vector<std::uint32_t> beside(vertex a, vertex b) const;
  /// Sorted.
  [[nodiscard]] std::vector<vertex> neighbours(vertex v) const;
  /// Whether the edge is on a line.
  [[nodiscard]] bool is_line(vertex a, vertex b) const;
  /// The other ends of the lines at a vertex.
  [[nodiscard]] std::vector<vertex> line_neighbours(vertex v) const;
  /// Corners stay where they are: lines end there, or bend.
  [[nodiscard]] bool is_corner(vertex v) const;

  [[nodiscard]] vertex opposite(std::uint32_t t, vertex a, vertex b) const;
  /// Twice the area vector of a triangle with these corners.
  [[nodiscard]] vec3 normal_of(const triangle_corners& c) const;
  /// 2 r_in / R_circ: 1 for one with equal sides.
  [[nodiscard]] double quality_of(const triangle_corners& c) const;

  /// Puts a point into an edge.
  vertex split(vertex a, vertex b, vec3 at);
  /// Whether both ends may become one: the surface stays the same kind of surface, and lines too.
  [[nodiscard]] bool may_merge(vertex gone, vertex kept) const;
  void merge(vertex gone, vertex kept);
  /// The other diagonal of the two triangles at an edge; `can_flip` first.
  [[nodiscard]] bool can_flip(vertex a, vertex b) const;
  void flip(vertex a, vertex b);

private:
  void link(std::uint32_t t);
  void unlink(std::uint32_t t);
  void add(const triangle_corners& c, std::uint32_t patch);

  std::vector<vec3> points_;
  std::vector<triangle_corners> triangles_;
  std::vector<std::uint32_t> patches_;
  std::vector<bool> live_;
  std::vector<std::vector<std::uint32_t>> of_;
  std::set<edge_key> creases_;
};

}  // namespace tedit::scan
