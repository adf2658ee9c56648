// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/legend_strip.hpp"

#include <QPainter>

#include <algorithm>
#include <cmath>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

constexpr int strip_height = 44;
constexpr double margin = 12;
constexpr double bar_height = 14;
constexpr double widest_bar = 720;
constexpr int most_ticks = 9;

}  // namespace

legend_strip::legend_strip(QWidget* parent) : QWidget(parent) {
  setFixedHeight(strip_height);
  setAccessibleName(tr("Legend"));
}

void legend_strip::set_legend(const legend& by) {
  by_ = by;
  update();
}

void legend_strip::set_ink(const QColor& ink) {
  ink_ = ink;
  update();
}

void legend_strip::paintEvent(QPaintEvent*) {
  if (!is_of_result(by_.field))
    return;
  QPainter painter(this);
  painter.setPen(ink_);
  QFont bold = font();
  bold.setBold(true);
  const auto unit = shown_as(field_unit(by_.field));
  QString title = by_.title.isEmpty() ? field_title(by_.field) : by_.title;
  if (!unit.name.isEmpty())
    title += "  [" + unit.name + "]";
  const double words = QFontMetricsF(bold).horizontalAdvance(title);
  const double room = width() - 4 * margin - words;
  const double wide = std::min(room, widest_bar);
  if (wide < 80)
    return;
  const double left = (width() - words - 2 * margin - wide) / 2;
  painter.setFont(bold);
  painter.drawText(QRectF(left, 4, words + 1, bar_height + 4), Qt::AlignVCenter, title);
  painter.setFont(font());
  const QRectF bar(left + words + 2 * margin, 6, wide, bar_height);
  for (int x = 0; x < static_cast<int>(bar.width()); ++x) {
    const double at = (x + 0.5) / bar.width();
    const auto c = by_.colour_at(by_.reversed ? 1 - at : at);
    painter.fillRect(QRectF(bar.left() + x, bar.top(), 1.5, bar.height()),
                     QColor::fromRgbF(c[0], c[1], c[2]));
  }
  paint_ticks(painter, bar);
}

/// As many values as there is room for.
void legend_strip::paint_ticks(QPainter& painter, const QRectF& bar) const {
  double free_from = -1e9;
  for (const double tick : by_.labels(most_ticks)) {
    const double at = by_.place(tick);
    const double x = bar.left() + (by_.reversed ? 1 - at : at) * bar.width();
    painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + 4));
    const QString text = by_.label(tick);
    const double half = painter.fontMetrics().horizontalAdvance(text) / 2.0;
    const double left = std::min(x - half - 1, width() - 2 * half - 4);  // Else it were cut off.
    if (left < free_from)
      continue;
    painter.drawText(QRectF(left, bar.bottom() + 4, 2 * half + 2, 18), Qt::AlignCenter, text);
    free_from = left + 2 * half + 9;
  }
}

}  // namespace tedit::desktop
