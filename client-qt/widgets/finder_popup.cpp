// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/finder_popup.hpp"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace tedit::desktop {

finder_popup::finder_popup(const QString& name, const QString& placeholder, QWidget* parent)
    : QFrame(parent), letters_(new QLineEdit), hits_(new QListWidget) {
  setObjectName(name);
  setAutoFillBackground(true);
  setFrameShape(QFrame::StyledPanel);
  auto* column = new QVBoxLayout(this);
  letters_->setObjectName(name + "_letters");
  letters_->setProperty("role", "search");
  letters_->setPlaceholderText(placeholder);
  letters_->setClearButtonEnabled(true);
  letters_->setAccessibleName(placeholder);
  hits_->setObjectName(name + "_hits");
  hits_->setFocusPolicy(Qt::NoFocus);
  hits_->setAccessibleName(tr("What fits"));
  column->addWidget(letters_);
  column->addWidget(hits_);
  letters_->installEventFilter(this);
  connect(letters_, &QLineEdit::textChanged, this, [this](const QString& text) { search(text); });
  connect(hits_, &QListWidget::itemClicked, this, &finder_popup::take_current);
  connect(hits_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (open_)
      walk(row);
  });
  hide();
}

/// Its children go later than what they would tell.
finder_popup::~finder_popup() {
  letters_->removeEventFilter(this);
  letters_->disconnect(this);
  hits_->disconnect(this);
}

void finder_popup::open() {
  const QSize room = parentWidget()->size();
  resize(std::min(560, room.width() - 40), std::min(420, room.height() - 80));
  move((room.width() - width()) / 2, 48);
  letters_->clear();
  search({});
  show();
  raise();
  letters_->setFocus();
  open_ = true;
}

void finder_popup::take_current() {
  open_ = false;
  hide();
  take(hits_->currentRow());
}

void finder_popup::leave() {
  if (!open_)
    return;
  open_ = false;
  hide();
  give_up();
}

bool finder_popup::press(int key) {
  if (key == Qt::Key_Down || key == Qt::Key_Up) {
    if (hits_->count() > 0)
      hits_->setCurrentRow(
        std::clamp(hits_->currentRow() + (key == Qt::Key_Down ? 1 : -1), 0, hits_->count() - 1));
    return true;
  }
  if (key == Qt::Key_Return || key == Qt::Key_Enter)
    take_current();
  else if (key == Qt::Key_Escape)
    leave();
  else
    return false;
  return true;
}

bool finder_popup::eventFilter(QObject* watched, QEvent* event) {
  if (watched != letters_)
    return QFrame::eventFilter(watched, event);
  if (event->type() == QEvent::FocusOut) {
    leave();
  } else if (event->type() == QEvent::ShortcutOverride &&
             static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();  // Else it would be the window's shortcut, which ends something else.
    return true;
  } else if (event->type() == QEvent::KeyPress && press(static_cast<QKeyEvent*>(event)->key())) {
    return true;
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace tedit::desktop
