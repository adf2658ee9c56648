// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

namespace tedit::desktop {

/// One dialog of each kind, not modal: asked for again it comes to the front.
template <class Dialog, class Make>
void show_one(QWidget& window, Make make) {
  auto* dialog = window.findChild<Dialog*>();
  if (!dialog) {
    dialog = make();
    dialog->setAttribute(Qt::WA_DeleteOnClose);
  }
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

}  // namespace tedit::desktop
