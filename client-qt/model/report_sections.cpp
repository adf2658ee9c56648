// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/report_sections.hpp"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

#include "client-qt/model/load_words.hpp"
#include "client-qt/model/operation_words.hpp"
#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

struct report_sections_phrases {
  Q_DECLARE_TR_FUNCTIONS(report)
};

constexpr std::size_t most_places = 5;  // Singular places of a load case that are named.

QString heading(const QString& words) {
  return "<h2>" + words + "</h2>\n";
}

QString line(const QStringList& cells, const char* tag = "td") {
  QString html = "<tr>";
  for (const auto& one : cells)
    html += QString("<%1>%2</%1>").arg(QString(tag), one.toHtmlEscaped());
  return html + "</tr>\n";
}

QString table(const QStringList& titles, const QString& lines) {
  return "<table width=\"100%\" cellspacing=\"0\" cellpadding=\"4\">\n" + line(titles, "th") +
         lines + "</table>\n";
}

/// `-` stands for what is not known: in a table every line has the same cells.
QString known(const std::optional<double>& value, const char* unit) {
  return value ? shown(*value, unit).text() : QString("-");
}

// -- load cases ----------------------------------------------------------------------

QString surfaces_of(const report_facts& facts, const std::vector<surface_id>& surfaces) {
  if (surfaces.empty())
    return report_sections_phrases::tr("the whole part");
  QStringList names;
  for (const auto id : surfaces)
    if (const QString name = facts.surface_name(id); !names.contains(name))
      names << name;
  return names.join(", ");
}

QString materials_html(const fem::load_case& loads) {
  QString lines;
  for (const auto& one : loads.materials) {
    const auto given = [](double value, const char* unit) {
      return value > 0 ? shown(value, unit).text() : report_sections_phrases::tr("not given");
    };
    lines += line({QString::fromStdString(one.name), number(one.young_modulus_pa * 1e-9) + " GPa",
                   number(one.poisson_ratio),
                   one.density_kg_m3 > 0 ? number(one.density_kg_m3) + " kg/m³"
                                         : report_sections_phrases::tr("not given"),
                   given(one.yield_strength_pa, "Pa")});
  }
  return table(
    {report_sections_phrases::tr("Material"), report_sections_phrases::tr("Young's modulus"),
     report_sections_phrases::tr("Poisson's ratio"), report_sections_phrases::tr("Density"),
     report_sections_phrases::tr("Yield strength")},
    lines);
}

QString acting_html(const report_facts& facts, const fem::load_case& loads) {
  QString lines;
  const auto add = [&](const QString& kind, const auto& one) {
    QString what = words(one);
    if (!one.warning.empty())
      what += ". " + words_of(one.warning);
    lines += line({kind, what, surfaces_of(facts, one.surfaces)});
  };
  for (const auto& one : loads.constraints)
    add(report_sections_phrases::tr("Support"), one);
  for (const auto& one : loads.loads)
    add(report_sections_phrases::tr("Load"), one);
  return table({report_sections_phrases::tr("Kind"), report_sections_phrases::tr("What"),
                report_sections_phrases::tr("Surfaces")},
               lines);
}

// -- trust ---------------------------------------------------------------------------

QString item(const QString& words) {
  return "<li>" + words.toHtmlEscaped() + "</li>\n";
}

QString order_words(const solve_report& report) {
  if (report.element_order == 1)
    return report_sections_phrases::tr(
      "Linear tets: a preview. They are too stiff in bending, so displacements and "
      "stresses come out too small.");
  if (report.preview || report.interim)
    return report_sections_phrases::tr(
      "Quadratic tets, but a preview: the solver had not converged to its usual "
      "tolerance.");
  return report_sections_phrases::tr("Quadratic tets, converged: final for this mesh.");
}

