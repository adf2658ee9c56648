// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>

#include <string>

namespace tedit::desktop {

/// Where the picture of a document's head is kept for the start page; `state_folder`: the local
/// server's.
[[nodiscard]] QString picture_file(const QString& state_folder, const QString& document);

/// Where the thumbnail of a version is kept, to be there again when the document is opened.
[[nodiscard]] QString picture_file(const QString& state_folder, const QString& document,
                                   const std::string& version_id);

/// Takes the pictures of a document and of its versions away.
void remove_pictures(const QString& state_folder, const QString& document);

/// Gives them to a document of another name, instead of those that it has. Waits for what
/// `keep_picture` still writes: some ms.
void move_pictures(const QString& state_folder, const QString& from, const QString& to);

/// Writes the start page's picture of a frame, aside.
void keep_picture(const QImage& frame, const QString& to);

}  // namespace tedit::desktop
