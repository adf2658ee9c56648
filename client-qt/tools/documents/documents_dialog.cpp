// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/documents/documents_dialog.hpp"

#include <QDateTime>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QStyle>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

#include "client-qt/model/document_name.hpp"
#include "client-qt/model/server_words.hpp"

namespace tedit::desktop {

namespace {

QString size_of(const client::document_info& one) {
  if (one.bytes == 0)
    return documents_dialog::tr("holds nothing yet");
  return QLocale().formattedDataSize(static_cast<qint64>(one.bytes), 1, QLocale::DataSizeSIFormat);
}

/// Who has it open, by number: a server knows clients and no people.
QString openness_of(const client::document_info& one, bool here) {
  const unsigned others = one.clients - (here && one.clients > 0 ? 1 : 0);
  if (here)
    return others == 0 ? documents_dialog::tr("here")
                       : documents_dialog::tr("here and elsewhere (%1)").arg(others);
  return others == 0 ? QString() : documents_dialog::tr("elsewhere (%1)").arg(others);
}

QDateTime change_of(const client::document_info& one) {
  return QDateTime::fromString(QString::fromStdString(one.changed_at), Qt::ISODate);
}

}  // namespace

documents_dialog::documents_dialog(QWidget* parent)
    : QDialog(parent), list_(new QTreeWidget), letters_(new QLineEdit), words_(new QLabel) {
  setWindowTitle(tr("Documents on the server"));
  resize(720, 480);
  auto* column = new QVBoxLayout(this);
  letters_->setObjectName("documents_search");
  letters_->setPlaceholderText(tr("Search documents"));
  letters_->setAccessibleName(letters_->placeholderText());
  letters_->setClearButtonEnabled(true);
  connect(letters_, &QLineEdit::textChanged, this, &documents_dialog::fill);
  column->addWidget(letters_);
  list_->setObjectName("documents");
  list_->setAccessibleName(windowTitle());
  list_->setRootIsDecorated(false);
  list_->setHeaderLabels({tr("Document"), tr("Size"), tr("Last change"), tr("In use")});
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  connect(list_, &QTreeWidget::itemActivated, this, &documents_dialog::open_chosen);
  connect(list_, &QTreeWidget::itemSelectionChanged, this, [this] {
    ask(question::none);
    refresh_buttons();
  });
  column->addWidget(list_, 1);
  column->addWidget(make_question());
  words_->setObjectName("documents_words");
  words_->setWordWrap(true);
  column->addWidget(words_);
  column->addWidget(make_buttons());
  // Enter opens a document or answers a question; it must not press another button.
  for (auto* button : findChildren<QPushButton*>())
    button->setAutoDefault(false);
  refresh_buttons();
}

QPushButton* documents_dialog::add_button(const char* name, const QString& words, QWidget* row) {
  auto* button = new QPushButton(words);
  button->setObjectName(name);
  row->layout()->addWidget(button);
  return button;
}

QWidget* documents_dialog::make_question() {
  question_row_ = new QWidget;
  auto* row = new QHBoxLayout(question_row_);
  row->setContentsMargins(0, 0, 0, 0);
  question_words_ = new QLabel;
  question_words_->setObjectName("documents_question");
  question_words_->setWordWrap(true);
  row->addWidget(question_words_, 1);
  name_ = new QLineEdit;
  name_->setObjectName("documents_name");
  name_->setAccessibleName(tr("New name"));
  connect(name_, &QLineEdit::returnPressed, this, &documents_dialog::answer);
  row->addWidget(name_, 1);
  yes_ = add_button("documents_yes", {}, question_row_);
  connect(yes_, &QPushButton::clicked, this, &documents_dialog::answer);
  connect(add_button("documents_no", tr("Leave it"), question_row_), &QPushButton::clicked, this,
          [this] { ask(question::none); });
  question_row_->hide();
  return question_row_;
}

QWidget* documents_dialog::make_buttons() {
  auto* buttons = new QWidget;
  auto* row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 0, 0);
  open_ = add_button("documents_open", tr("Open"), buttons);
  copy_ = add_button("documents_copy", tr("Copy"), buttons);
  rename_ = add_button("documents_rename", tr("Rename"), buttons);
  delete_ = add_button("documents_delete", tr("Delete"), buttons);
  row->addStretch();
  auto* again = add_button("documents_refresh", tr("Refresh"), buttons);
  auto* close = add_button("documents_close", tr("Close"), buttons);
  connect(open_, &QPushButton::clicked, this, &documents_dialog::open_chosen);
  connect(copy_, &QPushButton::clicked, this, [this] { ask(question::copy); });
  connect(rename_, &QPushButton::clicked, this, [this] { ask(question::rename); });
  connect(delete_, &QPushButton::clicked, this, [this] { ask(question::remove); });
  connect(again, &QPushButton::clicked, this, &documents_dialog::list_wanted);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  return buttons;
}

