// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/documents/recent_documents.hpp"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

#include "client-qt/model/document_name.hpp"

namespace tedit::desktop {

namespace {

constexpr QSize picture_size(132, 84);
constexpr QSize cell(168, 136);
constexpr int rows_shown = 2;

/// `ratio`: pixels of the screen for one of the window.
QPixmap picture_of(const recent_document& one, const QColor& empty, double ratio) {
  QPixmap result(picture_size * ratio);
  if (one.picture.isNull())
    result.fill(empty);
  else
    result = QPixmap::fromImage(
      one.picture.scaled(result.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  result.setDevicePixelRatio(ratio);
  return result;
}

}  // namespace

recent_documents::recent_documents(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* title = new QLabel(tr("Go on with"));
  title->setProperty("role", "section");
  column->addWidget(title);
  list_ = new QListWidget;
  list_->setObjectName("recent");
  list_->setAccessibleName(tr("Documents that were open before"));
  list_->setViewMode(QListView::IconMode);
  list_->setResizeMode(QListView::Adjust);
  list_->setMovement(QListView::Static);
  list_->setWordWrap(true);
  list_->setIconSize(picture_size);
  list_->setGridSize(cell);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setContextMenuPolicy(Qt::CustomContextMenu);
  list_->viewport()->setAutoFillBackground(false);  // The page shows through.
  list_->installEventFilter(this);
  connect(list_, &QListWidget::customContextMenuRequested, this, &recent_documents::show_menu);
  connect(list_, &QListWidget::itemClicked, this, [this](const QListWidgetItem* row) {
    emit document_wanted(row->data(Qt::UserRole).toString());
  });
  column->addWidget(list_);
  undo_row_ = new QWidget;
  auto* row = new QHBoxLayout(undo_row_);
  row->setContentsMargins(0, 0, 0, 0);
  what_ = new QLabel;
  what_->setProperty("role", "faint");
  auto* back = new QPushButton(tr("Undo"));
  back->setObjectName("recent_undo");
  connect(back, &QPushButton::clicked, this, &recent_documents::undo);
  row->addWidget(what_);
  row->addWidget(back);
  row->addStretch();
  column->addWidget(undo_row_);
  undo_row_->hide();
}

void recent_documents::show_documents(std::vector<recent_document> all) {
  all_ = std::move(all);
  removed_.reset();
  fill();
}

void recent_documents::fill() {
  const int chosen = list_->currentRow();
  list_->clear();
  const auto now = QDateTime::currentDateTime();
  for (const auto& one : all_) {
    const auto shown = title_of(one.name);
    const auto used = one.used.isValid() ? one.used : shown.made;
    const auto words =
      QFontMetrics(font()).elidedText(shown.words, Qt::ElideMiddle, cell.width() - 16);
    const QPixmap picture =
      picture_of(one, palette().color(QPalette::AlternateBase), devicePixelRatioF());
    QIcon both(picture);
    both.addPixmap(picture, QIcon::Selected);  // Else it is tinted.
    auto* row =
      new QListWidgetItem(both, used.isValid() ? words + "\n" + moment(used, now) : words);
    row->setData(Qt::UserRole, one.name);
    row->setToolTip(one.name);
    list_->addItem(row);
  }
  const int rows = all_.size() > 4 ? rows_shown : 1;
  list_->setFixedHeight(rows * cell.height() + 4);
  list_->setVisible(!all_.empty());
  if (chosen >= 0 && list_->count() > 0)
    list_->setCurrentRow(std::min(chosen, list_->count() - 1));
  undo_row_->setVisible(removed_.has_value());
  setVisible(!all_.empty() || removed_);
}

QStringList recent_documents::names() const {
  QStringList result;
  for (const auto& one : all_)
    result << one.name;
  return result;
}

void recent_documents::remove(int row) {
  if (row < 0 || row >= static_cast<int>(all_.size()))
    return;
  const auto at = all_.begin() + row;
  what_->setText(
    tr("%1 was taken from the list; the document itself stays.").arg(title_of(at->name).words));
  removed_.emplace(row, std::move(*at));
  all_.erase(at);
  fill();
  emit changed(names());
}

void recent_documents::undo() {
  if (!removed_)
    return;
  auto [row, one] = *std::exchange(removed_, std::nullopt);
  all_.insert(all_.begin() + row, std::move(one));
  fill();
  list_->setCurrentRow(row);
  emit changed(names());
}

void recent_documents::show_menu(QPoint at) {
  auto* row = list_->itemAt(at);
  if (!row)
    return;
  list_->setCurrentItem(row);
  const auto name = row->data(Qt::UserRole).toString();
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Open (Enter)"), this, [this, name] { emit document_wanted(name); });
  menu->addAction(tr("Take from this list (Del)"), this,
                  [this, number = list_->row(row)] { remove(number); });
  menu->popup(list_->viewport()->mapToGlobal(at));
}

bool recent_documents::eventFilter(QObject* watched, QEvent* event) {
  if (watched == list_ && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool opens = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
    if (opens && list_->currentItem()) {
      emit document_wanted(list_->currentItem()->data(Qt::UserRole).toString());
      return true;
    }
    if (key->key() == Qt::Key_Delete) {
      remove(list_->currentRow());
      return true;
    }
    if (key->matches(QKeySequence::Undo) && removed_) {
      undo();
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace tedit::desktop
