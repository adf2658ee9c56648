// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/jobs_panel.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

constexpr int tick_ms = 500;
constexpr int panel_width = 340;

void clear(QLayout* layout) {
  while (auto* item = layout->takeAt(0)) {
    if (item->widget())
      item->widget()->deleteLater();
    else if (item->layout())
      clear(item->layout());
    delete item;
  }
}

/// Whole seconds: what changes more often cannot be read.
QString for_how_long(double ms) {
  return duration(ms < 1000 ? 0 : 1000.0 * static_cast<double>(static_cast<long long>(ms / 1000)));
}

}  // namespace

jobs_panel::jobs_panel(jobs& work, remote& link, QWidget* parent)
    : QFrame(parent, Qt::Popup), work_(work), link_(link) {
  setAttribute(Qt::WA_DeleteOnClose);
  setObjectName("jobs_panel");
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setFixedWidth(panel_width);
  column_ = new QVBoxLayout(this);
  column_->setSizeConstraint(QLayout::SetMinAndMaxSize);
  connect(&work_, &jobs::changed, this, &jobs_panel::refresh);
  connect(&link_, &remote::state_changed, this, &jobs_panel::refresh);
  auto* clock = new QTimer(this);
  connect(clock, &QTimer::timeout, this, &jobs_panel::refresh);
  clock->start(tick_ms);
  refresh();
}

QLabel* jobs_panel::add_line(const QString& text, const char* role) {
  auto* line = new QLabel(text);
  line->setProperty("role", role);
  line->setWordWrap(true);
  column_->addWidget(line);
  return line;
}

void jobs_panel::add_job(const job& one) {
  auto* row = new QHBoxLayout;
  auto* title = new QLabel(one.title);
  title->setProperty("role", "section");
  row->addWidget(title, 1);
  if (one.cancel) {
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setObjectName("job_cancel");
    connect(cancel, &QPushButton::clicked, &work_, [this, id = one.id] { work_.cancel(id); });
    row->addWidget(cancel);
  }
  column_->addLayout(row);
  if (one.fraction > 0) {
    auto* bar = new QProgressBar;
    bar->setRange(0, 1000);
    bar->setTextVisible(false);
    bar->setValue(qRound(1000 * one.fraction));
    column_->addWidget(bar);
  }
  QStringList facts{tr("for %1").arg(for_how_long(one.elapsed_ms()))};
  if (!one.stage.isEmpty())
    facts.prepend(one.stage);
  if (const QString rest = roughly(one.remaining()); !rest.isEmpty())
    facts << rest;
  add_line(facts.join(QString::fromUtf8("  \u00b7  ")), "faint");
}

/// As the server said it last, every three seconds.
void jobs_panel::add_workers() {
  add_line(tr("Server"), "section");
  if (link_.current() != remote::state::connected) {
    add_line(tr("not connected"), "faint");
    return;
  }
  for (const auto& worker : link_.server().workers) {
    QString text = QString("%1: %2").arg(QString::fromStdString(worker.role),
                                         QString::fromStdString(worker.state));
    if (worker.jobs > 0)
      text += tr(", running and waiting: %1").arg(worker.jobs);
    if (worker.restarts > 0)
      text += tr(", started again: %1").arg(worker.restarts);
    if (!worker.detail.empty())
      text += ", " + QString::fromStdString(worker.detail);
    add_line(text, "faint");
  }
  add_line(tr("open documents: %1, connections: %2")
             .arg(link_.server().documents)
             .arg(link_.server().connections),
           "faint");
}

void jobs_panel::refresh() {
  clear(column_);
  if (work_.all().empty())
    add_line(tr("Nothing runs."), "section");
  for (const auto& one : work_.all())
    add_job(one);
  add_workers();
}

QString jobs_panel::text() const {
  QStringList lines;
  for (int i = 0; i < column_->count(); ++i) {
    auto* item = column_->itemAt(i);
    auto* inner = item->layout() ? item->layout()->itemAt(0)->widget() : item->widget();
    if (const auto* label = qobject_cast<QLabel*>(inner))
      lines << label->text();
  }
  return lines.join("\n");
}

// -- the button ----------------------------------------------------------------------

jobs_button::jobs_button(jobs& work, remote& link, QWidget* parent)
    : QToolButton(parent), work_(work), link_(link) {
  setObjectName("jobs");
  setAutoRaise(true);
  setStyleSheet("padding: 0 8px; margin: 0; border: 0;");  // As high as the words beside it.
  setToolTip(tr("What runs, and how the server is"));
  clock_.setInterval(tick_ms);
  connect(&clock_, &QTimer::timeout, this, &jobs_button::refresh);
  connect(&work_, &jobs::changed, this, &jobs_button::refresh);
  connect(this, &QToolButton::clicked, this, &jobs_button::open_panel);
  refresh();
}

void jobs_button::refresh() {
  const auto& all = work_.all();
  if (all.empty()) {
    clock_.stop();
    setText(tr("idle"));
    return;
  }
  if (!clock_.isActive())
    clock_.start();
  QString text = all.back().title;
  if (all.back().elapsed_ms() >= 1000)
    text += "  " + for_how_long(all.back().elapsed_ms());
  if (all.size() > 1)
    text += tr("  (%1 run)").arg(all.size());
  setText(text);
}

void jobs_button::open_panel() {
  auto* panel = new jobs_panel(work_, link_, this);
  panel->adjustSize();
  panel->move(mapToGlobal(QPoint(width() - panel->width(), -panel->height() - 4)));
  panel->show();
}

}  // namespace tedit::desktop
