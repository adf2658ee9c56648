// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/documents/name_form.hpp"
#include "client-qt/model/server_words.hpp"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

namespace tedit::desktop {

static constexpr int form_width = 320;

name_form::name_form(QWidget* parent) : QFrame(parent), name_(new QLineEdit), words_(new QLabel) {
  setObjectName("name_form");
  setAutoFillBackground(true);
  setFrameShape(QFrame::StyledPanel);
  auto* column = new QVBoxLayout(this);
  auto* title = new QLabel(tr("Name of the document"));
  title->setProperty("role", "section");
  name_->setObjectName("document_name");
  name_->setAccessibleName(title->text());
  name_->installEventFilter(this);
  words_->setObjectName("document_name_words");
  words_->setProperty("role", "faint");
  words_->setWordWrap(true);
  for (QWidget* one :
       {static_cast<QWidget*>(title), static_cast<QWidget*>(name_), static_cast<QWidget*>(words_)})
    column->addWidget(one);
  hide();
}

/// Its child goes later than what it would tell.
name_form::~name_form() {
  name_->removeEventFilter(this);
}

void name_form::open(const QString& name, QPoint at) {
  before_ = name;
  name_->setReadOnly(false);
  name_->setText(name);
  words_->setText(tr("Enter renames it, Esc leaves it"));
  setFixedWidth(form_width);
  adjustSize();
  move(at);
  show();
  raise();
  name_->setFocus();
  name_->selectAll();
}

void name_form::leave() {
  if (isHidden())
    return;
  const bool had_keys = name_->hasFocus();
  hide();
  if (had_keys)
    emit left();
}

void name_form::refuse(const error& why) {
  name_->setReadOnly(false);
  words_->setText(one_line({why.code, why.message, why.remedy, {}}));
  adjustSize();
}

/// Names of several words are what people type, and no server takes a blank.
void name_form::take() {
  const QString name = name_->text().simplified().replace(' ', '-');
  if (name_->isReadOnly())
    return;
  if (name.isEmpty() || name == before_)
    return leave();
  name_->setReadOnly(true);
  emit wanted(name);
}

bool name_form::eventFilter(QObject* watched, QEvent* event) {
  const auto key = [&] { return static_cast<QKeyEvent*>(event)->key(); };
  if (event->type() == QEvent::FocusOut) {
    // Going to another program and coming back is no answer.
    if (static_cast<QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason)
      leave();
  } else if (event->type() == QEvent::ShortcutOverride && key() == Qt::Key_Escape) {
    event->accept();  // Else it would be the window's shortcut, which ends something else.
    return true;
  } else if (event->type() == QEvent::KeyPress && key() == Qt::Key_Escape) {
    leave();
    return true;
  } else if (event->type() == QEvent::KeyPress &&
             (key() == Qt::Key_Return || key() == Qt::Key_Enter)) {
    take();
    return true;
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace tedit::desktop
