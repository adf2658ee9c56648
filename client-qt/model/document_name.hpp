// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>

namespace tedit::desktop {

/// A name for the document of a mesh file that the server takes and that no other document has:
/// the file's name and when it was opened.
[[nodiscard]] QString new_document_name(const QString& mesh, const QDateTime& now);

/// What is left of a file's name that servers take in a document's: at most 40 characters.
[[nodiscard]] QString valid_name(const QString& stem);

/// What a person calls the document, and when it was made; of other names all, and no time.
struct document_title {
  QString words;
  QDateTime made;
};
[[nodiscard]] document_title title_of(const QString& name);

/// A time as a person says it: "today, 14:02", "yesterday, 9:30", else the date.
[[nodiscard]] QString moment(const QDateTime& when, const QDateTime& now);
/// The same for a server's time, "2026-11-23T08:45:00Z".
[[nodiscard]] QString moment_of(const std::string& utc);

}  // namespace tedit::desktop
