// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/jobs/jobs_panel.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

#include "client-qt/model/quantities.hpp"
#include "client-qt/model/server_tables.hpp"
#include "client-qt/model/solve_requests.hpp"

namespace tedit::desktop {

namespace {

constexpr int tick_ms = 500;
constexpr int panel_width = 340;

QLabel* make_line(const QString& text, const char* role) {
  auto* line = new QLabel(text);
  line->setProperty("role", role);
  line->setWordWrap(true);
  return line;
}

/// Whole seconds: what changes more often cannot be read.
QString for_how_long(double ms) {
  const auto seconds = static_cast<long long>(ms / 1000);
  return seconds < 60 ? QString("%1 s").arg(seconds)
                      : QString("%1 min %2 s").arg(seconds / 60).arg(seconds % 60);
}

}  // namespace

QString nothing_words(const client::server_status& server, const QString& left) {
  if (!left.isEmpty() && is_solving(server))
    return jobs_panel::tr("The server still solves %1, which was open here before.").arg(left);
  const bool works =
    std::ranges::any_of(server.workers, [](const auto& worker) { return worker.jobs > 0; });
  return works ? jobs_panel::tr("Nothing of yours runs.") : jobs_panel::tr("Nothing runs.");
}

jobs_panel::jobs_panel(jobs& work, remote& link, QWidget* parent)
    : QFrame(parent, Qt::Popup), work_(work), link_(link) {
  setAttribute(Qt::WA_DeleteOnClose);
  setObjectName("jobs_panel");
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setFixedWidth(panel_width);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 10);
  nothing_ = make_line({}, "section");
  nothing_->setObjectName("nothing_runs");
  column->addWidget(nothing_);
  list_ = new QVBoxLayout;
  column->addLayout(list_);
  column->addWidget(make_line(tr("Server"), "section"));
  server_ = make_line({}, "faint");
  column->addWidget(server_);
  connect(&work_, &jobs::changed, this, &jobs_panel::refresh);
  connect(&link_, &remote::state_changed, this, &jobs_panel::refresh);
  auto* clock = new QTimer(this);
  connect(clock, &QTimer::timeout, this, &jobs_panel::refresh);
  clock->start(tick_ms);
  refresh();
}

jobs_panel::row jobs_panel::make_row(const job& one) {
  row made;
  made.box = new QWidget;
  auto* column = new QVBoxLayout(made.box);
  column->setContentsMargins(0, 0, 0, 4);
  auto* top = new QHBoxLayout;
  top->addWidget(make_line(one.title, "section"), 1);
  made.cancel = new QPushButton(tr("Cancel"));
  made.cancel->setObjectName("job_cancel");
  connect(made.cancel, &QPushButton::clicked, &work_, [this, id = one.id] { work_.cancel(id); });
  top->addWidget(made.cancel);
  column->addLayout(top);
  made.bar = new QProgressBar;
  made.bar->setRange(0, 1000);
  made.bar->setTextVisible(false);
  column->addWidget(made.bar);
  made.facts = make_line({}, "faint");
  column->addWidget(made.facts);
  list_->addWidget(made.box);
  return made;
}

void jobs_panel::show_job(const job& one) {
  auto [at, fresh] = rows_.try_emplace(one.id);
  if (fresh)
    at->second = make_row(one);
  const auto& shown = at->second;
  shown.cancel->setVisible(static_cast<bool>(one.cancel));
  shown.bar->setVisible(one.fraction > 0);
  shown.bar->setValue(qRound(1000 * one.fraction));
  QStringList facts;
  if (!one.stage.isEmpty())
    facts << one.stage;
  facts << (one.elapsed_ms() < 1000 ? tr("just begun")
                                    : tr("for %1").arg(for_how_long(one.elapsed_ms())));
  if (const QString rest = roughly(one.remaining()); !rest.isEmpty())
    facts << rest;
  shown.facts->setText(facts.join(QString::fromUtf8("  \u00b7  ")));
}

/// As the server said it last, every three seconds.
QString jobs_panel::server() const {
  if (link_.current() != remote::state::connected)
    return tr("not connected");
  QStringList lines;
  for (const auto& worker : link_.server().workers) {
    QString text = QString("%1: %2").arg(role_words(worker.role), worker_state_words(worker.state));
    if (worker.jobs > 0)
      text += tr(", running and waiting: %1").arg(worker.jobs);
    if (worker.restarts > 0)
      text += tr(", started again: %1").arg(worker.restarts);
    if (!worker.detail.empty())
      text += ", " + QString::fromStdString(worker.detail);
    lines << text;
  }
  lines << tr("Open documents: %1, connections: %2")
             .arg(link_.server().documents)
             .arg(link_.server().connections);
  return lines.join("\n");
}

void jobs_panel::refresh() {
  const auto& all = work_.all();
  for (auto at = rows_.begin(); at != rows_.end();) {
    if (std::ranges::find(all, at->first, &job::id) != all.end()) {
      ++at;
      continue;
    }
    at->second.box->hide();
    at->second.box->deleteLater();
    at = rows_.erase(at);
  }
  for (const auto& one : all)
    show_job(one);
  const bool serves = link_.current() == remote::state::connected;
  nothing_->setText(nothing_words(serves ? link_.server() : client::server_status{}, work_.left()));
  nothing_->setVisible(all.empty());
  server_->setText(server());
  adjustSize();
  if (!corner_.isNull())
    move(corner_ - QPoint(width(), height()));
}

void jobs_panel::open_above(const QPoint& corner) {
  corner_ = corner;
  refresh();
  show();
}

QString jobs_panel::text() const {
  QStringList lines;
  for (const auto& [id, shown] : rows_)
    for (const auto* label : shown.box->findChildren<QLabel*>())
      lines << label->text();
  return lines.join("\n") + "\n" + server_->text();
}

// -- the button ----------------------------------------------------------------------

jobs_button::jobs_button(jobs& work, remote& link, QWidget* parent)
    : QToolButton(parent), work_(work), link_(link) {
  setObjectName("jobs");
  setAutoRaise(true);
  // As high as the words beside it. Of itself alone: the panel is a child of it.
  setStyleSheet("#jobs { padding: 0 8px; margin: 0; border: 0; }");
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
  (new jobs_panel(work_, link_, this))->open_above(mapToGlobal(QPoint(width(), -4)));
}

}  // namespace tedit::desktop
