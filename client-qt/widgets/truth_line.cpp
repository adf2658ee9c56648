// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/truth_line.hpp"

#include <QLabel>
#include <QToolButton>

#include <algorithm>

#include "client-qt/model/document_name.hpp"
#include "client-qt/model/operation_words.hpp"
#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

constexpr double slow_answer_ms = 1000;
constexpr int beside_server = 3;  // After the verdict, its button and the facts.
constexpr int around_words = 8;   // Pixels above and below a line of words, together.

}  // namespace

truth_line::truth_line(document& part, remote& link, QWidget* parent)
    : QStatusBar(parent), part_(part), link_(link) {
  setSizeGripEnabled(false);
  verdict_ = new QLabel;
  verdict_->setObjectName("verdict");
  stop_ = new QToolButton;
  stop_->setObjectName("stop_solve");
  stop_->setAutoRaise(true);
  stop_->setStyleSheet("padding: 0 6px; margin: 0;");  // As high as the words beside it.
  connect(stop_, &QToolButton::clicked, this, [this] {
    if (part_.solver().is_running())
      part_.solver().cancel();
    else
      part_.solver().solve();
  });
  facts_ = new QLabel;
  facts_->setObjectName("facts");
  // However much there is to say, it does not make the window wider than the screen.
  facts_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  others_ = new QLabel;
  others_->setObjectName("others");
  others_->setContentsMargins(0, 0, 12, 0);  // Not as if the server's address were one of them.
  server_ = new QLabel;
  server_->setObjectName("server");
  addWidget(verdict_);
  addWidget(stop_);
  addWidget(facts_, 1);
  server_->setContentsMargins(0, 0, 8, 0);  // No words at the very edge.
  addPermanentWidget(others_);
  addPermanentWidget(server_);
  connect(&part_, &document::others_changed, this, &truth_line::refresh_others);
  connect(&part_.solver(), &solve_requests::changed, this, &truth_line::refresh);
  connect(&part_, &document::field_changed, this, &truth_line::refresh);
  connect(&part_, &document::head_changed, this, &truth_line::refresh);
  connect(&part_, &document::closed, this, &truth_line::refresh);
  connect(&link_, &remote::state_changed, this, &truth_line::refresh);
  keep_height();
  refresh();
  refresh_others();
}

void truth_line::add(QWidget* widget) {
  insertPermanentWidget(beside_server, widget);
}

/// As high at every start: a QStatusBar's height hangs on when its items were last measured, before
/// or after their style, and two pixels move all that stands in the middle of the window.
void truth_line::keep_height() {
  ensurePolished();
  setFixedHeight(fontMetrics().height() + around_words);
}

void truth_line::set_theme(const theme& look) {
  look_ = look;
  keep_height();
  refresh();
}

void truth_line::set_candidate(bool on) {
  if (std::exchange(candidate_, on) != on)
    refresh();
}

QString truth_line::text() const {
  return verdict_->text() + " " + facts_->text() + " | " + server_->text();
}

QString truth_line::verdict() const {
  if (!part_.head())
    return tr("no part");
  if (candidate_)
    return tr("preview of an edit, not applied");
  switch (part_.solver().progress()) {
    case field_state::waiting:
      return tr("waiting for the solver");
    case field_state::solving:
      return tr("solving");
    case field_state::interim:
      return tr("preview, converging");
    case field_state::failed:
      return tr("not solved");
    case field_state::stopped:
      return part_.head()->fields.empty() ? tr("solver stopped") : tr("preview, solver stopped");
    case field_state::none:
      return tr("no field");
    case field_state::converged:
      break;
  }
  const auto& outcome = part_.head()->outcome;
  const bool preview = outcome && std::ranges::any_of(outcome->cases, &solve_report::preview);
  return preview ? tr("preview") : tr("final");
}

