// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/context/appearance.hpp"

#include <QApplication>
#include <QSettings>

namespace tedit::desktop {

void appearance::set_dark(bool on) {
  now_ = make_theme(on);
  settings_.setValue("look", on ? "dark" : "light");
  qApp->setPalette(now_.palette);
  qApp->setStyleSheet(now_.style_sheet);
  emit changed(now_);
}

}  // namespace tedit::desktop
