// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/results_table.hpp"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace tedit::desktop {

namespace {

struct results_table_phrases {
  Q_DECLARE_TR_FUNCTIONS(results_table)
};

QString before_title(const results_summary& summary) {
  return results_table_phrases::tr("Version %1").arg(*summary.before);
}

QStringList titles(const results_summary& summary) {
  QStringList result{results_table_phrases::tr("Load case"), results_table_phrases::tr("Figure"),
                     results_table_phrases::tr("Value"),     results_table_phrases::tr("Unit"),
                     results_table_phrases::tr("Where"),     results_table_phrases::tr("Note")};
  if (summary.before)
    result << before_title(summary) << results_table_phrases::tr("Unit")
           << results_table_phrases::tr("Change");
  return result;
}

QString all_notes(const result_row& row) {
  QStringList parts{row.note, row.warning};
  parts.removeAll(QString());
  return parts.join(". ");
}

/// Spreadsheets know only the minus of a keyboard.
QString plain(QString number) {
  return number.replace(QChar(0x2212), '-');
}

QStringList cells(const results_summary& summary, const result_section& section,
                  const result_row& row) {
  QStringList result{section.title,  row.title, row.value.number,
                     row.value.unit, row.where, all_notes(row)};
  if (summary.before)
    result << (row.before ? row.before->number : QString(row.compares ? "-" : ""))
           << (row.before ? row.before->unit : QString())
           << (row.before ? plain(row.change) : QString(row.compares ? "-" : ""));
  return result;
}

/// All lines, that of the titles first.
std::vector<QStringList> lines(const results_summary& summary) {
  std::vector<QStringList> result{titles(summary)};
  for (const auto& section : summary.sections)
    for (const auto& row : section.rows)
      result.push_back(cells(summary, section, row));
  return result;
}

QString html_line(const QStringList& cells, const char* tag) {
  QString result = "<tr>";
  for (const auto& one : cells)
    result += QString("<%1>%2</%1>").arg(QString(tag), one.toHtmlEscaped());
  return result + "</tr>\n";
}

QString section_table(const results_summary& summary, const result_section& section) {
  const bool compares = summary.before && std::ranges::any_of(section.rows, &result_row::compares);
  QStringList head{results_table_phrases::tr("Figure"), results_table_phrases::tr("Value"),
                   results_table_phrases::tr("Where")};
  if (compares)
    head << before_title(summary) << results_table_phrases::tr("Change");
  QString html =
    "<table width=\"100%\" cellspacing=\"0\" cellpadding=\"4\">\n" + html_line(head, "th");
  for (const auto& row : section.rows) {
    const QString value =
      row.value.text().toHtmlEscaped().replace(' ', "&nbsp;");  // Units stay by their numbers.
    QString where = row.where.toHtmlEscaped();
    if (!row.note.isEmpty())
      where += (where.isEmpty() ? "" : "<br>") + row.note.toHtmlEscaped();
    if (!row.warning.isEmpty())
      where += (where.isEmpty() ? "" : "<br>") +
               QString("<b class=\"warning\">%1</b>").arg(row.warning.toHtmlEscaped());
    html += "<tr><td>" + row.title.toHtmlEscaped() + "</td><td><b>" + value + "</b></td><td>" +
            where + "</td>";
    if (compares)
      html += "<td>" +
              (row.before ? row.before->text().toHtmlEscaped().replace(' ', "&nbsp;")
                          : QString(row.compares ? "-" : "")) +
              "</td><td>" +
              (row.before ? row.change.toHtmlEscaped() : QString(row.compares ? "-" : "")) +
              "</td>";
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

}  // namespace

QString as_text_table(const results_summary& summary) {
  QString result;
  for (auto line : lines(summary)) {
    line.replaceInStrings("\t", " ");
    line.replaceInStrings("\n", " ");
    result += line.join('\t') + '\n';
  }
  return result;
}

QString as_html_table(const results_summary& summary) {
  QString html = "<table>\n";
  bool first = true;
  for (const auto& line : lines(summary)) {
    html += html_line(line, first ? "th" : "td");
    first = false;
  }
  return html + "</table>\n";
}

QString as_html_sections(const results_summary& summary) {
  QString html;
  for (const auto& section : summary.sections) {
    html += "<h3>" + section.title.toHtmlEscaped() + "</h3>\n";
    if (!section.rows.empty())
      html += section_table(summary, section);
    for (const auto& hint : section.hints)
      html += "<p>" + hint.toHtmlEscaped() + "</p>\n";
  }
  return html;
}

}  // namespace tedit::desktop
