// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/results_summary/results_summary_panel.hpp"

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QShortcut>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

#include "client-qt/model/results_table.hpp"

namespace tedit::desktop {

namespace {

enum column { title_column, value_column, before_column, change_column, where_column, note_column };
enum role { section_role = Qt::UserRole, row_role };

constexpr int enough_where = 260;  // Pixels: beside a long note what is longer is read in its hint.
constexpr int least_where = 120;
constexpr int least_margin = 4;  // Below the list.

QString notes_of(const result_row& row) {
  if (row.warning.isEmpty())
    return row.note;
  const QString warning = QString::fromUtf8("⚠ ") + row.warning;
  return row.note.isEmpty() ? warning : warning + " (" + row.note + ")";
}

bool has_notes(const results_summary& what) {
  return std::ranges::any_of(what.sections, [](const result_section& one) {
    return std::ranges::any_of(one.rows,
                               [](const result_row& row) { return !notes_of(row).isEmpty(); });
  });
}

/// A place has the room of its note, too, where there is none. Each of both cells paints its half:
/// a list may paint one of them alone.
class place_delegate : public QStyledItemDelegate {
public:
  explicit place_delegate(QTreeWidget& list) : QStyledItemDelegate(&list), list_(list) {}

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    const auto note = index.siblingAtColumn(note_column);
    if (!note.data().toString().isEmpty())
      return QStyledItemDelegate::paint(painter, option, index);
    const auto place = index.siblingAtColumn(where_column);
    auto both = option;
    both.rect = list_.visualRect(place) | list_.visualRect(note);
    painter->save();
    painter->setClipRect(option.rect, Qt::IntersectClip);
    QStyledItemDelegate::paint(painter, both, place);
    painter->restore();
  }

private:
  const QTreeWidget& list_;
};

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
  column->setContentsMargins(8, 4, 8, least_margin);
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
  tree_->setVerticalScrollMode(QAbstractItemView::ScrollPerItem);  // Rows stay whole.
  tree_->header()->setStretchLastSection(false);  // `share_width` gives each its room.
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
  tree_->viewport()->installEventFilter(this);
  for (const int i : {where_column, note_column})
    tree_->setItemDelegateForColumn(i, new place_delegate(*tree_));
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
  for (const int i : {title_column, value_column, before_column, change_column})
    tree_->resizeColumnToContents(i);
  share_width();
  fit_rows();
  for (QTreeWidgetItemIterator it(tree_); *it; ++it)  // Who reads by keys stays where they were.
    if (std::pair((*it)->data(0, section_role).toInt(), (*it)->data(0, row_role).toInt()) == at)
      tree_->setCurrentItem(*it);
}

/// Places and notes share what the figures leave: neither is cut off beside empty room, nor to
/// nothing for the other.
void results_summary_panel::share_width() {
  int left = tree_->viewport()->width();
  for (const int i : {title_column, value_column, before_column, change_column})
    left -= tree_->columnWidth(i);  // 0 where it is hidden.
  const QAbstractItemView& list = *tree_;
  const int heading = tree_->header()->sectionSizeHint(note_column);
  const int note = std::max(list.sizeHintForColumn(note_column), heading);
  const int where =
    std::max(list.sizeHintForColumn(where_column), tree_->header()->sectionSizeHint(where_column));
  const int enough = std::clamp(std::min(left - heading, left / 2), std::min(where, least_where),
                                std::min(where, enough_where));
  const bool notes = !tree_->isColumnHidden(note_column);
  const int given = notes ? std::clamp(left - note, enough, where) : std::max(left, where);
  tree_->setColumnWidth(where_column, given);
  tree_->setColumnWidth(note_column, std::max(left - given, std::min(heading, least_where)));
}

/// The list ends with a whole row; what is left over stays empty below it.
void results_summary_panel::fit_rows() {
  const auto* first = tree_->topLevelItem(0);
  const int row = first ? tree_->visualItemRect(first).height() : 0;
  if (row <= 0)
    return;
  auto margins = layout()->contentsMargins();
  // Of the panel: what the list has may be on its way yet.
  const int heading = tree_->height() - tree_->viewport()->height();
  const int room = height() - least_margin - tree_->y() - heading;
  margins.setBottom(least_margin + (room > row ? room % row : 0));
  layout()->setContentsMargins(margins);
}

bool results_summary_panel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == tree_->viewport() && event->type() == QEvent::Resize)
    QTimer::singleShot(0, this, [this] {  // Once the header has it.
      share_width();
      fit_rows();
    });
  // How high a row is the list knows for sure once it is drawn.
  if (watched == tree_->viewport() && event->type() == QEvent::Paint)
    QTimer::singleShot(0, this, &results_summary_panel::fit_rows);
  return QWidget::eventFilter(watched, event);
}

void results_summary_panel::set_columns() {
  const QString before = shown_.before ? tr("Version %1").arg(*shown_.before) : QString();
  tree_->setHeaderLabels(
    {tr("Figure"), tr("Value"), before, tr("Change"), tr("Where"), tr("Note")});
  for (const int i : {value_column, before_column, change_column})
    tree_->headerItem()->setTextAlignment(i, Qt::AlignRight | Qt::AlignVCenter);  // As below.
  tree_->setColumnHidden(before_column, !shown_.before);
  tree_->setColumnHidden(change_column, !shown_.before);
  tree_->setColumnHidden(note_column, !has_notes(shown_));
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