QString truth_line::facts() const {
  const auto* head = part_.head();
  if (!head)
    return {};
  QStringList parts;
  if (candidate_)  // What is known of the head's field is not true of it.
    return tr("the stress shown is that before it; it is solved when it is applied");
  const auto& outcome = head->outcome;
  if (part_.solver().progress() == field_state::converged && outcome) {
    double residual = 0;
    double estimate = 0;
    double ms = 0;
    for (const auto& one : outcome->cases) {
      residual = std::max(residual, one.true_relative_residual);
      estimate = std::max(estimate, one.relative_error_estimate);
      ms += one.total_ms;
    }
    const auto& first = outcome->cases.front();
    if (std::ranges::any_of(outcome->cases, [](const auto& one) { return !one.warnings.empty(); }))
      parts << tr("check the loads");
    parts << tr("residual %1").arg(two_digits(residual))
          << tr("error est. %1 %").arg(two_digits(100 * estimate))
          << (first.element_order == 2 ? "T10" : "T4")
          << tr("%1 unknowns").arg(count(static_cast<double>(first.dofs)))
          << tr("solved in %1 on %2").arg(duration(ms), device_words(first.device));
    if (outcome->cases.size() > 1)
      parts << tr("%1 load cases").arg(outcome->cases.size());
  } else if (part_.solver().progress() == field_state::solving ||
             part_.solver().progress() == field_state::interim) {
    const auto& status = part_.solver().status();
    if (status.iterations > 0)
      parts << tr("iteration %1").arg(status.iterations)
            << tr("residual %1").arg(two_digits(status.true_relative_residual));
  }
  parts << tr("%1 tets").arg(count(static_cast<double>(head->info.tets)));
  if (head->report)
    parts << tr("edit %1").arg(duration(made_in_ms(*head->report)));
  return parts.join(QString::fromUtf8("  \u00b7  "));
}

QString truth_line::server() const {
  switch (link_.current()) {
    case remote::state::connecting:
      return tr("connecting");
    case remote::state::lost:
      return tr("connection lost");
    case remote::state::offline:
      return tr("not connected");
    case remote::state::connected:
      break;
  }
  QStringList parts{link_.address().url.section('/', 2, 2)};
  if (link_.silence_ms() > slow_answer_ms)
    parts << tr("no answer for %1").arg(duration(link_.silence_ms()));
  else if (link_.latency_ms() >= 0)
    parts << duration(link_.latency_ms());
  if (link_.running() > 0)
    parts << tr("%1 waiting").arg(link_.running());
  return parts.join(QString::fromUtf8("  \u00b7  "));
}

/// By name as long as there is room for that; all of them in the tip.
void truth_line::refresh_others() {
  constexpr int longest = 40;  // Characters: the facts beside it are worth more.
  QStringList names, lines;
  for (const auto& one : part_.others()) {
    const auto name = one.name.empty() ? tr("somebody") : QString::fromStdString(one.name);
    names << name;
    lines << (one.only_looks ? tr("%1 watches since %2") : tr("%1 is here since %2"))
               .arg(name, moment_of(one.since));
  }
  others_->setVisible(!names.isEmpty());
  const auto all = names.join(", ");
  others_->setText(all.size() <= longest || names.size() == 1
                     ? tr("also here: %1").arg(all.left(longest))
                     : tr("%1 others here").arg(names.size()));
  others_->setToolTip(lines.join("\n"));
}

QColor truth_line::ink_of(const QString& verdict) const {
  const auto progress = candidate_ ? field_state::interim : part_.solver().progress();
  if (progress == field_state::none)
    return look_.palette.color(QPalette::WindowText);
  if (progress == field_state::failed)
    return look_.error;
  const bool good = progress == field_state::converged && verdict == tr("final");
  return good ? look_.good : look_.warning;
}

void truth_line::refresh() {
  const QString now = verdict();
  const auto style =
    QString("font-weight: 600; color: %1; padding-left: 8px;").arg(ink_of(now).name());
  if (verdict_->styleSheet() != style)  // Else it were polished anew every few seconds.
    verdict_->setStyleSheet(style);
  verdict_->setText(now);
  const bool stopped = part_.head() && part_.solver().progress() == field_state::stopped;
  stop_->setVisible(part_.head() && (part_.solver().is_running() || stopped));
  stop_->setText(stopped ? tr("Solve") : tr("Stop"));
  stop_->setToolTip(stopped ? tr("Solves the part as it is now (F5)")
                            : tr("Stops the solver; the next edit is solved again"));
  facts_->setText(facts());
  facts_->setToolTip(facts_->text());  // All of it, where the room is not enough.
  server_->setText(server());
}

}  // namespace tedit::desktop
