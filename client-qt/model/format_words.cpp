// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/format_words.hpp"

#include <QCoreApplication>

#include "mesh/formats.hpp"

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
    if (format.reads) {
      result << "*." + QString::fromStdString(format.name);
      // Other suffixes of the same files: a server says the first alone.
      if (const auto* known = find_format(format.name); known && !known->also.empty())
        for (const auto& suffix : QString::fromStdString(std::string(known->also)).split(' '))
          result << "*." + suffix;
    }
  return result.join(" ");
}

}  // namespace tedit::desktop
