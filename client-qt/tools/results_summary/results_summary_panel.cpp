// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/results_summary/results_summary_panel.hpp"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QShortcut>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "client-qt/model/results_table.hpp"

namespace tedit::desktop {

namespace {

enum column { title_column, value_column, before_column, change_column, where_column, note_column };
enum role { section_role = Qt::UserRole, row_role };

constexpr int widest_where = 260;  // Pixels: what is longer is read in its hint.

QString notes_of(const result_row& row) {
  if (row.warning.isEmpty())
    return row.note;
  const QString warning = QString::fromUtf8("⚠ ") + row.warning;
  return row.note.isEmpty() ? warning : warning + " (" + row.note + ")";
}

/// What a screen reader says of a row.
QString spoken(const QTreeWidgetItem& row) {
  QStringList parts;
  for (int i = 0; i < row.columnCount(); ++i)
    if (!row.text(i).isEmpty())
      parts << row.text(i);
  return parts.join(", ");
}

}  // namespace

results_summary_panel::results_summary_panel(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 4, 8, 4);
  column->setSpacing(2);
  build_top();
  missing_ = new QLabel;
  missing_->setObjectName("results_missing");
  missing_->setWordWrap(true);
  missing_->setProperty("role", "faint");
  missing_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  column->addWidget(missing_, 1);
  tree_ = new QTreeWidget;
  tree_->setObjectName("results_list");
  tree_->setAccessibleName(tr("Results"));
  tree_->setRootIsDecorated(false);
  tree_->setIndentation(12);
  tree_->setSelectionBehavior(QAbstractItemView::SelectRows);
  tree_->setAllColumnsShowFocus(true);
  tree_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  column->addWidget(tree_, 1);
  wire();
  show_summary({});
}

