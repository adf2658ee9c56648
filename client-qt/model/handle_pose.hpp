// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "client-qt/model/handle_plan.hpp"
#include "client/surface.hpp"

namespace tedit::desktop {

/// Axes of a tool: z looks out of the part, x is the way that a profile's length goes.
struct tool_frame {
  vec3 at;  ///< m.
  vec3 x{1, 0, 0};
  vec3 y{0, 1, 0};
  vec3 z{0, 0, 1};

  /// A point by its coordinates in it, m.
  [[nodiscard]] vec3 point(double u, double v, double w) const {
    return at + u * x + v * y + w * z;
  }
};

/// Where the values of a form put the tool.
struct handle_pose {
  tool_frame frame;
  vec3 wall_normal{0, 0, 1};       ///< Of the wall there, whatever direction is given.
  vec3 feature;                    ///< m: the middle of what is picked, where ways begin;
  std::optional<vec3> axis;        ///< its axis, where it is round: it is moved across that;
  double half_length = 0;          ///< and how far it goes along it to both sides, m.
  std::array<double, 6> bounds{};  ///< Of the part, m: x low, x high, y low, ...
};

/// Nothing where neither a place is given nor a wall is picked. `bounds`: of the part.
/// Cost: O(facets).
[[nodiscard]] std::optional<handle_pose> pose_of(const handle_plan& plan,
                                                 const ops::parameters& values,
                                                 const std::vector<surface_id>& picked,
                                                 const client::surface_model& part,
                                                 const std::array<double, 6>& bounds);

/// Values of a form by id; 0 and nothing where there is none of that kind.
[[nodiscard]] double number_in(const ops::parameters& values, const std::string& id);
[[nodiscard]] std::optional<vec3> vector_in(const ops::parameters& values, const std::string& id);
[[nodiscard]] std::string text_in(const ops::parameters& values, const std::string& id);

/// Half of what a profile measures along and across, m, as ops/tools makes it: a width of 0 is a
/// square's, or half of a slot's. For round ones both are the radius.
struct half_extents {
  double along = 0;
  double across = 0;
};
[[nodiscard]] half_extents profile_extents(const ops::parameters& values);

}  // namespace tedit::desktop
