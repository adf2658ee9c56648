// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/context/appearance.hpp"

#include <QApplication>
#include <QSettings>

namespace tedit::desktop {

void appearance::set_dark(bool on) {
  now_ = make_theme(on);
  settings_.setValue("look", on ? "dark" : "light");
  qApp->setPalette(now_.palette);
  if (on) {
    // Fusion draws a spin box's frame as much darker than the window: on a dark one it is not seen.
    constexpr int darker_by = 140;
    auto framed = now_.palette;
    framed.setColor(QPalette::Window, now_.frame.lighter(darker_by));
    qApp->setPalette(framed, "QAbstractSpinBox");
  }
  qApp->setStyleSheet(now_.style_sheet);
  emit changed(now_);
}

}  // namespace tedit::desktop
