// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QPointF>

#include "base/error.hpp"

namespace tedit::desktop {

class operation_handles;
class viewport;

/// A handle dragged as a hand does: pressed, moved in a straight line by one event a call, dropped.
class handle_moves {
public:
  /// Of the step's handle where it is now. Errors: `not_found` with the handles that there are.
  [[nodiscard]] static expected<handle_moves> begin(const QJsonObject& step, viewport& view,
                                                    const operation_handles& handles);

  /// The next move; false: there is none left.
  [[nodiscard]] bool advance(viewport& view);

private:
  QPointF from_;
  QPointF by_;
  int all_ = 1;
  int done_ = 0;
  bool held_ = false;  ///< The button stays down: for a picture.
};

}  // namespace tedit::desktop
