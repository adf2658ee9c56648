// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/operation_rail.hpp"

#include <QAction>
#include <QToolButton>
#include <QVBoxLayout>

namespace tedit::desktop {

operation_rail::operation_rail(QWidget* parent) : tall_scroll(new QWidget, parent) {
  auto* buttons = new QVBoxLayout(widget());
  buttons->setContentsMargins(0, 0, 0, 0);
  buttons->setSpacing(1);
  buttons->addStretch();
  setFocusPolicy(Qt::NoFocus);
  // On the toolbar's own ground.
  viewport()->setAutoFillBackground(false);
  widget()->setAutoFillBackground(false);
}

void operation_rail::clear() {
  for (auto* button : widget()->findChildren<QToolButton*>()) {
    button->hide();
    button->deleteLater();
  }
}

void operation_rail::add(QAction* action) {
  auto* button = new QToolButton;
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setDefaultAction(action);
  button->setIconSize({20, 20});
  button->setFocusPolicy(Qt::TabFocus);
  button->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
  auto* buttons = static_cast<QVBoxLayout*>(widget()->layout());
  buttons->insertWidget(buttons->count() - 1, button);
}

}  // namespace tedit::desktop
