// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

namespace tedit::desktop {

/// Undo and redo take back what is being typed into a field, as long as it is being typed: once it
/// was entered, they are the window's, also with the focus still in the field. For all widgets of
/// the program that it filters.
class undo_guard : public QObject {
public:
  using QObject::QObject;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace tedit::desktop
