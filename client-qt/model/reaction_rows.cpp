// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/reaction_rows.hpp"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

#include "client-qt/model/load_words.hpp"

namespace tedit::desktop {

namespace {

struct reaction_rows_phrases {
  Q_DECLARE_TR_FUNCTIONS(reactions)
};

constexpr double noise = 1e-5;       // Of the largest force.
constexpr double unbalanced = 1e-2;  // Of the largest force: worth a warning.
constexpr qsizetype most_surfaces = 3;

/// The force of one support with the surfaces that it holds.
struct held {
  QString kind;  ///< "Fixed"; empty when it is not known.
  std::vector<surface_id> surfaces;
  vec3 force_n;
};

QString named(const std::vector<surface_id>& surfaces,
              const std::function<QString(surface_id)>& surface_name) {
  QStringList names;
  for (const auto id : surfaces)
    if (const QString name = surface_name(id); !names.contains(name))
      names << name;
  if (names.size() <= most_surfaces)
    return names.join(", ");
  return reaction_rows_phrases::tr("%1 and %2 more surfaces")
    .arg(names.first())
    .arg(names.size() - 1);
}

/// A surface that two supports hold counts for the first.
std::vector<held> by_support(const solve_report& report, const fem::load_case* loads) {
  std::vector<held> result;
  std::vector<named_reaction> left = report.surface_reactions;
  if (loads)
    for (const auto& support : loads->constraints) {
      held one{words(support), {}, {}};
      std::erase_if(left, [&](const auto& row) {
        const bool mine =
          std::ranges::find(support.surfaces, row.surface) != support.surfaces.end();
        if (mine) {
          one.surfaces.push_back(row.surface);
          one.force_n += row.force_n;
        }
        return mine;
      });
      if (!one.surfaces.empty())
        result.push_back(std::move(one));
    }
  for (const auto& row : left)
    result.push_back({{}, {row.surface}, row.force_n});
  return result;
}

result_row force_row(figure kind, const QString& title, const vec3& force_n) {
  result_row row;
  row.kind = kind;
  row.title = title;
  row.value = shown(norm(force_n), "N");
  row.note = direction_words(force_n);
  return row;
}

/// Against the loads: what is left over of both together.
result_row sum_row(const solve_report& report, double largest) {
  auto row = force_row(figure::reaction_sum, reaction_rows_phrases::tr("Sum of the reactions"),
                       report.reaction_n);
  const double left = norm(report.reaction_n + report.applied_n);
  if (left > unbalanced * largest)
    row.warning = reaction_rows_phrases::tr(
                    "The loads are %1, %2: %3 are not balanced. Do not trust this solve.")
                    .arg(shown(norm(report.applied_n), "N").text(),
                         direction_words(report.applied_n), shown(left, "N").text());
  else
    row.note +=
      QString(row.note.isEmpty() ? "" : "; ") + reaction_rows_phrases::tr("balances the loads");
  return row;
}

}  // namespace

QString direction_words(const vec3& force_n) {
  const double size = norm(force_n);
  QStringList parts;
  const std::pair<double, const char*> axes[] = {
    {force_n.x, "x"}, {force_n.y, "y"}, {force_n.z, "z"}};
  for (const auto& [component, name] : axes) {
    if (std::abs(component) <= noise * size)
      continue;
    const auto value = shown(component, "N");
    parts << QString("%1 %2").arg(name, value.text());
  }
  if (parts.size() != 1)
    return parts.join("; ");
  const QString axis = parts.front().left(1);
  const double along = axis == "x" ? force_n.x : axis == "y" ? force_n.y : force_n.z;
  return reaction_rows_phrases::tr("along %1").arg(QString::fromUtf8(along < 0 ? "−" : "+") + axis);
}

std::vector<result_row> reaction_rows(const solve_report& report, const fem::load_case* loads,
                                      const std::function<QString(surface_id)>& surface_name) {
  const auto supports = by_support(report, loads);
  double largest = norm(report.applied_n);
  for (const auto& one : report.surface_reactions)
    largest = std::max(largest, norm(one.force_n));
  std::vector<result_row> result;
  if (!(largest > 0))
    return result;
  for (const auto& one : supports) {
    if (norm(one.force_n) <= noise * largest)
      continue;
    auto row =
      force_row(figure::reaction,
                one.kind.isEmpty() ? reaction_rows_phrases::tr("Reaction of a support")
                                   : reaction_rows_phrases::tr("Reaction: %1").arg(one.kind),
                one.force_n);
    row.where = named(one.surfaces, surface_name);
    row.surfaces = one.surfaces;
    result.push_back(std::move(row));
  }
  if (norm(report.reaction_n) > noise * largest ||
      norm(report.reaction_n + report.applied_n) > unbalanced * largest)
    result.push_back(sum_row(report, largest));
  return result;
}

}  // namespace tedit::desktop
