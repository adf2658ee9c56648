// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/net/certification.hpp"

#include <QCoreApplication>
#include <QJsonArray>
#include <QTemporaryDir>

#include <algorithm>

#include "client-qt/net/own_program.hpp"

namespace tedit::desktop {

namespace {

struct certification_phrases {
  Q_DECLARE_TR_FUNCTIONS(certification)
};

certified_case case_of(const QJsonObject& row) {
  const auto number = [&](const char* key) { return row[key].toDouble(); };
  certified_case one;
  one.name = row["name"].toString();
  one.agrees = row["agrees"].toBool();
  one.displacement = number("displacement");
  one.reaction = std::max(number("reaction"), number("surface_reaction"));
  one.compliance = number("compliance");
  one.stress = number("stress");
  one.shown_stress = number("stress_as_shown_median");
  one.our_stress_pa = number("max_von_mises_pa");
  one.their_stress_pa = number("calculix_max_von_mises_pa");
  return one;
}

}  // namespace

expected<certificate> certify(const std::vector<char>& document, const QString& folder,
                              const execution& run) {
  run.report(0.1, certification_phrases::tr("CalculiX solves").toStdString());
  const QTemporaryDir scratch;
  const auto copy = keep_document(scratch, document);
  if (!copy)
    return fail(copy.error());
  const auto answer = run_own_program({"certify", *copy, "-o", folder}, run);
  if (!answer)
    return fail(answer.error());
  certificate result;
  result.program = (*answer)["program"].toString();
  result.version = static_cast<quint32>((*answer)["version"].toInt());
  result.folder = folder;
  result.agrees = (*answer)["agrees"].toBool();
  for (const auto& row : (*answer)["load_cases"].toArray())
    result.cases.push_back(case_of(row.toObject()));
  return result;
}

}  // namespace tedit::desktop
