// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/receipt_words.hpp"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <cmath>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

struct receipt_words_phrases {
  Q_DECLARE_TR_FUNCTIONS(receipt_words)
};

/// By the words of `fem::receipt_line::item`.
QString kind_words(const QString& kind) {
  static const std::pair<const char*, const char*> all[] = {
    {"fixed", QT_TRANSLATE_NOOP("receipt_words", "Fixed")},
    {"displacement", QT_TRANSLATE_NOOP("receipt_words", "Displacement")},
    {"roller", QT_TRANSLATE_NOOP("receipt_words", "Roller")},
    {"force", QT_TRANSLATE_NOOP("receipt_words", "Force")},
    {"traction", QT_TRANSLATE_NOOP("receipt_words", "Traction")},
    {"pressure", QT_TRANSLATE_NOOP("receipt_words", "Pressure")},
    {"normal force", QT_TRANSLATE_NOOP("receipt_words", "Normal force")},
    {"moment", QT_TRANSLATE_NOOP("receipt_words", "Moment")},
    {"remote force", QT_TRANSLATE_NOOP("receipt_words", "Remote force")},
    {"bearing force", QT_TRANSLATE_NOOP("receipt_words", "Bearing force")}};
  for (const auto& [name, words] : all)
    if (kind == name)
      return QCoreApplication::translate("receipt_words", words);
  return kind;
}

/// "Force (load 1)"; nothing of what is not understood. People count from one.
QString item_words(const std::string& item) {
  static const QRegularExpression form("^(constraint|load) (\\d+) \\((.+)\\)$");
  const auto match = form.match(QString::fromStdString(item));
  if (!match.hasMatch())
    return {};
  const int number = match.captured(2).toInt() + 1;
  const QString kind = kind_words(match.captured(3));
  return match.captured(1) == "load"
           ? receipt_words_phrases::tr("%1 (load %2)").arg(kind).arg(number)
           : receipt_words_phrases::tr("%1 (support %2)").arg(kind).arg(number);
}

QString list(const std::vector<surface_id>& ids) {
  QStringList numbers;
  for (const auto id : ids)
    numbers << QString::number(id);
  const QString all = numbers.join(", ");
  return ids.size() == 1 ? receipt_words_phrases::tr("surface %1").arg(all)
                         : receipt_words_phrases::tr("surfaces %1").arg(all);
}

/// What acts in all; nothing of what has no such number.
QString total_words(const fem::receipt_line& line) {
  if (line.total_before == 0 && line.total_after == 0)
    return {};
  const QString now = quantity(line.total_after, "N");
  const bool same =
    std::abs(line.total_after - line.total_before) <= 1e-9 * std::abs(line.total_before);
  return "; " + (same ? receipt_words_phrases::tr("%1 in all, as before").arg(now)
                      : receipt_words_phrases::tr("%1 in all instead of %2")
                          .arg(now, quantity(line.total_before, "N")));
}

QString area_words(const fem::receipt_line& line) {
  return quantity(line.area_after, "m2") + " (" + change(line.area_before, line.area_after) + ")";
}

}  // namespace

QString receipt_words(const fem::receipt_line& line) {
  const QString item = item_words(line.item);
  if (item.isEmpty())
    return words_of(line.text);
  switch (line.fate) {
    case fem::receipt_fate::kept:
      return receipt_words_phrases::tr("%1 is as before").arg(item);
    case fem::receipt_fate::area_changed:
      return receipt_words_phrases::tr("%1: its surfaces have %2 now").arg(item, area_words(line)) +
             total_words(line);
    case fem::receipt_fate::reduced:
      return receipt_words_phrases::tr("%1 lost %2 and acts on %3 now")
               .arg(item, list(line.surfaces_lost), area_words(line)) +
             total_words(line);
    case fem::receipt_fate::dropped:
      return receipt_words_phrases::tr("%1 no longer acts: it lost %2")
        .arg(item, list(line.surfaces_lost));
    case fem::receipt_fate::moved:
      return receipt_words_phrases::tr("%1 lost %2, its share moved to %3")
               .arg(item, list(line.surfaces_lost), list(line.moved_to)) +
             total_words(line);
  }
  return words_of(line.text);
}

}  // namespace tedit::desktop
