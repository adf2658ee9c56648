// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>

namespace tedit::desktop {

/// Where the picture of a document's head is kept for the start page; `state_folder`: the local
/// server's.
[[nodiscard]] QString picture_file(const QString& state_folder, const QString& document);

/// Cuts a frame to the size of the start page's pictures and writes it aside.
void keep_picture(const QImage& frame, const QString& to);

}  // namespace tedit::desktop
