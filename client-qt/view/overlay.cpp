// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/overlay.hpp"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPaintEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

#include "client-qt/model/quantities.hpp"
#include "client-qt/view/orientation_marks.hpp"
#include "client-qt/view/viewport.hpp"

namespace tedit::desktop {

namespace {

constexpr double margin = 16;
constexpr double bar_width = 16;
constexpr double legend_height = 240;
constexpr double least_legend = 140;  // Title, unit, some numbers, a note.
constexpr double legend_width = 140;
constexpr double title_size = 13;
constexpr double words_size = 12;
constexpr int most_ticks = 7;
constexpr double triad_length = 30;
constexpr double triad_room = 48;  // Half a side, with the letters.
constexpr double bar_room = 130;
constexpr int least_width = 480;  // A narrower view has no room for marks beside the legend.

QFont sized(const QFont& font, double pixels, bool bold = false) {
  QFont result = font;
  result.setPixelSize(std::max(1, qRound(pixels)));
  result.setBold(bold);
  return result;
}

QColor to_colour(const rgb& c) {
  return QColor::fromRgbF(c[0], c[1], c[2]);
}

QString title_of(const legend& by) {
  return by.title.isEmpty() ? field_title(by.field) : by.title;
}

/// Its unit, and how its range came about.
QString unit_line(const legend& by) {
  QStringList parts;
  if (const auto unit = shown_as(field_unit(by.field)); !unit.name.isEmpty())
    parts << unit.name;
  if (by.beyond)
    parts << QCoreApplication::translate("overlay", "99 % of the area");
  if (by.mode == range_mode::locked)
    parts << QCoreApplication::translate("overlay", "locked");
  if (by.logarithmic)
    parts << QCoreApplication::translate("overlay", "log");
  return parts.join(QString::fromUtf8(" · "));
}

/// The part of [0,1] at which the legend puts a value, ascending with the value.
double height_of(const legend& by, double value) {
  const double at = by.place(value);
  return by.reversed ? 1 - at : at;
}

}  // namespace

namespace {

/// How high a note is under a legend of this width; at least a line.
double note_height(const QFont& font, const QString& note, double width, double line) {
  const QRectF room(0, 0, width, 20 * line);
  const double words =
    QFontMetricsF(font).boundingRect(room, Qt::AlignLeft | Qt::TextWordWrap, note).height();
  return std::max(line, words);
}

}  // namespace

void paint_legend(QPainter& painter, const QRectF& where, const legend& by, const QString& note,
                  const QColor& ink, double scale) {
  painter.setPen(ink);
  painter.setFont(sized(painter.font(), title_size * scale, true));
  const double line = 18 * scale;
  painter.drawText(QRectF(where.left(), where.top(), 4 * where.width(), line), Qt::AlignLeft,
                   title_of(by));
  painter.setFont(sized(painter.font(), 12 * scale));
  painter.drawText(QRectF(where.left(), where.top() + line, 4 * where.width(), line), Qt::AlignLeft,
                   unit_line(by));
  const QFont bold = sized(painter.font(), words_size * scale, true);
  const double below = note_height(bold, note, where.width(), line);
  const QRectF bar(where.left(), where.top() + 2.4 * line, bar_width * scale,
                   where.height() - 2.6 * line - below);
  constexpr int bands = 240;  // A multiple of every number of steps but 16 and 9: near enough.
  for (int i = 0; i < bands; ++i) {
    const double at = (i + 0.5) / bands;
    painter.fillRect(QRectF(bar.left(), bar.bottom() - (i + 1) * bar.height() / bands, bar.width(),
                            bar.height() / bands + scale),
                     to_colour(by.colour_at(by.reversed ? 1 - at : at)));
  }
  const auto ticks = by.labels(most_ticks);
  // Many bands: words at every second edge, that none covers another.
  const double room = bar.height() / std::max<double>(1, static_cast<double>(ticks.size()) - 1);
  const auto between = static_cast<std::size_t>(by.bands > 0 ? std::ceil(0.85 * line / room) : 1);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const double tick = ticks[i];
    const double y = bar.bottom() - height_of(by, tick) * bar.height();
    painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 4 * scale, y));
    if (i % between != 0)
      continue;
    painter.drawText(QRectF(bar.right() + 8 * scale, y - line / 2, where.width(), line),
                     Qt::AlignLeft | Qt::AlignVCenter, by.label(tick));
  }
  if (!note.isEmpty()) {
    painter.setFont(bold);
    painter.drawText(QRectF(where.left(), bar.bottom() + 0.4 * line, where.width(), below),
                     Qt::AlignLeft | Qt::TextWordWrap, note);
  }
}

overlay::overlay(viewport& view) : QWidget(&view), view_(view) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  connect(&view, &viewport::shown, this, qOverload<>(&QWidget::update));
  connect(&view, &viewport::view_changed, this, [this] { update(orientation_box()); });
  show_legend(true);
}

void overlay::set_note(const QString& note) {
  note_ = note;
  update();
}

