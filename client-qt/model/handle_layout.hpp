// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "client-qt/model/handle_lens.hpp"
#include "client-qt/model/handle_pose.hpp"

/// Where the handles of a form are on the screen. No window: tested with a lens made by hand.
namespace tedit::desktop {

/// How near the pointer must be to a handle's knob, pixels.
inline constexpr double handle_reach = 12;

/// A handle on the screen.
struct laid_handle {
  const handle* of = nullptr;  ///< Of the plan, which must live on.
  QPointF knob;                ///< Where it is grabbed.
  std::vector<QPointF> line;   ///< An arrow's shaft, a ring; empty for a ball.
  vec3 root;                   ///< m: what the value is measured from.
  vec3 along;                  ///< Unit: which way the value grows; of a ring to its knob.
  double radius = 0;           ///< direction, turn: of the ball or circle that the knob is on, m.
  double value = 0;            ///< SI; of lengths, rings and spans.
};

/// Knobs keep clear of the place and of each other; a handle whose value is 0 is left out unless it
/// is the first of its kind. The place comes last: it is grabbed where nothing else is.
[[nodiscard]] std::vector<laid_handle> lay_out(const handle_plan& plan,
                                               const ops::parameters& values,
                                               const handle_pose& pose, const lens& by);

/// The handle under the pointer: the nearest within `handle_reach`, or null.
[[nodiscard]] const laid_handle* handle_at(const std::vector<laid_handle>& all, QPointF pointer);

/// "Depth 5 mm"; what a knob says while it is pointed at.
[[nodiscard]] QString words_of(const laid_handle& one, const ops::parameters& values);

}  // namespace tedit::desktop
