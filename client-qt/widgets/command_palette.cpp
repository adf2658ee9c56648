// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/command_palette.hpp"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace tedit::desktop {

namespace {

constexpr int most_rows = 40;

}  // namespace

command_palette::command_palette(commands& all, QWidget* parent) : QFrame(parent), all_(all) {
  setObjectName("palette");
  setAutoFillBackground(true);
  setFrameShape(QFrame::StyledPanel);
  auto* column = new QVBoxLayout(this);
  letters_ = new QLineEdit;
  letters_->setObjectName("palette_letters");
  letters_->setPlaceholderText(tr("Search commands and operations"));
  letters_->setClearButtonEnabled(true);
  letters_->setAccessibleName(tr("Search commands"));
  hits_ = new QListWidget;
  hits_->setObjectName("palette_hits");
  hits_->setFocusPolicy(Qt::NoFocus);
  hits_->setAccessibleName(tr("Commands"));
  column->addWidget(letters_);
  column->addWidget(hits_);
  letters_->installEventFilter(this);
  connect(letters_, &QLineEdit::textChanged, this, &command_palette::search);
  connect(hits_, &QListWidget::itemClicked, this, &command_palette::run_current);
  hide();
}

void command_palette::open() {
  const QSize room = parentWidget()->size();
  resize(std::min(560, room.width() - 40), std::min(420, room.height() - 80));
  move((room.width() - width()) / 2, 48);
  letters_->clear();
  search({});
  show();
  raise();
  letters_->setFocus();
}

void command_palette::search(const QString& letters) {
  hits_->clear();
  for (const auto* one : all_.search(letters)) {
    if (hits_->count() == most_rows)
      break;
    auto* row = new QListWidgetItem(one->group + QString::fromUtf8("  \u203a  ") + one->title +
                                    (one->shortcut.isEmpty() ? "" : "    " + one->shortcut));
    row->setData(Qt::UserRole, one->id);
    row->setToolTip(one->help);
    if (!all_.is_enabled(*one))
      row->setFlags(row->flags() & ~Qt::ItemIsEnabled);
    hits_->addItem(row);
  }
  hits_->setCurrentRow(0);
}

void command_palette::run_current() {
  const auto* row = hits_->currentItem();
  hide();
  if (row && (row->flags() & Qt::ItemIsEnabled))
    all_.trigger(row->data(Qt::UserRole).toString());
}

bool command_palette::eventFilter(QObject* watched, QEvent* event) {
  if (watched == letters_ && event->type() == QEvent::FocusOut) {
    hide();
  } else if (watched == letters_ && event->type() == QEvent::ShortcutOverride &&
             static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();  // Else it would be the window's shortcut, which ends something else.
    return true;
  } else if (watched == letters_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int row = hits_->currentRow();
    if (key == Qt::Key_Down || key == Qt::Key_Up) {
      hits_->setCurrentRow(std::clamp(row + (key == Qt::Key_Down ? 1 : -1), 0, hits_->count() - 1));
      return true;
    }
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
      run_current();
      return true;
    }
    if (key == Qt::Key_Escape) {
      hide();
      return true;
    }
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace tedit::desktop
