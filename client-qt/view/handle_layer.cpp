// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/handle_layer.hpp"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

#include "client-qt/view/overlay.hpp"
#include "client-qt/view/viewport.hpp"

namespace tedit::desktop {

namespace {

using kind = handle::kind;

// As the preview's: what is not made yet.
const QColor tool_ink(64, 128, 217);
constexpr int ghost_alpha = 64;  // Of 255.
constexpr double knob_radius = 6;
constexpr double marked_radius = 8;
constexpr double label_size = 12;

/// The outline of all that some points cover.
QPolygonF hull_of(std::vector<QPointF> points) {
  std::ranges::sort(points, {}, [](const QPointF& p) { return std::pair(p.x(), p.y()); });
  const auto turns_right = [](const QPointF& a, const QPointF& b, const QPointF& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()) <= 0;
  };
  std::vector<QPointF> hull;
  for (int side = 0; side < 2; ++side) {
    const auto begins = hull.size();
    for (const auto& p : points) {
      while (hull.size() >= begins + 2 && turns_right(hull[hull.size() - 2], hull.back(), p))
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::ranges::reverse(points);
  }
  return QPolygonF(QList<QPointF>(hull.begin(), hull.end()));
}

std::vector<QPointF> on_screen(const std::vector<vec3>& points, const lens& by) {
  std::vector<QPointF> result;
  for (const auto& p : points)
    result.push_back(by.to_screen(p));
  return result;
}

bool all_finite(const std::vector<QPointF>& points) {
  constexpr double far = 1e5;  // Behind the viewer, or so near that it is no picture.
  return std::ranges::all_of(
    points, [](const QPointF& p) { return std::abs(p.x()) < far && std::abs(p.y()) < far; });
}

QPolygonF arrow_head(QPointF from, QPointF to, double size) {
  const QPointF way = to - from;
  const double length = std::hypot(way.x(), way.y());
  const QPointF a = length > 0 ? way / length : QPointF(0, -1);
  const QPointF b(-a.y(), a.x());
  return QPolygonF(
    {to + size * a, to - 0.7 * size * a + 0.9 * size * b, to - 0.7 * size * a - 0.9 * size * b});
}

lens lens_by(viewport& view, std::function<QPointF(const vec3&)> to_screen) {
  lens result;
  result.to_screen = std::move(to_screen);
  result.ray = [&view](QPointF at) { return view.view().ray(at.x(), view.height() - at.y()); };
  const auto pose = view.view().get();
  const vec3 ahead = unit_or_up(pose.focus - pose.position);
  result.right = unit_or_up(cross(ahead, pose.up));
  result.up = cross(result.right, ahead);
  result.room = view.size();
  result.step = 10 * view.view().metres_per_pixel();
  return result;
}

}  // namespace

lens lens_of(viewport& view) {
  return lens_by(view, [by = view.view().to_pixels()](const vec3& p) {
    const auto [x, y] = by.apply(p);
    return QPointF(x, by.height - y);
  });
}

lens lens_of_frame(viewport& view) {
  return lens_by(view, [&view](const vec3& p) { return view.to_frame(p); });
}

handle_layer::handle_layer(viewport& view) : QWidget(&view), view_(view) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setGeometry(view.rect());
  view.installEventFilter(this);
  connect(&view, &vtk_view::drawn, this, qOverload<>(&QWidget::update));
  connect(&view, &viewport::view_changed, this, qOverload<>(&QWidget::update));
}

bool handle_layer::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize)
    setGeometry(view_.rect());
  return QWidget::eventFilter(watched, event);
}

void handle_layer::set_source(std::function<drawn_handles(const lens&)> source) {
  source_ = std::move(source);
  update();
}

void handle_layer::set_accent(const QColor& accent) {
  accent_ = accent;
  update();
}

void handle_layer::paintEvent(QPaintEvent*) {
  if (!source_)
    return;
  const lens by = lens_of_frame(view_);
  const auto what = source_(by);
  if (what.handles.empty() && what.ghost.empty())
    return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paint_ghost(painter, what.ghost, by);
  const laid_handle* marked = nullptr;
  for (const auto& one : what.handles) {
    if (one.of == what.marked)
      marked = &one;
    else
      paint_handle(painter, one, false);
  }
  paint_snap(painter, what, by);
  if (marked) {
    paint_handle(painter, *marked, true);
    paint_words(painter, marked->knob, what.words);
  }
  ++frames_;
  emit painted();
}