// -- the list ------------------------------------------------------------------------

void documents_dialog::show_documents(std::vector<client::document_info> all, const QString& here) {
  all_ = std::move(all);
  // Texts of one form and zone: they are in the order of the times. Those without one are new.
  std::ranges::stable_sort(all_, [](const auto& a, const auto& b) {
    return a.changed_at.empty() != b.changed_at.empty() ? a.changed_at.empty()
                                                        : a.changed_at > b.changed_at;
  });
  here_ = here;
  fill();
}

void documents_dialog::fill() {
  const auto before = chosen();
  const auto now = QDateTime::currentDateTime();
  const QSignalBlocker quiet(list_);
  list_->clear();
  for (const auto& one : all_) {
    const auto name = QString::fromStdString(one.name);
    if (!name.contains(letters_->text().trimmed(), Qt::CaseInsensitive))
      continue;
    const auto changed = change_of(one);
    auto* row = new QTreeWidgetItem(
      list_, {name, size_of(one), changed.isValid() ? moment(changed.toLocalTime(), now) : "",
              openness_of(one, name == here_)});
    row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    if (name == before)
      list_->setCurrentItem(row);
  }
  if (!list_->currentItem() && list_->topLevelItemCount() > 0)
    list_->setCurrentItem(list_->topLevelItem(0));
  if (asked_ != question::none && chosen() != about_)
    ask(question::none);
  refresh_buttons();
}

QString documents_dialog::chosen() const {
  const auto* row = list_->currentItem();
  return row ? row->text(0) : QString();
}

void documents_dialog::refresh_buttons() {
  const bool any = !chosen().isEmpty() && !waiting_;
  for (auto* button : {open_, copy_, rename_, delete_})
    button->setEnabled(any);
  yes_->setEnabled(!waiting_);
  name_->setReadOnly(waiting_);
}

void documents_dialog::open_chosen() {
  if (!chosen().isEmpty() && !waiting_)
    emit open_wanted(chosen());
}

// -- questions -----------------------------------------------------------------------

void documents_dialog::ask(question what) {
  asked_ = what;
  about_ = chosen();
  words_->clear();
  question_row_->setVisible(what != question::none);
  name_->setVisible(what != question::remove);
  if (what == question::none)
    return;
  if (what == question::copy) {
    question_words_->setText(tr("Name of the copy of %1").arg(about_));
    yes_->setText(tr("Copy"));
    name_->setText(about_ + "-2");
  } else if (what == question::rename) {
    question_words_->setText(tr("New name of %1").arg(about_));
    yes_->setText(tr("Rename"));
    name_->setText(about_);
  } else {
    question_words_->setText(
      tr("Delete %1 with all its versions? It cannot be brought back.").arg(about_));
    yes_->setText(tr("Delete for good"));
    return;
  }
  name_->setFocus();
  name_->selectAll();
}

/// Names of several words are what people type, and no server takes a blank.
void documents_dialog::answer() {
  const auto name = name_->text().simplified().replace(' ', '-');
  if (waiting_ || asked_ == question::none)
    return;
  if (asked_ != question::remove && (name.isEmpty() || name == about_))
    return ask(question::none);
  words_->clear();
  waiting_ = true;
  refresh_buttons();
  if (asked_ == question::copy)
    emit copy_wanted(about_, name);
  else if (asked_ == question::rename)
    emit rename_wanted(about_, name);
  else
    emit delete_wanted(about_);
}

/// A rule of the style for a property is looked up when a widget is polished.
void documents_dialog::say(const char* role, const QString& words) {
  words_->setProperty("role", role);
  words_->style()->unpolish(words_);
  words_->style()->polish(words_);
  words_->setText(words);
}

void documents_dialog::settle(const QString& words) {
  waiting_ = false;
  ask(question::none);
  say("faint", words);
  refresh_buttons();
  list_->setFocus();
}

/// A name that was refused stays to be changed.
void documents_dialog::refuse(const error& why) {
  waiting_ = false;
  say("fault", one_line({why.code, why.message, why.remedy, {}}));
  refresh_buttons();
}

/// Esc leaves a question first.
void documents_dialog::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && asked_ != question::none && !waiting_)
    return ask(question::none);
  if (event->key() == Qt::Key_Delete && list_->hasFocus() && !chosen().isEmpty() && !waiting_)
    return ask(question::remove);
  QDialog::keyPressEvent(event);
}

}  // namespace tedit::desktop
