// SPDX-License-Identifier: AGPL-3.0-or-later
// What makers of tools share that carry outlines through space in layers.
#pragma once

#include "ops/tools/tools.hpp"

namespace tedit::ops {

/// In how many parts a length goes whose pieces measure about `size`: 1 to 10,000.
[[nodiscard]] int parts_of(double length, double size);

/// Outer outlines counter-clockwise, holes clockwise: walls then look outward.
void orient(std::vector<outline>& all);

/// Long straight edges in parts of about `size`, oriented.
[[nodiscard]] std::vector<outline> divided_outlines(const profile& what, double size);

/// What lies between the outlines, whose points come first, in their order. Errors:
/// `mesher_failed` where outlines cross.
[[nodiscard]] expected<planar_filling> fill_outlines(const std::vector<outline>& outlines,
                                                     double size, services& host);

/// Layers of the outlines' points, put one over the other, `rim` points each.
struct extruder {
  tool_surface tool;

  /// Walls between one layer and the next; `round`: also from the last to the first. `layers`:
  /// spaces between layers.
  void add_walls(const std::vector<outline>& outlines, std::uint32_t rim, int layers,
                 bool round = false);

  /// Both ends, where the filling's interior points lie at `bottom` and at `top`.
  template <class Place>
  void add_ends(const planar_filling& filling, std::uint32_t rim, int layers, const Place& bottom,
                const Place& top) {
    std::array<std::uint32_t, 2> first{};
    for (const bool above : {false, true}) {
      first[above] = static_cast<std::uint32_t>(tool.points.size());
      for (std::size_t i = rim; i < filling.points.size(); ++i)
        tool.points.push_back((above ? top : bottom)(filling.points[i]));
    }
    const auto at = [&](std::uint32_t i, bool above) {
      if (i >= rim)
        return first[above] + i - rim;
      return above ? static_cast<std::uint32_t>(layers) * rim + i : i;
    };
    for (const auto& t : filling.triangles) {
      add(at(t[0], false), at(t[2], false), at(t[1], false), 0);
      add(at(t[0], true), at(t[1], true), at(t[2], true), 1);
    }
  }

private:
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t face) {
    tool.triangles.push_back({a, b, c});
    tool.faces.push_back(face);
  }
};

}  // namespace tedit::ops