void overlay::set_ink(const QColor& ink) {
  ink_ = ink;
  update();
}

void overlay::show_extremes(bool on) {
  extremes_ = on;
  update();
}

void overlay::show_legend(bool on) {
  legend_ = on;
  keep_legend_room();
  update();
}

void overlay::expect_legend(bool on) {
  if (std::exchange(expected_, on) != on)
    keep_legend_room();
}

void overlay::keep_legend_room() {
  view_.framing().set_left_margin(legend_ && expected_ ? qRound(legend_width + margin) : 0);
}

void overlay::show_orientation(bool on) {
  orientation_ = on;
  update();
}

void overlay::keep_free(int below) {
  if (std::exchange(below_, below) != below)
    update();
}

void overlay::keep_free_above(int above) {
  if (std::exchange(above_, above) != above)
    update();
}

QRectF clear_of(const QRectF& other, QRectF box, double gap) {
  if (!box.intersects(other))
    return box;
  box.moveBottom(other.top() - gap);
  if (box.top() < 0)
    box.moveTop(other.bottom() + gap);
  return box;
}

QRectF kept_within(const QSizeF& room, const QPointF& place, QRectF box, double gap) {
  if (box.right() > room.width())
    box.moveRight(place.x() - gap);
  if (box.bottom() > room.height())
    box.moveBottom(place.y() - gap);
  else if (box.top() < 0)
    box.moveTop(place.y() + gap);
  return box;
}

QRectF clear_of_mark(const QPointF& ring, const QRectF& words, const QRectF& box, double gap) {
  constexpr double reach = 6;  // With its line.
  const QRectF around(ring - QPointF(reach, reach), QSizeF(2 * reach, 2 * reach));
  return clear_of(around, clear_of(words, box, gap), gap);
}

QRectF right_of(const QRectF& other, QRectF box, double gap, double end) {
  if (box.intersects(other) && other.right() + gap + box.width() <= end)
    box.moveLeft(other.right() + gap);
  return box;
}

void paint_pin(QPainter& painter, const QPointF& place, const QPointF& to, const QColor& ink,
               double scale) {
  constexpr double radius = 4;
  const bool light = ink.lightness() > 128;
  const QColor beside = light ? QColor(20, 24, 28, 200) : QColor(255, 255, 255, 220);
  const QPointF way = to - place;
  const double length = std::hypot(way.x(), way.y());
  const QPointF rim = place + way * (length > 0 ? radius * scale / length : 0);
  painter.setBrush(Qt::NoBrush);
  for (const auto& [colour, width] : {std::pair(beside, 3.6), std::pair(ink, 1.2)}) {
    painter.setPen(QPen(colour, width * scale));
    painter.drawEllipse(place, radius * scale, radius * scale);
    painter.drawLine(rim, to);
  }
}

std::vector<overlay::tag> overlay::tags(double scale) const {
  const auto& ends = view_.painted().extremes;
  if (!extremes_ || !ends)
    return {};
  const auto& by = view_.painted().by;
  const QFontMetricsF metrics(sized(font(), 12 * scale));
  std::vector<tag> result;
  const auto add = [&](const vec3& at, const QString& text, bool below) {
    if (view_.section() && view_.section()->takes_away(at))
      return;
    const QPointF place = scale * view_.to_frame(at);
    QRectF box(place + scale * QPointF(12, below ? 10 : -30),
               QSizeF(metrics.horizontalAdvance(text) + 12 * scale, 20 * scale));
    box = kept_within(scale * QSizeF(view_.size()), place, box, 12 * scale);
    if (legend_) {
      const QRectF scales = scale_box();
      box = right_of({scale * scales.topLeft(), scale * scales.size()}, box, 4 * scale,
                     scale * view_.width());
    }
    for (const auto& part : {triad_box(), bar_box()})
      box =
        clear_of({scale * QPointF(part.topLeft()), scale * QSizeF(part.size())}, box, 4 * scale);
    result.push_back({place, box, below, text});
  };
  const bool none = std::abs(ends->low) < 1e-4 * std::abs(ends->high - ends->low);
  add(ends->low_at, tr("min %1").arg(field_value(by.field, none ? 0 : ends->low)), true);
  if (kind_of(by.field) != field_kind::safety)  // Where there is no stress says nothing.
    add(ends->high_at,
        (by.beyond && ends->high > by.high ? tr("max %1, above the scale") : tr("max %1"))
          .arg(field_value(by.field, ends->high)),
        false);
  if (result.size() == 2)
    result[1].box = clear_of_mark(result[0].place, result[0].box, result[1].box, 4 * scale);
  return result;
}

void overlay::paint_tag(QPainter& painter, const tag& what, double scale) const {
  painter.setFont(sized(font(), 12 * scale));
  const bool leftwards = what.box.center().x() < what.place.x();
  const double side = leftwards ? what.box.right() : what.box.left();
  paint_pin(painter, what.place, {side, what.below ? what.box.top() : what.box.bottom()}, ink_,
            scale);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(255, 255, 255, 215));
  painter.drawRoundedRect(what.box, 4 * scale, 4 * scale);
  painter.setPen(QColor(25, 30, 40));
  painter.drawText(what.box, Qt::AlignCenter, what.text);
}

