// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/orientation_marks.hpp"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

struct axis {
  vec3 along;
  QColor colour;
  const char* name;
};

const std::array<axis, 3> axes{{{{1, 0, 0}, {214, 62, 54}, "x"},
                                {{0, 1, 0}, {58, 158, 68}, "y"},
                                {{0, 0, 1}, {64, 120, 220}, "z"}}};

constexpr double letter_size = 12;
constexpr double end_mark = 4;  // Half the height of the bar's ends.

void use_size(QPainter& painter, double scale, bool bold) {
  QFont font = painter.font();
  font.setPixelSize(std::max(1, qRound(letter_size * scale)));
  font.setBold(bold);
  painter.setFont(font);
}

}  // namespace

void paint_triad(QPainter& painter, QPointF middle, double length, const camera::pose& from,
                 const QColor& ink, double scale) {
  const vec3 back = unit_or_up(from.position - from.focus);
  const vec3 right = unit_or_up(cross(from.up, back));
  const vec3 up = cross(back, right);
  auto sorted = axes;
  std::ranges::sort(sorted, {}, [&](const axis& one) { return dot(one.along, back); });
  use_size(painter, scale, true);
  for (const auto& one : sorted) {
    const QPointF way(dot(one.along, right), -dot(one.along, up));
    const QPointF end = middle + length * way;
    painter.setPen(QPen(one.colour, 2.5 * scale, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(middle, end);
    const double seen = std::hypot(way.x(), way.y());
    if (seen < 0.15)  // Towards the viewer or away: its letter would lie on the others.
      continue;
    const QPointF beyond = end + 9 * scale / seen * way;
    const QRectF box(beyond - scale * QPointF(8, 8), QSizeF(16, 16) * scale);
    painter.setPen(ink);
    painter.drawText(box, Qt::AlignCenter, QString::fromLatin1(one.name));
  }
}

std::optional<scale_bar> scale_bar_of(double metres_per_pixel, double room) {
  const double most = metres_per_pixel * room;
  if (!(most > 0) || !std::isfinite(most))
    return std::nullopt;
  const double power = std::pow(10, std::floor(std::log10(most)));
  double metres = power;
  for (const double step : {2.0, 5.0})
    if (step * power <= most)
      metres = step * power;
  return scale_bar{metres, metres / metres_per_pixel, length(metres)};
}

void paint_scale_bar(QPainter& painter, QPointF end, const scale_bar& bar, const QColor& ink,
                     double scale) {
  const double width = bar.pixels * scale;
  const QPointF start = end - QPointF(width, 0);
  painter.setPen(QPen(ink, 1.4 * scale));
  painter.drawLine(start, end);
  for (const auto& at : {start, end})
    painter.drawLine(at - QPointF(0, end_mark * scale), at + QPointF(0, end_mark * scale));
  use_size(painter, scale, false);
  const QRectF words(start - QPointF(0, 20 * scale), QSizeF(width, 16 * scale));
  painter.drawText(words, Qt::AlignCenter | Qt::TextDontClip, bar.words);
}

}  // namespace tedit::desktop
