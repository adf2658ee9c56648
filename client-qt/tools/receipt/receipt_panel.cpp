// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/receipt/receipt_panel.hpp"

#include <QCoreApplication>
#include <QUrl>

#include <algorithm>
#include <cmath>

#include "client-qt/model/cad_words.hpp"
#include "client-qt/model/operation_words.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/model/receipt_words.hpp"
#include "client-qt/widgets/rich_text.hpp"

namespace tedit::desktop {

namespace {

struct receipt_panel_phrases {
  Q_DECLARE_TR_FUNCTIONS(receipt)
};

QString surface_link(surface_id id, const std::string& name) {
  const QString shown =
    name.empty() ? receipt_panel_phrases::tr("Surface %1").arg(id) : QString::fromStdString(name);
  return QString("<a href=\"surface:%1\">%2</a>").arg(id).arg(shown.toHtmlEscaped());
}

QString fate_words(const surface_change& change) {
  switch (change.fate) {
    case surface_fate::added:
      return receipt_panel_phrases::tr("new, %1").arg(quantity(change.area_after, "m2"));
    case surface_fate::removed:
      return receipt_panel_phrases::tr("gone");
    case surface_fate::merged_into:
      return receipt_panel_phrases::tr("merged into surface %1").arg(change.other);
    case surface_fate::split_from:
      return receipt_panel_phrases::tr("split from surface %1").arg(change.other);
    default:
      return receipt_panel_phrases::tr("area %1").arg(
        desktop::change(change.area_before, change.area_after));
  }
}

/// Surfaces whose area moved by less are as they were to a person.
bool matters(const surface_change& change) {
  if (change.fate != surface_fate::changed)
    return true;
  return std::abs(change.area_after - change.area_before) > 1e-6 * change.area_before;
}

}  // namespace

int changed_loads(const edit_report& report) {
  return static_cast<int>(std::ranges::count_if(
    report.receipt, [](const auto& line) { return line.fate != fem::receipt_fate::kept; }));
}

int lost_loads(const edit_report& report) {
  return static_cast<int>(std::ranges::count_if(report.receipt, [](const auto& line) {
    return line.fate == fem::receipt_fate::reduced || line.fate == fem::receipt_fate::dropped;
  }));
}

QString receipt_html(const edit_report& report) {
  QString html;
  const int changed = changed_loads(report);
  html += "<p><b>" +
          (report.receipt.empty() ? receipt_panel_phrases::tr("There are no loads yet.")
           : changed == 0
             ? receipt_panel_phrases::tr("All loads and supports are as before.")
             : receipt_panel_phrases::tr("Loads and supports that changed: %1").arg(changed)) +
          "</b></p>";
  if (changed > 0) {
    html += "<ul>";
    for (const auto& line : report.receipt)
      if (line.fate != fem::receipt_fate::kept)
        html += "<li>" + receipt_words(line).toHtmlEscaped() + "</li>";
    html += "</ul>";
  }
  for (const auto& line : report.receipt)
    if (!line.warning.empty())
      html += "<p><b>" + words_of(line.warning).toHtmlEscaped() + "</b></p>";
  html += "<table>";
  if (report.volume_change != 0)
    html += table_row(receipt_panel_phrases::tr("Volume"), change_by(report.volume_change, "m3"));
  if (report.tets_added + report.tets_removed > 0)
    html += table_row(receipt_panel_phrases::tr("Tets"),
                      receipt_panel_phrases::tr("%1 new, %2 gone")
                        .arg(count(static_cast<double>(report.tets_added)),
                             count(static_cast<double>(report.tets_removed))));
  if (const auto& ratios = report.ratios)
    html += table_row(receipt_panel_phrases::tr("Worst tet here"),
                      receipt_panel_phrases::tr("%1 before, %2 now")
                        .arg(number(ratios->min_before), number(ratios->min_after)));
  for (const auto& figure : report.figures)
    if (const auto value = figure_value(figure); !value.isEmpty())
      html += table_row(figure_title(figure.help).toHtmlEscaped(), value.toHtmlEscaped());
  html +=
    table_row(receipt_panel_phrases::tr("Time"),
              (was_previewed(report)
                 ? receipt_panel_phrases::tr("%1, made by the preview (operation %2, mesh %3, "
                                             "checks %4)")
                 : receipt_panel_phrases::tr("%1 (operation %2, mesh %3, checks %4)"))
                .arg(duration(report.total_ms), duration(report.operation_ms),
                     duration(report.improve_ms), duration(report.check_ms)));
  html += "</table>";
  QString surfaces;
  for (const auto& one : report.surface_map)
    if (matters(one))
      surfaces += table_row(surface_link(one.id, one.name), fate_words(one));
  if (!surfaces.isEmpty())
    html +=
      "<p><b>" + receipt_panel_phrases::tr("Surfaces") + "</b></p><table>" + surfaces + "</table>";
  for (const auto& text : report.notices)
    html += "<p>" + sentence_of(text).toHtmlEscaped() + "</p>";
  return html;
}

receipt_panel::receipt_panel(desktop::document& part, QWidget* parent)
    : QTextBrowser(parent), part_(part) {
  setOpenLinks(false);
  setFrameShape(QFrame::NoFrame);
  setAccessibleName(tr("What this edit did"));
  constexpr double indent = 14;  // Of lists: the column is narrow.
  document()->setIndentWidth(indent);
  connect(this, &QTextBrowser::anchorClicked, this,
          [this](const QUrl& link) { emit surface_wanted(link.path().toLongLong()); });
  connect(&part_, &desktop::document::head_changed, this, &receipt_panel::refresh);
  connect(&part_, &desktop::document::history_changed, this, &receipt_panel::refresh);
  connect(&part_, &desktop::document::closed, this, &receipt_panel::refresh);
  refresh();
}

void receipt_panel::refresh() {
  const auto* head = part_.head();
  const QString cad = head ? cad_words(head->info).toHtmlEscaped() : QString();
  setHtml(head && head->report
            ? (cad.isEmpty() ? QString() : "<p>" + cad + "</p>") + receipt_html(*head->report)
            : "<p>" + tr("No edit has been made yet.") + "</p>");
}

}  // namespace tedit::desktop