QString singular_words(const report_facts& facts, const solve_report& report) {
  if (report.singular_places_count == 0)
    return {};
  QString html =
    item(report_sections_phrases::tr(
           "Places where the stress grows with every refinement of the mesh, so that it is no "
           "measure of strength (rims of clamps, sharp inner edges): %1.")
           .arg(report.singular_places_count));
  html += "<ul>\n";
  for (std::size_t i = 0; i < std::min(most_places, report.singular_places.size()); ++i) {
    const auto& one = report.singular_places[i];
    const QString where = facts.place_words ? facts.place_words(one.at) : QString();
    const QString kind = one.kind == fem::singularity::clamp_rim
                           ? report_sections_phrases::tr("rim of a clamp")
                           : report_sections_phrases::tr("sharp inner edge");
    html += item(shown(one.von_mises_pa, "Pa").text() + ", " + kind +
                 (where.isEmpty() ? QString() : ": " + where));
  }
  return html + "</ul>\n";
}

QString case_trust(const report_facts& facts, const solve_report& report) {
  QString html =
    "<h3>" + QString::fromStdString(report.load_case).toHtmlEscaped() + "</h3>\n<ul>\n";
  html += item(order_words(report));
  if (report.relative_error_estimate > 0)
    html += item(
      report_sections_phrases::tr("Estimated error of the stresses in the energy norm: %1; %2.")
        .arg(percent_words(report.relative_error_estimate) + " %",
             error_words(report.relative_error_estimate)));
  html +=
    item(report_sections_phrases::tr("Residual of the equations: %1; unknowns: %2; computed on %3.")
           .arg(two_digits(report.true_relative_residual))
           .arg(static_cast<qulonglong>(report.dofs))
           .arg(device_words(report.device)));
  html += singular_words(facts, report);
  for (const auto& warning : report.warnings)
    html += item(words_of(warning));
  if (!report.notice.empty())
    html += item(words_of(report.notice));
  return html + "</ul>\n";
}

}  // namespace

QString load_cases_html(const report_facts& facts) {
  if (facts.load_cases.empty())
    return {};
  QString html = heading(report_sections_phrases::tr("Load cases"));
  for (const auto& one : facts.load_cases)
    html += "<h3>" + QString::fromStdString(one.name).toHtmlEscaped() + "</h3>\n" +
            materials_html(one) + acting_html(facts, one);
  return html;
}

QString history_html(const report_facts& facts) {
  if (facts.history.empty())
    return {};
  QString lines;
  std::optional<double> mass_before;
  for (const auto& one : facts.history) {
    QString mass = known(one.mass_kg, "kg");
    if (one.mass_kg && mass_before)
      if (const QString by = change(*mass_before, *one.mass_kg); !by.isEmpty())
        mass += " (" + by + ")";
    mass_before = one.mass_kg;
    lines += line({QString::number(one.number),
                   one.note.isEmpty() ? one.made : one.made + " (" + one.note + ")",
                   one.volume_change_m3 ? change_by(*one.volume_change_m3, "m3") : known({}, "m3"),
                   mass, known(one.stress_pa, "Pa")});
  }
  return heading(report_sections_phrases::tr("Versions")) +
         table(
           {report_sections_phrases::tr("Version"), report_sections_phrases::tr("What was done"),
            report_sections_phrases::tr("Volume change"), report_sections_phrases::tr("Mass"),
            report_sections_phrases::tr("Largest stress")},
           lines);
}

QString trust_html(const report_facts& facts) {
  QString html = heading(report_sections_phrases::tr("What to trust"));
  html += "<p>" +
          report_sections_phrases::tr(
            "Linear elasticity: small displacements, no yielding, no contact, no fatigue. "
            "A safety factor compares with the yield strength only.") +
          "</p>\n";
  if (facts.outcome)
    for (const auto& one : facts.outcome->cases)
      html += case_trust(facts, one);
  QString notices;
  for (const auto& step : facts.history)
    for (const auto& text : step.notices)
      notices += item(report_sections_phrases::tr("Version %1: %2").arg(step.number).arg(text));
  if (!notices.isEmpty())
    html += "<h3>" + report_sections_phrases::tr("What the edits said") + "</h3>\n<ul>\n" +
            notices + "</ul>\n";
  return html;
}

}  // namespace tedit::desktop
