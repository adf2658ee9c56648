// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "client-qt/model/handle_layout.hpp"

namespace tedit::desktop {

/// A drag as it began; nothing of it changes while it goes on, so that each place of the pointer
/// has one value.
struct handle_drag {
  laid_handle from;
  handle_pose pose;
  QPointF pressed;
  lens by;
};

/// What a handle is dragged to.
struct dragged_value {
  ops::parameter_value value;
  QString snapped;  ///< To what: "along x"; empty where it is free.
};

/// The value of a parameter when the pointer is there; all handles but the place, which lies on
/// the part. Lengths go by round steps of about a pixel, directions and ways lock in on the part's
/// axes and the wall's normal; not with `free`. Within the parameter's range.
[[nodiscard]] dragged_value drag_to(const handle_drag& drag, QPointF pointer, bool free);

/// Three numbers as a host reads them.
[[nodiscard]] std::string vector_text(const vec3& v, double step);

}  // namespace tedit::desktop