/// Also in pictures: nobody must take what is only looked at for what is.
void overlay::paint_note(QPainter& painter, double scale) {
  painter.setFont(sized(painter.font(), 12 * scale, true));
  const double line = 20 * scale;
  const QRectF box(scale * margin, scale * (view_.height() - margin) - line,
                   QFontMetricsF(painter.font()).horizontalAdvance(note_) + line, line);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink_.lightness() > 128 ? QColor(20, 24, 28, 160) : QColor(255, 255, 255, 200));
  painter.drawRoundedRect(box, 4 * scale, 4 * scale);
  painter.setPen(ink_);
  painter.drawText(box, Qt::AlignCenter, note_);
}

void overlay::paint(QPainter& painter, double scale, const QRect& within) {
  painter.setRenderHint(QPainter::Antialiasing);
  if (orientation_box().intersects(within))
    paint_orientation(painter, scale);
  const auto& ends = view_.painted().extremes;
  if (!ends && view_.current().before)
    paint_note(painter, scale);
  if (!ends)
    return;
  const double longest_title = 3 * legend_width;
  if (legend_ && scale_box().adjusted(0, 0, longest_title, 0).intersects(within))
    paint_scale(painter, scale);
  for (const auto& one : tags(scale))
    paint_tag(painter, one, scale);
}

/// Around axes and length, pixels of the screen; empty where they are not shown.
QRect overlay::orientation_box() const {
  if (!orientation_ || !view_.geometry() || view_.width() < least_width)
    return {};
  const int width = qRound(bar_room + 2 * triad_room + margin);
  const int height = qRound(2 * triad_room);
  return {view_.width() - width, view_.height() - below_ - height, width, height};
}

QRect overlay::triad_box() const {
  QRect box = orientation_box();
  box.setLeft(box.right() + 1 - qRound(2 * triad_room));
  return orientation_box().isEmpty() ? QRect() : box;
}

QRect overlay::bar_box() const {
  constexpr int bar_height = 40;  // With its words.
  QRect box = orientation_box();
  box.setTop(box.bottom() + 1 - bar_height);
  return orientation_box().isEmpty() ? QRect() : box;
}

void overlay::paint_orientation(QPainter& painter, double scale) {
  const QRectF box = orientation_box();
  const QPointF middle(box.right() - triad_room, box.bottom() - triad_room);
  paint_triad(painter, scale * middle, scale * triad_length, view_.view().get(), ink_, scale);
  const auto bar = scale_bar_of(view_.view().metres_per_pixel(), bar_room);
  const QPointF end(box.right() - 2 * triad_room, box.bottom() - margin);
  if (bar)
    paint_scale_bar(painter, scale * end, *bar, ink_, scale);
}

QRectF overlay::scale_box() const {
  const double room = view_.height() - below_;
  const double free = std::max(least_legend, room - above_ - 2 * margin);
  const double height = std::min({legend_height, room - 2 * margin, free});
  const auto& by = view_.painted().by;
  const QFontMetricsF title(sized(font(), title_size, true));
  const QFontMetricsF second(sized(font(), words_size));
  const double words =
    std::max(title.horizontalAdvance(title_of(by)), second.horizontalAdvance(unit_line(by)));
  const double width = std::max(legend_width, words + margin);
  return {margin / 2, room - height - 1.5 * margin, width + margin / 2, height + margin};
}

void overlay::paint_scale(QPainter& painter, double scale) {
  const QRectF box = scale_box();
  QColor ground = ink_.lightness() > 128 ? QColor(20, 24, 28, 110) : QColor(255, 255, 255, 120);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  painter.drawRoundedRect(QRectF(scale * box.topLeft(), scale * box.size()), 6 * scale, 6 * scale);
  paint_legend(painter,
               QRectF(scale * margin, scale * (box.top() + margin / 2), scale * legend_width,
                      scale * (box.height() - margin)),
               view_.painted().by, note_, ink_, scale);
}

void overlay::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  paint(painter, 1, event->rect());
}

QImage overlay::picture(int width, int height) {
  const QSize before = view_.size();
  const bool other = width > 0 && height > 0 && QSize(width, height) != before;
  const bool kept_fitted = view_.framing().keeps_fitted();
  view_.framing().keep_fitted(false);  // The picture is of what is seen.
  if (other)
    view_.resize(width, height);
  QImage image = view_.picture();
  const double scale = static_cast<double>(image.width()) / std::max(1, view_.width());
  image.setDevicePixelRatio(1);
  {
    QPainter painter(&image);
    paint(painter, scale, rect());
  }
  if (other)
    view_.resize(before);
  view_.framing().keep_fitted(kept_fitted);
  return image;
}

}  // namespace tedit::desktop
