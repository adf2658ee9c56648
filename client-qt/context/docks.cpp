// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/context/docks.hpp"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>

namespace tedit::desktop {

QDockWidget& docks::add(const QString& name, const QString& title, QWidget* content) {
  auto* dock = new QDockWidget(title, &window_);
  dock->setObjectName(name);
  dock->setWidget(content);
  all_[name] = dock;
  return *dock;
}

void docks::raise(const QString& name) const {
  of(name).raise();
}

bool docks::has_focus(const QString& name) const {
  const auto* focus = QApplication::focusWidget();
  return focus && of(name).isAncestorOf(focus);
}

}  // namespace tedit::desktop
