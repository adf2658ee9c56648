// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/wheel_guard.hpp"

#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QScrollBar>

namespace tedit::desktop {

/// The field that a widget is, or is the line of; null when the wheel is not a way to change it.
static QWidget* field_of(QObject* what) {
  for (auto* one = qobject_cast<QWidget*>(what); one; one = one->parentWidget()) {
    if (qobject_cast<QAbstractSpinBox*>(one) || qobject_cast<QComboBox*>(one) ||
        (qobject_cast<QAbstractSlider*>(one) && !qobject_cast<QScrollBar*>(one)))
      return one;
    if (one->isWindow())  // The list of a combo box scrolls.
      break;
  }
  return nullptr;
}

/// To what the field stands in and scrolls by.
static void hand_on(const QWidget& field, QEvent& wheel) {
  for (auto* up = field.parentWidget(); up; up = up->parentWidget())
    if (auto* area = qobject_cast<QAbstractScrollArea*>(up)) {
      QCoreApplication::sendEvent(area->viewport(), &wheel);
      break;
    }
  wheel.accept();
}

bool wheel_guard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseButtonPress) {
    if (auto* field = field_of(watched))
      clicked_ = field;
  } else if (event->type() == QEvent::FocusOut && watched == clicked_) {
    clicked_ = nullptr;
  } else if (event->type() == QEvent::Polish) {
    if (auto* field = field_of(watched); field == watched && field)
      if (field->focusPolicy() == Qt::WheelFocus)
        field->setFocusPolicy(Qt::StrongFocus);
  } else if (event->type() == QEvent::Wheel) {
    auto* field = field_of(watched);
    if (field && (field != clicked_ || !field->hasFocus())) {
      hand_on(*field, *event);
      return true;
    }
  }
  return false;
}

}  // namespace tedit::desktop
