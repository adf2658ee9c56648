// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/optimize/star_energy.hpp"
#include "mesh/optimize/surface_guard.hpp"

namespace tedit {

/// What is worse than this is lifted only where that lowers the badness.
inline constexpr double decent_quality = 0.15;

/// A change must beat the old worst by this factor, so that no two changes undo each other.
inline constexpr double least_gain = 1.001;

/// Moves on a work mesh that raise the worst quality of the tets that they replace and lower their
/// badness, the sum of target / q - 1 over tets below the target, unless none is below 0.15 any
/// more: each improves or leaves the mesh alone. Without the second clause a tet that a thin
/// boundary triangle spoils would be traded for several that are hardly better, again and again.
class worst_first {
public:
  /// @param worst_only leaves out the second clause: more may be lifted, and more become bad.
  worst_first(work_mesh& mesh, const surface_guard& guard, double target, move_counts& counts,
              bool worst_only = false);

  /// Tries to replace tet t by something better: the best flip; else one of its corners moves;
  /// else one goes into a neighbour. True when something changed.
  bool mend(std::uint32_t t);

  /// Splits an edge of t and moves the new vertex to where the worst tet is best.
  bool insert(std::uint32_t t);

private:
  [[nodiscard]] double badness(double q) const;
  [[nodiscard]] double badness_of(std::span<const std::uint32_t> tets) const;
  [[nodiscard]] double badness_after(const work_change& change) const;
  [[nodiscard]] bool is_gain(const work_change& change) const;
  [[nodiscard]] bool is_zip_gain(const work_change& change) const;

  bool flip(std::uint32_t t);
  bool relocate(std::uint32_t v);
  bool relocate_within_surface(std::uint32_t v);
  bool collapse(std::uint32_t t);
  [[nodiscard]] bool plan_collapse(std::uint32_t v, std::uint32_t u, double above,
                                   work_change& change);
  bool split(std::uint32_t t, std::uint32_t a, std::uint32_t b);
  bool move_star(std::uint32_t v, vec3 to);
  void load_star(std::uint32_t v);
  [[nodiscard]] double shortest_edge(std::uint32_t v) const;

  work_mesh& mesh_;
  const surface_guard& guard_;
  double target_;
  double region_worst_;
  bool worst_only_;
  move_counts& counts_;

  // Room that is kept between calls.
  work_change change_, best_;
  work_ring ring_;
  std::vector<std::uint32_t> star_, fresh_;
  std::vector<fan_facet> fan_;
  vertex_star faces_;
};

/// The place near x, found by compass search, where the worst tet of the star is best. `step`: the
/// first step's length in m.
[[nodiscard]] vec3 best_place(const vertex_star& star, vec3 x, double step);

}  // namespace tedit
