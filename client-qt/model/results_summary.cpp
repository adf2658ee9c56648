// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/results_summary.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

#include "client-qt/model/comparable.hpp"
#include "client-qt/model/compare.hpp"
#include "client-qt/model/load_words.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/model/reaction_rows.hpp"

namespace tedit::desktop {

namespace {

struct results_summary_phrases {
  Q_DECLARE_TR_FUNCTIONS(results)
};

constexpr double good = 0.05;
constexpr double fair = 0.10;
constexpr double rough = 0.20;
constexpr double capped = 1e6;     // Safety factors end there: nothing stresses the part.
constexpr double looked_at = 0.5;  // Of the largest stress: singular places are sought above.

/// What the legend shows, too, has its unit: 0.0468 mm there and 46.8 µm here are hard to see as
/// one.
shown_quantity shown_figure(double value, const QString& unit) {
  if (unit != "Pa" && unit != "m")
    return shown(value, unit);
  const auto as = shown_as(unit);
  return {number(value * as.scale), as.name};
}

/// Rows about what may be compared with the version before.
struct row_maker {
  const summary_input& from;
  bool interim = false;

  [[nodiscard]] result_row make(figure kind, const QString& title, double value,
                                const QString& unit) const {
    result_row row;
    row.kind = kind;
    row.title = title;
    row.value = shown_figure(value, unit);
    return row;
  }

