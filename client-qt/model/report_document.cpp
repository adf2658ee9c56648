// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/report_document.hpp"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <map>

#include "client-qt/model/compare.hpp"
#include "client-qt/model/document_name.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/model/receipt_words.hpp"
#include "client-qt/model/report_sections.hpp"
#include "client-qt/model/results_table.hpp"

namespace tedit::desktop {

namespace {

struct report_document_phrases {
  Q_DECLARE_TR_FUNCTIONS(report)
};

constexpr int widest_picture = 640;  // Pixels of 1/96 inch: as wide as the text of an A4 page.
constexpr int tallest_picture = 370;

// What browsers and Qt's rich text both know.
constexpr const char* style = R"(
body { font-family: sans-serif; color: #20262f; background-color: #ffffff; }
h1 { font-size: 20pt; margin-bottom: 2px; } h2 { font-size: 14pt; margin-top: 22px; } h3 { font-size: 11pt; margin-top: 14px; }
p, td, th, li { font-size: 9.5pt; } th { text-align: left; background-color: #eef1f5; }
td { border-bottom: 1px solid #d5dae1; vertical-align: top; }
.faint { color: #5c6673; } .warning { color: #9a4a00; }
)";

QString operation_title(const document& part, const version_record& version) {
  const auto id = QString::fromStdString(version.info.operation);
  if (id == "import")
    return report_document_phrases::tr("Import");
  const auto* offered = part.operations().find(id);
  return offered ? QString::fromStdString(offered->about.name) : id;
}

report_step step_of(const document& part, const version_record& version) {
  report_step result;
  result.number = version.info.number;
  result.made = operation_title(part, version);
  if (!version.info.name.empty())
    result.made += ": " + QString::fromStdString(version.info.name);
  result.note = QString::fromStdString(version.info.note);
  const auto figures = figures_of(version);
  result.mass_kg = figures.mass;
  result.stress_pa = figures.stress;
  if (!version.report)
    return result;
  result.volume_change_m3 = version.report->volume_change;
  for (const auto& text : version.report->notices)
    result.notices << words_of(text);
  for (const auto& line : version.report->receipt) {
    if (line.fate != fem::receipt_fate::kept && line.fate != fem::receipt_fate::area_changed)
      result.notices << receipt_words(line);
    if (!line.warning.empty())
      result.notices << words_of(line.warning);
  }
  return result;
}

/// As surfaces are called now, whatever becomes of the document.
std::function<QString(surface_id)> names_of(const document& part, const version_record* head) {
  std::map<surface_id, QString> names;
  if (head && head->surface)
    for (const auto& [id, row] : head->surface->surfaces())
      names[id] = part.surface_name(id);
  return [names](surface_id id) {
    const auto found = names.find(id);
    return found == names.end() ? report_document_phrases::tr("Surface %1").arg(id) : found->second;
  };
}

/// From the first version to this one.
std::vector<report_step> history_of(const document& part, const version_record& head) {
  std::vector<report_step> result;
  const auto& all = part.versions();
  for (const auto* at = &head; at && result.size() <= all.size();) {
    result.push_back(step_of(part, *at));
    const auto parent = at->info.parent ? all.find(*at->info.parent) : all.end();
    at = parent == all.end() ? nullptr : &parent->second;
  }
  std::ranges::reverse(result);
  return result;
}

QString head_html(const report_facts& facts) {
  const auto row = [](const QString& what, const QString& value) {
    return "<tr><td class=\"faint\">" + what + "&nbsp;&nbsp;</td><td>" + value.toHtmlEscaped() +
           "</td></tr>\n";
  };
  const QLocale locale;
  return "<h1>" + facts.title.toHtmlEscaped() + "</h1>\n<table cellspacing=\"0\">\n" +
         row(report_document_phrases::tr("Document"), facts.document) +
         row(report_document_phrases::tr("Version"),
             report_document_phrases::tr("%1 (%2 tets; %3)")
               .arg(facts.version)
               .arg(locale.toString(static_cast<qulonglong>(facts.tets)),
                    QString::fromStdString(facts.version_id))) +
         row(report_document_phrases::tr("Date"),
             locale.toString(facts.when, QLocale::LongFormat)) +
         row(report_document_phrases::tr("Made by"), facts.program) + "</table>\n";
}

/// Those from `first` on, before `end`.
QString pictures_html(const report_facts& facts, const std::function<QString(std::size_t)>& source,
                      std::size_t first, std::size_t end) {
  QString html;
  for (std::size_t i = first; i < std::min(end, facts.pictures.size()); ++i) {
    const auto& one = facts.pictures[i];
    if (one.width <= 0 || one.height <= 0)
      continue;
    const double fit =
      std::min({1.0, double{widest_picture} / one.width, double{tallest_picture} / one.height});
    html += QString(
              "<p><img src=\"%1\" width=\"%2\" height=\"%3\" alt=\"%4\"><br>"
              "<span class=\"faint\">%4</span></p>\n")
              .arg(source(i))
              .arg(qRound(fit * one.width))
              .arg(qRound(fit * one.height))
              .arg(one.caption.toHtmlEscaped());
  }
  return html;
}

QString figures_html(const report_facts& facts) {
  QString html = "<h2>" + report_document_phrases::tr("Figures") + "</h2>\n";
  const auto& figures = facts.figures;
  const QString said = figures.missing.isEmpty() ? figures.state : figures.missing;
  return html + "<p>" + said.toHtmlEscaped() + "</p>\n" + as_html_sections(figures);
}

}  // namespace

report_facts facts_of(const document& part, const QDateTime& when) {
  report_facts result;
  result.when = when;
  result.program = "TEdit " TEDIT_VERSION;
  result.document = part.name();
  result.title = title_of(part.name()).words;
  const auto* head = part.head();
  result.surface_name = names_of(part, head);
  if (!head)
    return result;
  result.version = head->info.number;
  result.version_id = head->info.version_id;
  result.tets = head->info.tets;
  result.load_cases = part.loads().all();
  result.figures = summarise(summary_input_of(part));
  result.outcome = shown_outcome(*head, part.solver().progress());
  result.history = history_of(part, *head);
  return result;
}

std::vector<vec3> points_of(const report_facts& facts) {
  auto result = points_of(facts.figures);
  if (facts.outcome)
    for (const auto& one : facts.outcome->cases)
      for (const auto& peak : one.singular_places)
        result.push_back(peak.at);
  return result;
}

QString report_html(const report_facts& facts, const std::function<QString(std::size_t)>& source) {
  return "<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"><title>" +
         facts.title.toHtmlEscaped() + "</title><style>" + style + "</style></head>\n<body>\n" +
         head_html(facts) + pictures_html(facts, source, 0, 1) + figures_html(facts) +
         pictures_html(facts, source, 1, facts.pictures.size()) + load_cases_html(facts) +
         history_html(facts) + trust_html(facts) + "</body></html>\n";
}

QString self_contained_html(const report_facts& facts) {
  return report_html(facts, [&](std::size_t i) {
    return "data:image/png;base64," + QString::fromLatin1(facts.pictures[i].png.toBase64());
  });
}

}  // namespace tedit::desktop
