// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/certify/certificate_dialog.hpp"

#include <QClipboard>
#include <QDesktopServices>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace tedit::desktop {

namespace {

QString share(double value) {
  return QString::number(value, 'g', 2);
}

table_cell number_cell(const QString& words, double value) {
  return {words, value};
}

QLabel* paragraph(const QString& words, const char* role = nullptr) {
  auto* label = new QLabel(words);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  if (role)
    label->setProperty("role", role);
  return label;
}

}  // namespace

QString verdict_of(const certificate& what) {
  const auto wrong = std::ranges::count(what.cases, false, &certified_case::agrees);
  const auto all = static_cast<int>(what.cases.size());
  if (wrong > 0)
    return certificate_dialog::tr("%1 differs on %2 of %3 load cases of version %4.")
      .arg(what.program)
      .arg(wrong)
      .arg(all)
      .arg(what.version);
  return all == 1 ? certificate_dialog::tr("%1 agrees on the load case of version %2.")
                      .arg(what.program)
                      .arg(what.version)
                  : certificate_dialog::tr("%1 agrees on all %2 load cases of version %3.")
                      .arg(what.program)
                      .arg(all)
                      .arg(what.version);
}

word_table table_of(const certificate& what) {
  word_table table{
    certificate_dialog::tr("Differences"),
    {certificate_dialog::tr("Load case"), certificate_dialog::tr("Verdict"),
     certificate_dialog::tr("Displacement"), certificate_dialog::tr("Reactions"),
     certificate_dialog::tr("Compliance"), certificate_dialog::tr("Stress"),
     certificate_dialog::tr("Largest, MPa"), certificate_dialog::tr("CalculiX, MPa")},
    {}};
  for (const auto& c : what.cases) {
    const double ours = 1e-6 * c.our_stress_pa;
    const double theirs = 1e-6 * c.their_stress_pa;
    table.rows.push_back(
      {{c.name, {}},
       {c.agrees ? certificate_dialog::tr("agrees") : certificate_dialog::tr("differs"), {}},
       number_cell(share(c.displacement), c.displacement),
       number_cell(share(c.reaction), c.reaction),
       number_cell(share(c.compliance), c.compliance),
       number_cell(share(c.stress), c.stress),
       number_cell(QString::number(ours, 'g', 4), ours),
       number_cell(QString::number(theirs, 'g', 4), theirs)});
  }
  return table;
}

certificate_dialog::certificate_dialog(const certificate& what, QWidget* parent)
    : QDialog(parent), what_(what) {
  setAttribute(Qt::WA_DeleteOnClose);
  setObjectName("certificate");
  setWindowTitle(tr("Checked with CalculiX"));
  setMinimumWidth(760);
  auto* column = new QVBoxLayout(this);
  auto* verdict = paragraph(verdict_of(what_), "section");
  verdict->setObjectName("certificate_verdict");
  column->addWidget(verdict);
  column->addWidget(make_table());
  column->addWidget(paragraph(
    tr("Both programs solved the same deck. Differences are relative to the largest displacement, "
       "the sum of reactions and the largest stress. Stress at nodes is a mean of the elements "
       "around: it is compared with the same mean; as each program shows it, half of the nodes "
       "differ by less than %1 %.")
      .arg(share(what_.cases.empty() ? 0 : 100 * what_.cases.front().shown_stress)),
    "faint"));
  column->addWidget(paragraph(tr("Decks and results: %1").arg(what_.folder), "faint"));
  column->addWidget(make_buttons());
}

QWidget* certificate_dialog::make_table() const {
  const auto table = table_of(what_);
  auto* list = new QTreeWidget;
  list->setObjectName("certificate_cases");
  list->setAccessibleName(table.title);
  list->setRootIsDecorated(false);
  list->setHeaderLabels(table.columns);
  for (const auto& cells : table.rows) {
    auto* row = new QTreeWidgetItem(list);
    for (int i = 0; i < static_cast<int>(cells.size()); ++i) {
      const auto& cell = cells[static_cast<std::size_t>(i)];
      row->setText(i, cell.words);
      if (cell.order.isValid()) {
        row->setTextAlignment(i, Qt::AlignRight | Qt::AlignVCenter);
        list->headerItem()->setTextAlignment(i, Qt::AlignRight | Qt::AlignVCenter);
      }
    }
  }
  list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list->header()->setStretchLastSection(false);
  // As high as its rows, as far as that goes.
  constexpr int most_rows = 10;
  const int rows = std::clamp(list->topLevelItemCount(), 1, most_rows);
  const int row = std::max(list->sizeHintForRow(0), list->fontMetrics().height() + 6);
  list->setFixedHeight(list->header()->sizeHint().height() + rows * row + row / 2);
  return list;
}

QWidget* certificate_dialog::make_buttons() {
  auto* buttons = new QWidget;
  auto* row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 0, 0);
  auto* open = new QPushButton(tr("Open the folder"));
  connect(open, &QPushButton::clicked, this,
          [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(what_.folder)); });
  auto* copy = new QPushButton(tr("Copy as text"));
  connect(copy, &QPushButton::clicked, this, [this] {
    QGuiApplication::clipboard()->setText(as_text({verdict_of(what_)}, {table_of(what_)}));
  });
  auto* close = new QPushButton(tr("Close"));
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  row->addWidget(open);
  row->addWidget(copy);
  row->addStretch();
  row->addWidget(close);
  close->setDefault(true);
  return buttons;
}

}  // namespace tedit::desktop
