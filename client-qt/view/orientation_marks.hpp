// SPDX-License-Identifier: AGPL-3.0-or-later
// Where am I: the directions of the axes and a length, painted over the part.
#pragma once

#include <QColor>
#include <QPointF>
#include <QString>

#include <optional>

#include "client-qt/view/camera.hpp"

class QPainter;

namespace tedit::desktop {

/// Paints x, y and z (red, green, blue) as the camera sees them; what points at the viewer lies in
/// front. `length` is that of an axis across, pixels.
void paint_triad(QPainter& painter, QPointF middle, double length, const camera::pose& from,
                 const QColor& ink, double scale);

/// A round length and how many pixels it takes.
struct scale_bar {
  double metres = 0;
  double pixels = 0;
  QString words;  ///< "20 mm".
};

/// The longest of 1, 2 and 5 times a power of ten that takes no more than `room` pixels. None where
/// pixels have no length.
[[nodiscard]] std::optional<scale_bar> scale_bar_of(double metres_per_pixel, double room);

/// Paints it, its right end at `end`, words above.
void paint_scale_bar(QPainter& painter, QPointF end, const scale_bar& bar, const QColor& ink,
                     double scale);

}  // namespace tedit::desktop
