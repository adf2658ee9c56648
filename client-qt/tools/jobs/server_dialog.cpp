// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/jobs/server_dialog.hpp"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

/// Numbers are in the order of their size, whatever their words are.
class ordered_row : public QTreeWidgetItem {
public:
  using QTreeWidgetItem::QTreeWidgetItem;

  bool operator<(const QTreeWidgetItem& other) const override {
    const int column = treeWidget() ? treeWidget()->sortColumn() : 0;
    const auto mine = data(column, Qt::UserRole);
    const auto its = other.data(column, Qt::UserRole);
    if (mine.isValid() && its.isValid())
      return mine.toDouble() < its.toDouble();
    return text(column).localeAwareCompare(other.text(column)) < 0;
  }
};

QTreeWidgetItem* make_row(const std::vector<table_cell>& cells) {
  auto* row = new ordered_row;
  for (int i = 0; i < static_cast<int>(cells.size()); ++i) {
    const auto& cell = cells[static_cast<std::size_t>(i)];
    row->setText(i, cell.words);
    row->setData(i, Qt::UserRole, cell.order);
    if (cell.order.isValid())
      row->setTextAlignment(i, Qt::AlignRight | Qt::AlignVCenter);
  }
  return row;
}

/// As high as its rows, as far as that goes.
void fit_height(QTreeWidget& list) {
  constexpr int most_rows = 8;
  const int rows = std::clamp(list.topLevelItemCount(), 1, most_rows);
  const int row = std::max(list.sizeHintForRow(0), list.fontMetrics().height() + 6);
  const int bar = list.horizontalScrollBar()->sizeHint().height();
  list.setFixedHeight(list.header()->sizeHint().height() + rows * row + bar +
                      2 * list.frameWidth());
}

}  // namespace

server_dialog::server_dialog(remote& link, QWidget* parent)
    : QDialog(parent), link_(link), facts_(new QLabel), no_nodes_(new QLabel) {
  setWindowTitle(tr("Server and workers"));
  resize(1000, 520);
  auto* column = new QVBoxLayout(this);
  facts_->setObjectName("server_facts");
  facts_->setTextFormat(Qt::PlainText);
  facts_->setWordWrap(true);
  facts_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(facts_);
  workers_ = add_table("server_workers", worker_table({}));
  nodes_ = add_table("server_nodes", node_table({}));
  no_nodes_->setObjectName("server_no_nodes");
  no_nodes_->setProperty("role", "faint");
  no_nodes_->setWordWrap(true);
  no_nodes_->setText(
    tr("All work is done on the server's own machine. How workers on others join "
       "it stands in the manual, \"Workers on other machines\"."));
  column->addWidget(no_nodes_);
  memory_ = add_table("server_memory", memory_table({}));
  column->addStretch();
  column->addWidget(make_buttons());
  connect(&link_, &remote::state_changed, this, &server_dialog::refresh);
  refresh();
}

QTreeWidget* server_dialog::add_table(const char* name, const word_table& empty) {
  auto* column = static_cast<QVBoxLayout*>(layout());
  auto* title = new QLabel(empty.title);
  title->setProperty("role", "section");
  column->addWidget(title);
  auto* list = new QTreeWidget;
  list->setObjectName(name);
  list->setAccessibleName(empty.title);
  list->setRootIsDecorated(false);
  list->setUniformRowHeights(true);
  list->setHeaderLabels(empty.columns);
  list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list->header()->setStretchLastSection(false);
  list->setSortingEnabled(true);
  list->header()->setSortIndicator(-1, Qt::AscendingOrder);  // As the server has them.
  column->addWidget(list);
  return list;
}

QWidget* server_dialog::make_buttons() {
  auto* buttons = new QWidget;
  auto* row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 0, 0);
  auto* copy = new QPushButton(tr("Copy as text"));
  copy->setObjectName("server_copy");
  copy->setToolTip(tr("All that stands here, for a mail or a spreadsheet"));
  connect(copy, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(text()); });
  auto* close = new QPushButton(tr("Close"));
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  row->addWidget(copy);
  row->addStretch();
  row->addWidget(close);
  close->setFocus();
  return buttons;
}

QStringList server_dialog::facts() const {
  if (link_.current() != remote::state::connected)
    return {tr("There is no connection to a server. It is started when a part is opened.")};
  const auto& server = link_.server();
  QStringList lines{tr("%1 at %2").arg(link_.program().simplified(), link_.address().url)};
  if (link_.latency_ms() >= 0)
    lines << tr("Answers in %1").arg(duration(link_.latency_ms()));
  lines << tr("Open documents: %1, connections: %2").arg(server.documents).arg(server.connections);
  return lines;
}

/// A person's choice, order and place in the list stay.
void server_dialog::fill(QTreeWidget& list, const word_table& now) {
  const int chosen = list.indexOfTopLevelItem(list.currentItem());
  const QString name = chosen >= 0 ? list.currentItem()->text(0) : QString();
  const int scrolled = list.verticalScrollBar()->value();
  const int column = list.sortColumn();
  const auto order = list.header()->sortIndicatorOrder();
  list.setSortingEnabled(false);
  list.clear();
  for (const auto& cells : now.rows)
    list.addTopLevelItem(make_row(cells));
  for (int i = 0; i < list.columnCount() && !now.rows.empty(); ++i)
    if (now.rows.front()[static_cast<std::size_t>(i)].order.isValid())
      list.headerItem()->setTextAlignment(i, Qt::AlignRight | Qt::AlignVCenter);
  list.setSortingEnabled(true);
  list.header()->setSortIndicator(column, order);
  if (auto* row = list.topLevelItem(chosen); row && row->text(0) == name)
    list.setCurrentItem(row);
  list.verticalScrollBar()->setValue(scrolled);
  fit_height(list);
}

void server_dialog::refresh() {
  const bool serves = link_.current() == remote::state::connected;
  const auto server = serves ? link_.server() : client::server_status{};
  facts_->setText(facts().join('\n'));
  fill(*memory_, memory_table(server));
  fill(*workers_, worker_table(server));
  fill(*nodes_, node_table(server));
  nodes_->setVisible(!server.nodes.empty());
  no_nodes_->setVisible(serves && server.nodes.empty());
}

QString server_dialog::text() const {
  const bool serves = link_.current() == remote::state::connected;
  const auto server = serves ? link_.server() : client::server_status{};
  return as_text(facts(), {worker_table(server), node_table(server), memory_table(server)});
}

}  // namespace tedit::desktop