void handle_layer::paint_ghost(QPainter& painter, const std::vector<ghost_body>& bodies,
                               const lens& by) const {
  QPainterPath covered;  // Filled once, so that what two bodies cover is no darker.
  covered.setFillRule(Qt::WindingFill);
  QPainterPath lines;
  for (const auto& body : bodies) {
    const auto bottom = on_screen(body.bottom, by);
    const auto top = on_screen(body.top, by);
    auto all = bottom;
    all.insert(all.end(), top.begin(), top.end());
    if (all.size() < 3 || !all_finite(all))
      continue;
    const auto hull = hull_of(all);
    covered.addPolygon(hull);
    covered.closeSubpath();
    for (const auto& rim : {bottom, top}) {
      lines.addPolygon(QPolygonF(QList<QPointF>(rim.begin(), rim.end())));
      lines.closeSubpath();
    }
    if (!body.has_edges) {
      lines.addPolygon(hull);
      lines.closeSubpath();
      continue;
    }
    for (std::size_t i = 0; i < std::min(bottom.size(), top.size()); ++i) {
      lines.moveTo(bottom[i]);
      lines.lineTo(top[i]);
    }
  }
  QColor fill = tool_ink;
  fill.setAlpha(ghost_alpha);
  painter.fillPath(covered, fill);
  painter.strokePath(lines, QPen(tool_ink, 1.4));
}

/// Seen on every ground: light beside dark.
void handle_layer::paint_handle(QPainter& painter, const laid_handle& one, bool marked) const {
  if (!all_finite({one.knob}) || !all_finite(one.line))
    return;
  const QColor halo(255, 255, 255, 225);
  const double radius = marked ? marked_radius : knob_radius;
  painter.setBrush(Qt::NoBrush);
  const QPolygonF line(QList<QPointF>(one.line.begin(), one.line.end()));
  for (const auto& [colour, width] : {std::pair(halo, 4.0), std::pair(accent_, 1.8)}) {
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
  }
  painter.setPen(QPen(halo, 2));
  painter.setBrush(marked ? accent_.lighter(115) : accent_);
  const bool is_arrow =
    one.of->what == kind::length || one.of->what == kind::span || one.of->what == kind::way;
  if (is_arrow && one.line.size() == 2)
    painter.drawPolygon(arrow_head(one.line.front(), one.knob, radius + 1));
  else
    painter.drawEllipse(one.knob, radius, radius);
  if (one.of->what != kind::place)
    return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(halo);
  painter.drawEllipse(one.knob, 2, 2);
}

void handle_layer::paint_snap(QPainter& painter, const drawn_handles& what, const lens& by) const {
  if (!what.snapped)
    return;
  const QPointF at = by.to_screen(*what.snapped);
  constexpr double arm = 15;
  for (const auto& [colour, width] :
       {std::pair(QColor(255, 255, 255, 225), 4.0), std::pair(QColor(25, 30, 40), 1.6)}) {
    painter.setPen(QPen(colour, width));
    painter.drawLine(at - QPointF(arm, 0), at + QPointF(arm, 0));
    painter.drawLine(at - QPointF(0, arm), at + QPointF(0, arm));
  }
}

void handle_layer::paint_words(QPainter& painter, QPointF beside, const QString& words) const {
  if (words.isEmpty())
    return;
  QFont font = painter.font();
  font.setPixelSize(static_cast<int>(label_size));
  painter.setFont(font);
  constexpr double gap = 16;
  constexpr double line = 20;
  const auto lines = words.split('\n');
  double width = 0;
  for (const auto& one : lines)
    width = std::max(width, QFontMetricsF(font).horizontalAdvance(one));
  QRectF box(beside + QPointF(gap, -line / 2),
             QSizeF(width + 12, line * static_cast<double>(lines.size())));
  box = kept_within(size(), beside, box, gap);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(255, 255, 255, 230));
  painter.drawRoundedRect(box, 4, 4);
  painter.setPen(QColor(25, 30, 40));
  painter.drawText(box, Qt::AlignCenter, words);
}

}  // namespace tedit::desktop
