// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

class QCoreApplication;

namespace tedit::desktop {

/// Where translations and manual lie: beside the program as it is built and installed
/// (PREFIX/bin and PREFIX/share).
[[nodiscard]] QString shared_folder();

/// Codes of the languages that the window speaks ("en", "de"); English always, first.
[[nodiscard]] QStringList languages();
/// What a language calls itself: "Deutsch".
[[nodiscard]] QString language_name(const QString& code);

/// The translation for a wish: a code; empty: what the system prefers. A language without a
/// translation is English. Before the first widget is made. Returns the code that it took.
QString speak(QCoreApplication& app, const QString& wish);

}  // namespace tedit::desktop
