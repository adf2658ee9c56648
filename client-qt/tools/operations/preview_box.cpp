// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/operations/preview_box.hpp"

#include <QCheckBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include <string_view>

#include "client-qt/model/operation_words.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/model/receipt_words.hpp"
#include "client-qt/tools/receipt/receipt_panel.hpp"
#include "client-qt/widgets/banner.hpp"
#include "client-qt/widgets/rich_text.hpp"

namespace tedit::desktop {

namespace {

constexpr const char* setting = "preview";

struct preview_box_phrases {
  Q_DECLARE_TR_FUNCTIONS(preview)
};

QLabel* make_box_label(const char* role) {
  auto* label = new QLabel;
  label->setProperty("role", role);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QString escaped(const std::string& text) {
  return words_of(text).toHtmlEscaped();
}

}  // namespace

std::vector<surface_id> places_of(const error& reason) {
  const auto ids = surfaces_in(QString::fromStdString(reason.message + " " + reason.where));
  return {ids.begin(), ids.end()};
}

/// So says `ops::at_most` where nobody looked for the most that works; the host's checks and the
/// mesher say it by their codes.
static bool asked_too_much(const error& reason) {
  return reason.remedy.starts_with("Take a smaller") || reason.code == ec::postcondition_failed ||
         reason.code == ec::mesher_failed;
}

QString preview_figures(const client::edit_preview& made) {
  const auto& report = made.report;
  QString html = "<table>";
  html += table_row(preview_box_phrases::tr("Volume"), change_by(report.volume_change, "m3"));
  if (made.draft)
    return html + "</table>";
  html += table_row(
    preview_box_phrases::tr("Tets"),
    preview_box_phrases::tr("%1 (%2 new, %3 gone)")
      .arg(count(static_cast<double>(made.tets)), count(static_cast<double>(report.tets_added)),
           count(static_cast<double>(report.tets_removed))));
  if (const auto& ratios = report.ratios)
    html += table_row(preview_box_phrases::tr("Worst tet here"),
                      preview_box_phrases::tr("%1 before, %2 then")
                        .arg(number(ratios->min_before), number(ratios->min_after)));
  return html + "</table>";
}

QString preview_details(const client::edit_preview& made) {
  const auto& report = made.report;
  QString html;
  for (const auto& figure : report.figures)
    if (const auto value = figure_value(figure); !value.isEmpty())
      html += table_row(figure_title(figure.help).toHtmlEscaped(), value.toHtmlEscaped());
  if (!html.isEmpty())
    html = "<table>" + html + "</table>";
  const int changed = changed_loads(report);
  if (!report.receipt.empty())
    html +=
      "<p>" +
      (changed == 0 ? preview_box_phrases::tr("All loads and supports stay as they are.")
                    : preview_box_phrases::tr("Loads and supports that change: %1").arg(changed)) +
      "</p>";
  for (const auto& line : report.receipt)
    if (line.fate != fem::receipt_fate::kept)
      html += "<p>" + receipt_words(line).toHtmlEscaped() + "</p>";
  for (const auto& line : report.receipt)
    if (!line.warning.empty())
      html += "<p><b>" + escaped(line.warning) + "</b></p>";
  for (const auto& text : report.notices)
    html += "<p>" + escaped(text) + "</p>";
  return html;
}

preview_box::preview_box(live_preview& preview, QWidget* parent)
    : QWidget(parent), preview_(preview) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 8, 0, 0);
  follows_ = new QCheckBox(tr("Preview"));
  follows_->setObjectName("preview_follows");
  follows_->setToolTip(tr("Shows what the edit would make while its values move"));
  follows_->setChecked(QSettings("tedit", "tedit-qt").value(setting, true).toBool());
  now_ = new QPushButton(tr("Preview now"));
  now_->setObjectName("preview_now");
  now_->setToolTip(tr("Shows what these values would make"));
  auto* head = new QHBoxLayout;
  head->addWidget(follows_);
  head->addStretch();
  head->addWidget(now_);
  column->addLayout(head);
  state_ = make_box_label("faint");
  state_->setObjectName("preview_state");
  figures_ = make_box_label("plain");
  figures_->setObjectName("preview_figures");
  more_ = make_box_label("plain");
  more_->setObjectName("preview_details");
  fault_ = make_box_label("fault");
  fault_->setObjectName("preview_fault");
  place_ = new QPushButton(tr("Show the place"));
  place_->setProperty("role", "link");
  most_ = new QPushButton(tr("Find the most that works"));
  most_->setObjectName("find_most");
  most_->setProperty("role", "link");
  most_->setToolTip(tr("Looks for the largest value that the part takes, for up to 3 s"));
  column->addWidget(more_);
  verdict_ = new QWidget(this);
  auto* lines = new QVBoxLayout(verdict_);
  lines->setContentsMargins(0, 0, 0, 0);
  for (QWidget* one : std::initializer_list<QWidget*>{figures_, state_, fault_, place_, most_})
    lines->addWidget(one);
  connect(follows_, &QCheckBox::toggled, this, [this](bool on) {
    QSettings("tedit", "tedit-qt").setValue(setting, on);
    preview_.set_on(on);
  });
  connect(now_, &QPushButton::clicked, &preview_, &live_preview::ask_now);
  connect(place_, &QPushButton::clicked, this, [this] {
    if (preview_.refusal())
      emit place_wanted(places_of(*preview_.refusal()));
  });
  connect(most_, &QPushButton::clicked, &preview_, &live_preview::find_most);
  connect(&preview_, &live_preview::changed, this, &preview_box::refresh);
  if (preview_.is_on() != follows_->isChecked())
    preview_.set_on(follows_->isChecked());
  refresh();
}

QString preview_box::state() const {
  if (preview_.is_busy())
    return preview_.stage().isEmpty() ? tr("Making the preview")
                                      : tr("Making the preview: %1").arg(preview_.stage());
  if (preview_.shown() && preview_.shown()->made.draft)
    return tr("Its shape alone, as while it was dragged: ask for the preview, or apply it.");
  if (preview_.shown())
    return tr("Not applied. Orange: new. Blue: taken away. Made in %1.")
      .arg(duration(preview_.took_ms()));
  if (preview_.refusal())
    return tr("The part stays as it is.");
  if (preview_.has_wish() && preview_.is_on() && preview_.is_slow())
    return tr("The last preview took longer than %1: ask for it.")
      .arg(duration(live_preview::slow_ms));
  return {};
}

void preview_box::refresh() {
  const auto words = state();
  state_->setText(words);
  state_->setVisible(!words.isEmpty());
  const auto& shown = preview_.shown();
  now_->setVisible(preview_.has_wish() && !preview_.is_busy() && (!shown || shown->made.draft) &&
                   !preview_.refusal() && (preview_.is_slow() || !preview_.is_on()));
  for (auto* one : {figures_, more_}) {
    one->setVisible(shown != nullptr);
    one->setEnabled(!preview_.is_busy());  // Of the values before.
  }
  if (shown) {
    figures_->setText(preview_figures(shown->made));
    more_->setText(preview_details(shown->made));
  }
  const auto& refusal = preview_.refusal();
  fault_->setVisible(refusal.has_value());
  place_->setVisible(refusal && !places_of(*refusal).empty());
  most_->setVisible(refusal && !preview_.has_looked() && asked_too_much(*refusal));
  if (refusal)
    fault_->setText(explained(*refusal));
}

}  // namespace tedit::desktop
