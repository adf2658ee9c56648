// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QString>

#include "client-qt/view/scene.hpp"

namespace tedit::desktop {

/// One look for the whole window: a calm neutral, one accent, red only for errors.
struct theme {
  bool dark = false;
  QPalette palette;
  QString style_sheet;
  scene_colours scene;
  QColor ink;    ///< Text over the view.
  QColor cube;   ///< Faces of the view cube.
  QColor frame;  ///< Around fields.
  QColor good;
  QColor warning;
  QColor error;
};

[[nodiscard]] theme make_theme(bool dark);

/// An icon of our own set, or the SVG that an operation brings, in the palette's text colour.
/// "operation" for an unknown name, and for a drawing over 8 KiB or that names other files.
[[nodiscard]] QIcon icon(const QString& name_or_svg, const QColor& ink);

[[nodiscard]] QIcon window_icon();

}  // namespace tedit::desktop
