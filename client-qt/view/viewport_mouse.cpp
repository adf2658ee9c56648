// SPDX-License-Identifier: AGPL-3.0-or-later
// The mouse over the part: turning, moving, zooming, picking, and selecting with a box.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QRubberBand>
#include <QWheelEvent>

#include <cmath>

#include "client-qt/view/box_pick.hpp"
#include "client-qt/view/viewport.hpp"

namespace tedit::desktop {

namespace {

constexpr double drag_threshold = 4;   // Pixels: less is a click.
constexpr double zoom_step = 1.12;     // For a notch of the wheel.
constexpr double key_turn = 1.0 / 12;  // Of half a turn: 15 degrees,
constexpr double key_pan = 0.05;       // and of the view's height.

}  // namespace

void viewport::mousePressEvent(QMouseEvent* event) {
  const bool left = event->button() == Qt::LeftButton;
  if (grip_taken_ && !left)
    return;  // Another button beside the one that drags.
  if (grip_taken_)
    grips_->drop();  // Its release went to another window.
  grip_taken_ = left && grips_ && grips_->take(event->position());
  if (grip_taken_)
    return;
  pressed_ = last_ = event->position();
  dragging_ = false;
  draws_box_ = event->button() == Qt::LeftButton &&
               (boxing_ || event->modifiers().testFlag(Qt::ControlModifier));
}

void viewport::mouseMoveEvent(QMouseEvent* event) {
  if (grip_taken_)
    return grips_->drag(event->position(), event->modifiers());
  if (!pressed_) {
    hover_at(event->position(), event->globalPosition().toPoint());
    return;
  }
  const QPointF moved = event->position() - *pressed_;
  if (!dragging_ && std::hypot(moved.x(), moved.y()) < drag_threshold)
    return;
  if (!dragging_)
    forget_hovered();
  dragging_ = true;
  if (draws_box_) {
    if (!band_)
      band_ = new QRubberBand(QRubberBand::Rectangle, this);
    band_->setGeometry(QRectF(*pressed_, event->position()).normalized().toRect());
    band_->show();
    return;
  }
  drag(event->position(), event->buttons(), event->modifiers());
}

void viewport::drag(QPointF to, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers) {
  const QPointF moved = to - std::exchange(last_, to);
  draw_quickly();
  const bool pans = (buttons & Qt::MiddleButton) || (modifiers & Qt::ShiftModifier);
  if (pans)
    camera_.pan(moved.x(), -moved.y());
  else if (buttons & Qt::LeftButton)
    camera_.rotate(moved.x() / height(), moved.y() / height());
  else if (buttons & Qt::RightButton)
    camera_.zoom(std::pow(zoom_step, -moved.y() / 12), width() / 2.0, height() / 2.0);
  redraw();
  emit view_changed();
}

void viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (grip_taken_ && event->button() == Qt::LeftButton) {
    grip_taken_ = false;
    return grips_->drop();
  }
  const bool click = pressed_ && !dragging_;
  if (pressed_ && dragging_ && draws_box_)
    finish_box(event->position(), event->modifiers());
  pressed_.reset();
  dragging_ = false;
  if (!click)
    return;
  const auto hit = pick_at(event->position());
  if (event->button() == Qt::LeftButton)
    emit clicked(hit, event->modifiers());
  else if (event->button() == Qt::RightButton)
    emit menu_wanted(hit, event->globalPosition().toPoint());
}

void viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  if (grips_ && grips_->hover(event->position()))
    return;
  if (const auto hit = pick_at(event->position()))
    framing_.fly_to(hit->at);
}

void viewport::wheelEvent(QWheelEvent* event) {
  draw_quickly();
  const double notches = event->angleDelta().y() / 120.0;
  camera_.zoom(std::pow(zoom_step, notches), event->position().x(),
               height() - event->position().y());
  redraw();
  emit view_changed();
}

void viewport::keyPressEvent(QKeyEvent* event) {
  QPointF way;
  double nearer = 1;
  switch (event->key()) {
    case Qt::Key_Left:
      way = {-1, 0};
      break;
    case Qt::Key_Right:
      way = {1, 0};
      break;
    case Qt::Key_Up:
      way = {0, -1};
      break;
    case Qt::Key_Down:
      way = {0, 1};
      break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      nearer = zoom_step;
      break;
    case Qt::Key_Minus:
      nearer = 1 / zoom_step;
      break;
    default:
      return vtk_view::keyPressEvent(event);
  }
  draw_quickly();
  if (nearer != 1)
    camera_.zoom(nearer, width() / 2.0, height() / 2.0);
  else if (event->modifiers() & Qt::ShiftModifier)
    camera_.pan(key_pan * way.x() * height(), -key_pan * way.y() * height());
  else
    camera_.rotate(key_turn * way.x(), key_turn * way.y());
  redraw();
  emit view_changed();
}

void viewport::leaveEvent(QEvent*) {
  if (grips_)
    grips_->leave();
  forget_hovered();
  redraw();
}

void viewport::forget_hovered() {
  change_stage([](stage& on) { on.part.hover(std::nullopt); });
  hovered_.reset();
  emit hovered(std::nullopt, {});
}

/// What is under a grip is not meant.
void viewport::hover_at(QPointF position, QPoint global) {
  if (grips_ && grips_->hover(position)) {
    if (hovered_)
      redraw();
    return forget_hovered();
  }
  const auto hit = pick_at(position);
  const auto under = hit ? std::optional(hit->surface) : std::nullopt;
  if (under != hovered_) {
    hovered_ = under;
    change_stage([under](stage& on) { on.part.hover(under); });
    redraw();
  }
  emit hovered(hit, global);
}

// -- boxes ---------------------------------------------------------------------------

void viewport::set_boxing(bool on) {
  boxing_ = on;
  setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
}

/// As in other programs: to the right only what is wholly inside, to the left all that is touched.
void viewport::finish_box(QPointF to, Qt::KeyboardModifiers modifiers) {
  band_->hide();
  pick_box_at(QRectF(*pressed_, to).normalized(), to.x() >= pressed_->x(),
              modifiers.testFlag(Qt::ShiftModifier));
}

void viewport::pick_box_at(const QRectF& where, bool enclosed, bool add) {
  if (!part_)
    return;
  pick_box box;
  box.by = enclosed ? pick_box::rule::enclosed : pick_box::rule::touched;
  box.left = where.left();
  box.bottom = height() - where.bottom();
  box.width = where.width();
  box.height = where.height();
  for (std::size_t i = 0; i < 4; ++i)
    box.rays[i] =
      camera_.ray(box.left + (i % 2 == 0 ? 0 : box.width), box.bottom + (i < 2 ? 0 : box.height));
  box.to_pixels = camera_.to_pixels();
  box.hidden = hidden_;
  box.section = section_;
  builders_.start([this, part = part_, box, add] {
    QMetaObject::invokeMethod(
      this, [this, found = surfaces_in(*part, box), add] { emit boxed(found, add); },
      Qt::QueuedConnection);
  });
}

}  // namespace tedit::desktop
