// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QEvent>
#include <QJsonObject>
#include <QPointF>

#include "client/recipe.hpp"

namespace tedit::desktop {

struct toolbox;
class viewport;
struct window_context;

/// Whether the step waits until the field is final.
[[nodiscard]] bool waits_for_field(const client::window_step& step);

/// What the left button of a mouse does at a place of the view.
void move_mouse(viewport& view, QEvent::Type type, QPointF at, Qt::MouseButton held);

/// One of the moves that turn the part in a `drag` step.
void drag(viewport& view, int moves_left);

/// Does what a hand does at once: looks at the part, selects, takes pictures. `step` has been read
/// as a recipe's, so its fields have their types and sizes; what they name may not be there.
/// Errors: `not_found`, `surface_not_found`, `invalid_argument`, `io_error`.
[[nodiscard]] expected<void> move_window(const std::string& kind, const QJsonObject& step,
                                         window_context& in, toolbox& tools);

}  // namespace tedit::desktop
