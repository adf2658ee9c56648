// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/undo_guard.hpp"

#include <QAbstractSpinBox>
#include <QKeyEvent>
#include <QLineEdit>

namespace tedit::desktop {

/// A spin box has the focus for its line.
static QLineEdit* line_of(QObject* what) {
  if (auto* line = qobject_cast<QLineEdit*>(what))
    return line;
  return qobject_cast<QAbstractSpinBox*>(what) ? what->findChild<QLineEdit*>() : nullptr;
}

bool undo_guard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
    return false;
  auto* line = line_of(watched);
  if (!line)
    return false;
  const auto* key = static_cast<QKeyEvent*>(event);
  if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
    line->setModified(false);
  } else if (event->type() == QEvent::ShortcutOverride && !line->isModified() &&
             (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo))) {
    event->ignore();
    return true;
  }
  return false;
}

}  // namespace tedit::desktop
