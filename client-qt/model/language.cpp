// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/language.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace tedit::desktop {

namespace {

QString translations_folder() {
  return shared_folder() + "/tedit/translations";
}

bool add(QCoreApplication& app, const QString& name, const QString& folder) {
  auto* words = new QTranslator(&app);
  return words->load(name, folder) && QCoreApplication::installTranslator(words);
}

/// The first of the system's languages that there is a translation of.
QString of_the_system() {
  const auto all = languages();
  for (const auto& name : QLocale::system().uiLanguages())
    if (QString code = name.section('-', 0, 0); all.contains(code))
      return code;
  return "en";
}

}  // namespace

QString shared_folder() {
  return QDir::cleanPath(QCoreApplication::applicationDirPath() + "/../share");
}

QStringList languages() {
  QStringList result{"en"};
  for (const auto& file : QDir(translations_folder()).entryList({"tedit_*.qm"}, QDir::Files))
    if (const QString code = file.section('_', 1).section('.', 0, 0); !result.contains(code))
      result << code;
  return result;
}

QString language_name(const QString& code) {
  return QLocale(code).nativeLanguageName();
}

QString speak(QCoreApplication& app, const QString& wish) {
  // Words and numbers go together: the system's own ways only with its own language.
  const auto set_numbers = [](const QString& language) {
    const bool same = QLocale::system().language() == QLocale(language).language();
    QLocale::setDefault(same ? QLocale::system() : QLocale(language));
  };
  QString code = languages().contains(wish) ? wish : wish.isEmpty() ? of_the_system() : "en";
  set_numbers(code);
  if (code == "en")
    return code;
  // Qt's own words first (buttons of dialogs): ours, added later, are looked up before them.
  add(app, "qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  add(app, "tedit_" + code, translations_folder());
  return code;
}

}  // namespace tedit::desktop
