// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/document_name.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QRegularExpression>

namespace tedit::desktop {

namespace {

constexpr auto time_format = "yyyyMMdd-HHmmss";

}  // namespace

QString valid_name(const QString& stem) {
  constexpr int longest = 40;  // Servers take 64 in all.
  return stem.left(longest).replace(QRegularExpression("[^A-Za-z0-9._-]"), "_");
}

QString new_document_name(const QString& mesh, const QDateTime& now) {
  return valid_name(QFileInfo(mesh).completeBaseName()) + "-" + now.toString(time_format);
}

document_title title_of(const QString& name) {
  static const QRegularExpression dated("^(.+)-(\\d{8}-\\d{6})$");
  const auto match = dated.match(name);
  const auto made = QDateTime::fromString(match.captured(2), time_format);
  return made.isValid() ? document_title{match.captured(1), made} : document_title{name, {}};
}

QString moment(const QDateTime& when, const QDateTime& now) {
  const QLocale locale;
  const QString time =
    locale.toString(when.time(), locale.timeFormat(QLocale::ShortFormat).remove(":ss"));
  const auto days = when.date().daysTo(now.date());
  if (days == 0)
    return QCoreApplication::translate("moment", "today, %1").arg(time);
  if (days == 1)
    return QCoreApplication::translate("moment", "yesterday, %1").arg(time);
  return locale.toString(when.date(), QLocale::ShortFormat);
}

QString moment_of(const std::string& utc) {
  const auto when = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate);
  return moment(when.toLocalTime(), QDateTime::currentDateTime());
}

}  // namespace tedit::desktop
