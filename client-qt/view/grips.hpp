// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QPointF>
#include <Qt>

namespace tedit::desktop {

/// What lies over the part and is dragged instead of it. The view asks before it does anything
/// else with the mouse; places are the view's.
class grips {
public:
  virtual ~grips() = default;

  /// The pointer is there and no button is held: whether it is over a grip.
  virtual bool hover(QPointF at) = 0;
  /// The left button goes down: whether a grip is taken. `drag` and `drop` follow if so.
  virtual bool take(QPointF at) = 0;
  virtual void drag(QPointF to, Qt::KeyboardModifiers modifiers) = 0;
  virtual void drop() = 0;
  /// The pointer has left the view.
  virtual void leave() = 0;
};

}  // namespace tedit::desktop
