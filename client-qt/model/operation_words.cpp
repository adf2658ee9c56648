// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/operation_words.hpp"

#include <QCoreApplication>

#include <algorithm>

namespace tedit::desktop {

std::string in_users_language(const std::string& english) {
  return QCoreApplication::translate("operations", english.c_str()).toStdString();
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