void results_summary_panel::build_top() {
  auto* row = new QHBoxLayout;
  state_ = new QLabel;
  state_->setObjectName("results_state");
  state_->setProperty("role", "section");
  row->addWidget(state_, 1);
  const auto add = [&](const QString& text, const char* name, const QString& help) {
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    button->setProperty("role", "link");
    button->setToolTip(help);
    row->addWidget(button);
    return button;
  };
  copy_ = add(tr("Copy as table"), "results_copy", tr("For a spreadsheet or a text (Ctrl+C)"));
  report_ = add(tr("Report"), "results_report",
                tr("Pictures, loads, figures and what to trust, as "
                   "PDF or HTML"));
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void results_summary_panel::wire() {
  connect(copy_, &QPushButton::clicked, this, &results_summary_panel::copy);
  connect(report_, &QPushButton::clicked, this, &results_summary_panel::report_wanted);
  connect(tree_, &QTreeWidget::itemActivated, this, &results_summary_panel::go_to);
  connect(tree_, &QTreeWidget::itemClicked, this, &results_summary_panel::go_to);
  auto* keys = new QShortcut(QKeySequence::Copy, tree_);
  keys->setContext(Qt::WidgetShortcut);
  connect(keys, &QShortcut::activated, this, &results_summary_panel::copy);
}

void results_summary_panel::set_warning_ink(const QColor& ink) {
  warning_ink_ = ink;
  show_summary(shown_);
}

void results_summary_panel::show_summary(const results_summary& what) {
  const auto* current = tree_->currentItem();
  const auto at =
    current ? std::pair(current->data(0, section_role).toInt(), current->data(0, row_role).toInt())
            : std::pair(-1, -1);
  shown_ = what;
  const bool has_rows = !shown_.sections.empty();
  state_->setText(shown_.state);
  missing_->setText(shown_.missing);
  missing_->setVisible(!has_rows);
  tree_->setVisible(has_rows);
  copy_->setEnabled(has_rows);
  tree_->clear();
  set_columns();
  for (std::size_t i = 0; i < shown_.sections.size(); ++i)
    add_section(i);
  for (const int i : {title_column, value_column, before_column, change_column, where_column})
    tree_->resizeColumnToContents(i);
  tree_->setColumnWidth(where_column, std::min(tree_->columnWidth(where_column), widest_where));
  for (QTreeWidgetItemIterator it(tree_); *it; ++it)  // Who reads by keys stays where they were.
    if (std::pair((*it)->data(0, section_role).toInt(), (*it)->data(0, row_role).toInt()) == at)
      tree_->setCurrentItem(*it);
}

void results_summary_panel::set_columns() {
  const QString before = shown_.before ? tr("Version %1").arg(*shown_.before) : QString();
  tree_->setHeaderLabels(
    {tr("Figure"), tr("Value"), before, tr("Change"), tr("Where"), tr("Note")});
  tree_->setColumnHidden(before_column, !shown_.before);
  tree_->setColumnHidden(change_column, !shown_.before);
  tree_->header()->setStretchLastSection(true);
}

void results_summary_panel::add_section(std::size_t at) {
  const auto& section = shown_.sections[at];
  auto* top = new QTreeWidgetItem(tree_, {section.title});
  top->setFirstColumnSpanned(true);
  top->setData(0, section_role, static_cast<int>(at));
  top->setData(0, row_role, -1);
  auto bold = tree_->font();
  bold.setBold(true);
  top->setFont(0, bold);
  for (std::size_t i = 0; i < section.rows.size(); ++i)
    add_row(top, at, i);
  for (const auto& hint : section.hints) {
    auto* row = new QTreeWidgetItem(top, {hint});
    row->setFirstColumnSpanned(true);
    row->setToolTip(0, hint);
    row->setForeground(0, tree_->palette().color(QPalette::Disabled, QPalette::Text));
    row->setData(0, row_role, -1);
  }
  top->setExpanded(true);
}

void results_summary_panel::add_row(QTreeWidgetItem* parent, std::size_t section, std::size_t at) {
  const auto& row = shown_.sections[section].rows[at];
  const QString unknown = row.compares ? "-" : "";
  auto* item = new QTreeWidgetItem(
    parent, {row.title, row.value.text(), row.before ? row.before->text() : unknown,
             row.before ? row.change : unknown, row.where, notes_of(row)});
  item->setData(0, section_role, static_cast<int>(section));
  item->setData(0, row_role, static_cast<int>(at));
  for (const int i : {value_column, before_column, change_column})
    item->setTextAlignment(i, Qt::AlignRight | Qt::AlignVCenter);
  item->setToolTip(where_column, row.where);
  item->setToolTip(note_column, notes_of(row));
  item->setData(0, Qt::AccessibleTextRole, spoken(*item));
  if (!row.warning.isEmpty() && warning_ink_.isValid())
    item->setForeground(note_column, warning_ink_);
  if (row.compares && !row.before)
    item->setToolTip(before_column, tr("Not known: that version was not solved with these loads "
                                       "since the document was opened"));
}

void results_summary_panel::go_to(const QTreeWidgetItem* item) {
  const auto section = item->data(0, section_role).toInt();
  const auto at = item->data(0, row_role).toInt();
  if (at < 0 || section < 0 || section >= static_cast<int>(shown_.sections.size()))
    return;
  const auto& of = shown_.sections[static_cast<std::size_t>(section)];
  if (at >= static_cast<int>(of.rows.size()))
    return;
  const auto row = of.rows[static_cast<std::size_t>(at)];  // What is done may show others.
  if (row.at || !row.surfaces.empty())
    emit row_wanted(row, QString::fromStdString(of.load_case));
}

QMimeData* results_summary_panel::table() const {
  auto* result = new QMimeData;
  result->setText(as_text_table(shown_));
  result->setHtml(as_html_table(shown_));
  return result;
}

void results_summary_panel::copy() const {
  if (!shown_.sections.empty())
    QApplication::clipboard()->setMimeData(table());
}

}  // namespace tedit::desktop
