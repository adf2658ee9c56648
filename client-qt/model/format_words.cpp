// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/format_words.hpp"

#include <QCoreApplication>

namespace tedit::desktop {

QString title_of(const client::offered_format& format) {
  return QCoreApplication::translate("formats", format.title.c_str());
}

QStringList filters_to_write(const std::vector<client::offered_format>& offered) {
  QStringList result;
  for (const auto& format : offered)
    if (format.writes)
      result << QString("%1 (*.%2)").arg(title_of(format), QString::fromStdString(format.name));
  return result;
}

QString patterns_to_read(const std::vector<client::offered_format>& offered) {
  QStringList result;
  for (const auto& format : offered)
    if (format.reads)
      result << "*." + QString::fromStdString(format.name);
  return result.join(" ");
}

}  // namespace tedit::desktop
