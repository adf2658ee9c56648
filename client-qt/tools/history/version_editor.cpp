// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/history/version_editor.hpp"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScreen>
#include <QVBoxLayout>

#include <utility>

namespace tedit::desktop {

namespace {

constexpr int longest_name = 80;
constexpr int longest_note = 4000;

}  // namespace

version_editor::version_editor(const client::version_info& version, QWidget* parent)
    : QFrame(parent, Qt::Popup), version_(version) {
  setAttribute(Qt::WA_DeleteOnClose);
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  auto* column = new QVBoxLayout(this);
  auto* title = new QLabel(tr("Version %1").arg(version.number));
  title->setProperty("role", "section");
  name_ = new QLineEdit(QString::fromStdString(version.name));
  name_->setObjectName("version_name");
  name_->setMaxLength(longest_name);
  name_->setPlaceholderText(tr("Name"));
  note_ = new QPlainTextEdit(QString::fromStdString(version.note));
  note_->setObjectName("version_note");
  note_->setPlaceholderText(tr("Note"));
  note_->setTabChangesFocus(true);
  auto* hint = new QLabel(tr("Enter keeps, Esc drops"));
  hint->setProperty("role", "faint");
  for (QWidget* one : {static_cast<QWidget*>(title), static_cast<QWidget*>(name_),
                       static_cast<QWidget*>(note_), static_cast<QWidget*>(hint)})
    column->addWidget(one);
  for (QWidget* one : {static_cast<QWidget*>(name_), static_cast<QWidget*>(note_)})
    one->installEventFilter(this);
  resize(260, 180);
}

void version_editor::open_beside(const QRect& place) {
  QPoint at(place.right() + 6, place.top());
  if (const auto* screen = QGuiApplication::screenAt(place.center())) {
    const QRect room = screen->availableGeometry();
    if (at.x() + width() > room.right())
      at.setX(place.left() - width() - 6);
    at.setY(std::min(at.y(), room.bottom() - height()));
  }
  move(at);
  show();
  name_->setFocus();
  name_->selectAll();
}

bool version_editor::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress)
    return QFrame::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  if (key->key() == Qt::Key_Escape) {
    done_ = true;
    close();
    return true;
  }
  const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
  if (enter && (watched == name_ || key->modifiers().testFlag(Qt::ControlModifier))) {
    close();
    return true;
  }
  return QFrame::eventFilter(watched, event);
}

void version_editor::hideEvent(QHideEvent* event) {
  take();
  QFrame::hideEvent(event);
}

void version_editor::take() {
  if (std::exchange(done_, true))
    return;
  const QString name = name_->text().simplified();
  const QString note = note_->toPlainText().trimmed().left(longest_note);
  if (name.toStdString() != version_.name || note.toStdString() != version_.note)
    emit accepted(version_.number, name, note);
}

}  // namespace tedit::desktop
