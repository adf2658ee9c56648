// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/view_cube.hpp"

#include <QCoreApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QTransform>

#include <array>
#include <cmath>

#include "client-qt/view/viewport.hpp"

namespace tedit::desktop {

namespace {

struct side {
  camera::direction from;
  vec3 normal;
  vec3 right;
  vec3 up;
  const char* name;
};

const std::array<side, 6> sides{{
  {camera::direction::front, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}, QT_TRANSLATE_NOOP("cube", "Front")},
  {camera::direction::back, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, QT_TRANSLATE_NOOP("cube", "Back")},
  {camera::direction::left, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, QT_TRANSLATE_NOOP("cube", "Left")},
  {camera::direction::right, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, QT_TRANSLATE_NOOP("cube", "Right")},
  {camera::direction::top, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, QT_TRANSLATE_NOOP("cube", "Top")},
  {camera::direction::bottom,
   {0, 0, -1},
   {1, 0, 0},
   {0, -1, 0},
   QT_TRANSLATE_NOOP("cube", "Bottom")},
}};

}  // namespace

view_cube::view_cube(viewport& view) : QWidget(&view), view_(view) {
  resize(sizeHint());
  setMouseTracking(true);
  setAccessibleName(tr("Standard views"));
  connect(&view, &viewport::view_changed, this, qOverload<>(&QWidget::update));
  connect(&view, &viewport::shown, this, qOverload<>(&QWidget::update));
}

void view_cube::set_colours(const QColor& fill, const QColor& ink) {
  face_ = fill;
  ink_ = ink;
  update();
}

std::vector<view_cube::face> view_cube::visible_faces() const {
  const auto pose = view_.view().get();
  const vec3 back = unit_or_up(pose.position - pose.focus);
  const vec3 right = unit_or_up(cross(pose.up, back));
  const vec3 up = cross(back, right);
  const double half = width() * 0.27;
  const QPointF middle(width() / 2.0, height() / 2.0);
  std::vector<face> result;
  for (const auto& s : sides) {
    const double facing = dot(s.normal, back);
    if (facing < 0.02)
      continue;
    QPolygonF shape;
    for (const auto& [a, b] : {std::pair{-1, 1}, {1, 1}, {1, -1}, {-1, -1}}) {
      const vec3 corner =
        s.normal + static_cast<double>(a) * s.right + static_cast<double>(b) * s.up;
      shape << middle + half * QPointF(dot(corner, right), -dot(corner, up));
    }
    result.push_back({s.from, shape, facing, QCoreApplication::translate("cube", s.name)});
  }
  return result;
}

void view_cube::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const auto& f : visible_faces()) {
    const bool under = f.shape.containsPoint(pointer_, Qt::OddEvenFill);
    QColor fill = under ? palette().highlight().color() : face_;
    fill.setAlpha(under ? 230 : 200);
    painter.setBrush(fill.darker(qRound(100 + 22 * (1 - f.facing))));
    painter.setPen(QPen(ink_, 1));
    painter.drawPolygon(f.shape);
    if (f.facing < 0.3)
      continue;
    // The name lies on the face: a square of 100 is bent onto it.
    QTransform bend;
    if (!QTransform::quadToQuad(QPolygonF({{0, 0}, {100, 0}, {100, 100}, {0, 100}}), f.shape, bend))
      continue;
    painter.save();
    painter.setTransform(bend, true);
    QFont font = painter.font();
    font.setPixelSize(26);
    painter.setFont(font);
    painter.setPen(under ? palette().highlightedText().color() : ink_);
    painter.drawText(QRectF(0, 0, 100, 100), Qt::AlignCenter, f.name);
    painter.restore();
  }
}

void view_cube::mousePressEvent(QMouseEvent* event) {
  for (const auto& f : visible_faces())
    if (f.shape.containsPoint(event->position(), Qt::OddEvenFill)) {
      view_.framing().look_from(f.from);
      return;
    }
  view_.framing().look_from(camera::direction::isometric);
}

void view_cube::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->position();
  update();
}

void view_cube::leaveEvent(QEvent*) {
  pointer_ = {-1, -1};
  update();
}

}  // namespace tedit::desktop
