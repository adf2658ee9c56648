// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/operation_words.hpp"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

std::string in_users_language(const std::string& english) {
  return QCoreApplication::translate("operations", english.c_str()).toStdString();
}

/// For a number in the words the catalogue has a place, %1.
QString figure_words(const std::string& english) {
  const auto exact = in_users_language(english);
  static const QRegularExpression digits("[0-9]+");
  QString pattern = QString::fromStdString(english);
  const auto found = digits.match(pattern);
  if (exact != english || !found.hasMatch())
    return words_of(exact);
  pattern.replace(found.capturedStart(), found.capturedLength(), "%1");
  const auto numbered = in_users_language(pattern.toStdString());
  return numbered == pattern.toStdString() ? words_of(english)
                                           : QString::fromStdString(numbered).arg(found.captured());
}

QString figure_title(const std::string& english) {
  QString words = figure_words(english);
  if (!words.isEmpty())
    words[0] = words[0].toUpper();
  return words;
}

QString figure_value(const ops::figure& one) {
  if (one.value == 0 && one.unit.empty())
    return {};
  const QString sign = one.value < 0 ? QString::fromUtf8("−") : QString();
  return (sign + number(std::abs(one.value)) + " " + words_of(one.unit)).trimmed();
}

QString device_words(const std::string& device) {
  return device == "cpu" ? QString("CPU") : QString::fromStdString(device);
}

QString choice_words(const std::string& choice) {
  std::string words = choice;
  std::ranges::replace(words, '_', ' ');
  return QCoreApplication::translate("operations", words.c_str());
}

bool was_previewed(const edit_report& report) {
  return report.total_ms < report.operation_ms;
}

double made_in_ms(const edit_report& report) {
  return was_previewed(report) ? report.operation_ms + report.improve_ms + report.check_ms
                               : report.total_ms;
}

}  // namespace tedit::desktop
