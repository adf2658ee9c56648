// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/help/shortcuts_dialog.hpp"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace tedit::desktop {

shortcuts_dialog::shortcuts_dialog(shortcut_table table, QWidget* parent)
    : QDialog(parent), table_(table) {
  setWindowTitle(tr("Keyboard shortcuts"));
  resize(560, 620);
  auto* column = new QVBoxLayout(this);
  auto* letters = new QLineEdit;
  letters->setObjectName("search");
  letters->setPlaceholderText(tr("Search commands and keys"));
  letters->setAccessibleName(letters->placeholderText());
  letters->setClearButtonEnabled(true);
  connect(letters, &QLineEdit::textChanged, this, &shortcuts_dialog::search);
  column->addWidget(letters);
  list_ = new QTreeWidget;
  list_->setHeaderLabels({tr("Command"), tr("Keys")});
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  list_->setAccessibleName(tr("Commands and their keys"));
  connect(list_, &QTreeWidget::currentItemChanged, this, &shortcuts_dialog::show_current);
  column->addWidget(list_, 1);

  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("New keys")));
  keys_ = new QKeySequenceEdit;
  keys_->setObjectName("keys");
  connect(keys_, &QKeySequenceEdit::editingFinished, this,
          [this] { assign(keys_->keySequence()); });
  row->addWidget(keys_, 1);
  auto* none = new QPushButton(tr("None"));
  none->setToolTip(tr("The command has no keys any more"));
  connect(none, &QPushButton::clicked, this, [this] { assign({}); });
  row->addWidget(none);
  reset_ = new QPushButton(tr("Reset"));
  reset_->setObjectName("reset");
  reset_->setToolTip(tr("The keys that the command came with"));
  connect(reset_, &QPushButton::clicked, this, [this] {
    if (const auto* what = current())
      assign(QKeySequence(what->shortcut));
  });
  row->addWidget(reset_);
  column->addLayout(row);
  conflict_ = new QLabel;
  conflict_->setObjectName("conflict");
  conflict_->setProperty("role", "fault");
  conflict_->setWordWrap(true);
  column->addWidget(conflict_);

  auto* buttons = new QHBoxLayout;
  auto* copy = new QPushButton(tr("Copy as text"));
  copy->setObjectName("copy");
  connect(copy, &QPushButton::clicked, this,
          [this] { QApplication::clipboard()->setText(table_.as_text()); });
  auto* all = new QPushButton(tr("Reset all"));
  connect(all, &QPushButton::clicked, this, [this] {
    table_.reset_all();
    fill();
    emit changed();
  });
  auto* close = new QPushButton(tr("Close"));
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  buttons->addWidget(copy);
  buttons->addWidget(all);
  buttons->addStretch();
  buttons->addWidget(close);
  column->addLayout(buttons);
  // Enter ends typing of keys; it must not press a button.
  for (auto* button : findChildren<QPushButton*>())
    button->setAutoDefault(false);
  fill();
}

void shortcuts_dialog::fill() {
  const auto* before = current();
  const QString chosen = before ? before->id : QString();
  list_->clear();
  QStringList groups;
  QTreeWidgetItem* group = nullptr;
  for (const auto& one : table_.all().all()) {
    if (const auto at = groups.indexOf(one.group); at >= 0) {
      group = list_->topLevelItem(static_cast<int>(at));
    } else {
      groups << one.group;
      group = new QTreeWidgetItem(list_, {one.group});
      group->setFlags(Qt::ItemIsEnabled);
      group->setExpanded(true);
    }
    const QString keys = table_.keys(one);
    auto* row = new QTreeWidgetItem(
      group, {one.title, QKeySequence(keys).toString(QKeySequence::NativeText)});
    row->setData(0, Qt::UserRole, one.id);
    row->setToolTip(0, one.help);
    auto font = row->font(1);
    font.setBold(keys != one.shortcut);  // A person's own.
    row->setFont(1, font);
    if (one.id == chosen)
      list_->setCurrentItem(row);
  }
  show_current();
}

const command* shortcuts_dialog::current() const {
  const auto* row = list_->currentItem();
  return row ? table_.all().find(row->data(0, Qt::UserRole).toString()) : nullptr;
}

void shortcuts_dialog::show_current() {
  const auto* what = current();
  keys_->setEnabled(what != nullptr);
  keys_->setKeySequence(what ? QKeySequence(table_.keys(*what)) : QKeySequence());
  reset_->setEnabled(what && table_.keys(*what) != what->shortcut);
  conflict_->clear();
}

void shortcuts_dialog::assign(const QKeySequence& keys) {
  const auto* what = current();
  if (!what)
    return;
  const QString text = keys.toString();
  const auto others = table_.others_with(text, what->id);
  if (!others.empty()) {
    conflict_->setText(tr("%1 belongs to \"%2\" already. Give that one other keys first.")
                         .arg(keys.toString(QKeySequence::NativeText), others.front()->title));
    return;
  }
  conflict_->clear();
  if (text == table_.keys(*what))
    return;
  table_.set(*what, text);
  fill();
  emit changed();
}

void shortcuts_dialog::search(const QString& letters) {
  for (int g = 0; g < list_->topLevelItemCount(); ++g) {
    auto* group = list_->topLevelItem(g);
    bool any = false;
    for (int i = 0; i < group->childCount(); ++i) {
      auto* row = group->child(i);
      const bool fits = row->text(0).contains(letters, Qt::CaseInsensitive) ||
                        row->text(1).contains(letters, Qt::CaseInsensitive);
      row->setHidden(!fits);
      any = any || fits;
    }
    group->setHidden(!any);
  }
}

}  // namespace tedit::desktop