  void compare(result_row& row, double now, const std::optional<double>& before,
               const QString& unit) const {
    row.compares = from.parent != nullptr;
    if (!from.parent || interim || !before)
      return;
    row.before = shown_figure(*before, unit);
    row.change = change(*before, now);
  }
};

QString where_words(fem::singularity kind) {
  return kind == fem::singularity::clamp_rim
           ? results_summary_phrases::tr("At the rim of a clamp: ")
           : results_summary_phrases::tr("At a sharp inner edge: ");
}

QString singular_stress_words(fem::singularity kind) {
  return where_words(kind) +
         results_summary_phrases::tr(
           "the value grows with every refinement of the mesh; it is no measure of strength.");
}

QString singular_safety_words(fem::singularity kind) {
  return where_words(kind) +
         results_summary_phrases::tr(
           "the value falls with every refinement of the mesh; it says nothing.");
}

std::optional<fem::singularity> singularity_at(const solve_report& report, const vec3& at) {
  const auto found = std::ranges::find(report.singular_places, at, &stress_peak::at);
  return found == report.singular_places.end() ? std::nullopt : std::optional(found->kind);
}

void add_stress(result_section& to, const row_maker& maker, const version_record& version,
                const solve_report& report, const solve_report* before) {
  if (!(report.max_von_mises_pa > 0)) {
    to.hints << results_summary_phrases::tr(
      "There is no stress: the supports take the loads whole.");
    return;
  }
  auto row = maker.make(figure::stress, results_summary_phrases::tr("Largest von Mises stress"),
                        report.max_von_mises_pa, "Pa");
  row.at = report.max_von_mises_at;
  if (report.max_von_mises_singularity)
    row.warning = singular_stress_words(*report.max_von_mises_singularity);
  maker.compare(row, report.max_von_mises_pa,
                before ? std::optional(before->max_von_mises_pa) : std::nullopt, "Pa");
  to.rows.push_back(std::move(row));
  const auto sound = sound_maximum(version, report);
  if (!sound)
    return;
  auto apart =
    maker.make(figure::sound_stress, results_summary_phrases::tr("Largest apart from such places"),
               sound->von_mises_pa, "Pa");
  apart.at = sound->at;
  apart.note = results_summary_phrases::tr(
    "on the surface; right beside such a place it still leans on the mesh");
  to.rows.push_back(std::move(apart));
}

void add_displacement(result_section& to, const row_maker& maker, double value, const vec3& at,
                      const std::optional<double>& before, const QString& note) {
  if (!(value > 0))
    return;
  auto row = maker.make(figure::displacement, results_summary_phrases::tr("Largest displacement"),
                        value, "m");
  row.at = at;
  maker.compare(row, value, before, "m");
  row.note = note;
  to.rows.push_back(std::move(row));
}

void add_safety(result_section& to, const row_maker& maker, double value, const vec3& at,
                const std::optional<double>& before, const QString& note,
                const std::optional<fem::singularity>& singular) {
  if (value >= capped)
    return;
  auto row =
    maker.make(figure::safety, results_summary_phrases::tr("Least safety factor"), value, {});
  row.at = at;
  maker.compare(row, value, before, {});
  row.note = note;
  if (value < 1)
    row.warning = results_summary_phrases::tr("Below 1: the material yields there.");
  if (singular)
    row.warning = (row.warning + " " + singular_safety_words(*singular)).trimmed();
  to.rows.push_back(std::move(row));
}

/// What the materials of a load case do not say.
void add_hints(result_section& to, const solve_report& report, const fem::load_case* loads) {
  const bool some_yield = loads && std::ranges::any_of(loads->materials, [](const auto& one) {
                            return one.yield_strength_pa == 0;
                          });
  if (!report.min_safety_factor)
    to.hints << results_summary_phrases::tr(
      "No safety factor: no yield strength is known. Give the material one in "
      "\"Loads and supports\".");
  else if (some_yield)
    to.hints << results_summary_phrases::tr(
      "The safety factor is that of materials with a yield strength; others "
      "have none yet.");
  if (!report.mass_kg)
    to.hints << results_summary_phrases::tr(
      "No mass: a density is missing. Give the material one in \"Loads and "
      "supports\".");
}

result_row mass_row(const row_maker& maker, double kg, const std::optional<double>& before) {
  auto row = maker.make(figure::mass, results_summary_phrases::tr("Mass"), kg, "kg");
  maker.compare(row, kg, before, "kg");
  return row;
}

result_section case_section(const summary_input& from, const solve_report& report,
                            const solve_report* before, bool with_mass) {
  result_section result;
  result.title = QString::fromStdString(report.load_case);
  result.load_case = report.load_case;
  const row_maker maker{from, report.interim};
  add_stress(result, maker, *from.version, report, before);
  add_displacement(result, maker, report.max_displacement_m, report.max_displacement_at,
                   before ? std::optional(before->max_displacement_m) : std::nullopt, {});
  if (report.min_safety_factor)
    add_safety(result, maker, *report.min_safety_factor, report.min_safety_factor_at,
               before ? before->min_safety_factor : std::nullopt, {},
               singularity_at(report, report.min_safety_factor_at));
  const auto* loads = loads_of(*from.version, report.load_case);
  for (auto& row : reaction_rows(report, loads, from.surface_name))
    result.rows.push_back(std::move(row));
  if (report.relative_error_estimate > 0) {
    auto row = maker.make(
      figure::error, results_summary_phrases::tr("Estimated error of the stresses"), 0, "ratio");
    row.value.number = percent_words(report.relative_error_estimate);
    row.note = error_words(report.relative_error_estimate);
    result.rows.push_back(std::move(row));
  }
  if (with_mass && report.mass_kg && *report.mass_kg > 0)
    result.rows.push_back(
      mass_row(maker, *report.mass_kg, before ? before->mass_kg : std::nullopt));
  add_hints(result, report, loads);
  return result;
}

result_section envelope_section(const summary_input& from, const solve_outcome& now,
                                const std::optional<solve_envelope>& before) {
  const auto& all = *now.envelope;
  result_section result;
  result.title = results_summary_phrases::tr("Worst of %1 load cases").arg(all.load_cases.size());
  const row_maker maker{from, all.interim};
  const auto in = [](const worst_value& what) {
    return results_summary_phrases::tr("in %1").arg(QString::fromStdString(what.load_case));
  };
  const auto* worst = report_of(now, all.max_von_mises.load_case);
  if (all.max_von_mises.value > 0) {
    auto row = maker.make(figure::stress, results_summary_phrases::tr("Largest von Mises stress"),
                          all.max_von_mises.value, "Pa");
    row.at = all.max_von_mises.at;
    maker.compare(row, all.max_von_mises.value,
                  before ? std::optional(before->max_von_mises.value) : std::nullopt, "Pa");
    row.note = in(all.max_von_mises);
    if (worst && worst->max_von_mises_singularity)
      row.warning = singular_stress_words(*worst->max_von_mises_singularity);
    result.rows.push_back(std::move(row));
  }
  add_displacement(result, maker, all.max_displacement.value, all.max_displacement.at,
                   before ? std::optional(before->max_displacement.value) : std::nullopt,
                   in(all.max_displacement));
  if (const auto& least = all.min_safety_factor) {
    const auto* of = report_of(now, least->load_case);
    add_safety(result, maker, least->value, least->at,
               before && before->min_safety_factor ? std::optional(before->min_safety_factor->value)
                                                   : std::nullopt,
               in(*least), of ? singularity_at(*of, least->at) : std::nullopt);
  }
  return result;
}

/// The mass of all reports when they agree: then it is the part's.
std::optional<double> common_mass(const solve_outcome& of) {
  const auto& first = of.cases.front().mass_kg;
  const bool same = std::ranges::all_of(of.cases, [&](const auto& one) {
    return one.mass_kg && first && std::abs(*one.mass_kg - *first) <= 1e-9 * *first;
  });
  return same ? first : std::nullopt;
}

QString state_words(const summary_input& from, const solve_outcome& now) {
  const QString version =
    results_summary_phrases::tr("Version %1: ").arg(from.version->info.number);
  if (now.cases.front().interim)
    return version + results_summary_phrases::tr("preview, the solver still converges");
  if (now.cases.front().element_order == 1)
    return version + results_summary_phrases::tr("preview: linear tets are too stiff in bending");
  const bool preview = std::ranges::any_of(now.cases, &solve_report::preview);
  return version + (preview ? results_summary_phrases::tr("preview: stopped at a coarse tolerance")
                            : results_summary_phrases::tr("final"));
}

/// Why there is nothing to be seen, and what to do.
QString why_none(const summary_input& from) {
  if (!from.version)
    return results_summary_phrases::tr("Open a part: its figures stand here once it is solved.");
  switch (from.state) {
    case field_state::failed:
      return (results_summary_phrases::tr("The solve failed. ") + from.failure).trimmed() + " " +
             results_summary_phrases::tr("Change the loads or supports, or solve again (F5).");
    case field_state::stopped:
      return results_summary_phrases::tr("The solver was stopped. Solve again (F5).");
    case field_state::none:
      return from.version->load_cases.empty()
               ? results_summary_phrases::tr(
                   "There are no loads yet. Add supports and loads in \"Loads and "
                   "supports\".")
               : results_summary_phrases::tr("The part is not solved yet. Solve it (F5).");
    default:
      return results_summary_phrases::tr("The solver runs; first figures come as a preview.");
  }
}

}  // namespace

// -- what there is -------------------------------------------------------------------

summary_input summary_input_of(const document& part) {
  summary_input result;
  result.version = part.head();
  result.state = part.solver().progress();
  result.surface_name = [&part](surface_id id) { return part.surface_name(id); };
  if (const auto& status = part.solver().status(); status.phase == client::solve_phase::failed)
    result.failure = words_of(status.message);
  if (const auto* head = result.version; head && head->info.parent)
    if (const auto found = part.versions().find(*head->info.parent); found != part.versions().end())
      result.parent = &found->second;
  return result;
}

std::optional<solve_outcome> shown_outcome(const version_record& version, field_state state) {
  const bool interim = state == field_state::interim;
  if (!interim && state != field_state::converged)
    return std::nullopt;
  const auto& fields = version.fields;
  if (fields.empty() || fields.back()->remaining > 0)
    return interim ? std::nullopt : version.outcome;
  solve_outcome result;
  for (const auto& field : fields)
    if (field->envelope)
      result.envelope = field->envelope;
    else
      result.cases.push_back(field->report);
  if (result.cases.empty())
    return interim ? std::nullopt : version.outcome;
  return result;
}

std::vector<vec3> points_of(const results_summary& summary) {
  std::vector<vec3> result;
  for (const auto& section : summary.sections)
    for (const auto& row : section.rows)
      if (row.at)
        result.push_back(*row.at);
  return result;
}

void name_places(results_summary& summary, const std::function<QString(const vec3&)>& words) {
  for (auto& section : summary.sections)
    for (auto& row : section.rows)
      if (row.at)
        row.where = words(*row.at);
}

/// Singular places are listed by descending stress, and sought above a part of the largest one:
/// what is above the last one of a list that was cut off, and not in it, is sound; below it nobody
/// knows.
std::optional<sound_stress> sound_maximum(const version_record& version,
                                          const solve_report& report) {
  if (!report.max_von_mises_singularity || report.singular_places.empty() || !version.surface)
    return std::nullopt;
  const auto field = field_of(version, report.load_case);
  if (!field || field->envelope)
    return std::nullopt;
  std::optional<sound_stress> best;
  const auto& stress = field->values.of("von_mises_pa");
  for (std::size_t i = 0; i < field->vertices.size() && i < stress.size(); ++i) {
    const double value = stress[i];
    if (!std::isfinite(value) || (best && value <= best->von_mises_pa))
      continue;
    const auto* at = version.surface->positions().find(field->vertices[i]);
    if (at && !singularity_at(report, *at))
      best = sound_stress{value, *at};
  }
  const bool cut_off = report.singular_places_count > report.singular_places.size();
  const double known_above = std::max(looked_at * report.max_von_mises_pa,
                                      cut_off ? report.singular_places.back().von_mises_pa : 0);
  return best && best->von_mises_pa >= known_above ? best : std::nullopt;
}

QString percent_words(double part) {
  return two_digits(100 * part);
}

QString error_words(double relative_error) {
  const QString percent = percent_words(relative_error);
  if (relative_error <= good)
    return results_summary_phrases::tr("good: on average stresses are within about %1 %")
      .arg(percent);
  if (relative_error <= fair)
    return results_summary_phrases::tr(
      "fair: good enough to compare variants; peaks may be off by more");
  if (relative_error <= rough)
    return results_summary_phrases::tr("rough: trust displacements, not single stresses");
  return results_summary_phrases::tr("poor: the mesh is too coarse for these stresses");
}

// -- the rows ------------------------------------------------------------------------

results_summary summarise(const summary_input& from) {
  results_summary result;
  const auto now = from.version ? shown_outcome(*from.version, from.state) : std::nullopt;
  if (!now || now->cases.empty()) {
    result.missing = why_none(from);
    return result;
  }
  result.state = state_words(from, *now);
  result.final =
    std::ranges::none_of(now->cases, &solve_report::preview) && !now->cases.front().interim;
  if (from.parent)
    result.before = from.parent->info.number;
  const auto mass = common_mass(*now);
  if (now->envelope)
    result.sections.push_back(
      envelope_section(from, *now, comparable_envelope(*now, *from.version, from.parent)));
  const solve_report* first_before = nullptr;
  for (const auto& report : now->cases) {
    const auto* before = comparable_report(report, *from.version, from.parent);
    first_before = first_before ? first_before : before;
    result.sections.push_back(case_section(from, report, before, !mass));
  }
  if (mass && *mass > 0) {
    const row_maker maker{from, now->cases.front().interim};
    result.sections.push_back(
      {results_summary_phrases::tr("Part"),
       {},
       {mass_row(maker, *mass, first_before ? first_before->mass_kg : std::nullopt)},
       {}});
  }
  return result;
}

}  // namespace tedit::desktop
