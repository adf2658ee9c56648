// SPDX-License-Identifier: AGPL-3.0-or-later
// Selecting with a box that is drawn in the view.
#include <QRubberBand>

#include "client-qt/view/box_pick.hpp"
#include "client-qt/view/viewport.hpp"

namespace tedit::desktop {

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
  const auto& part = scene_.part();
  if (!part)
    return;
  const double ratio = pixel_ratio();
  pick_box box;
  box.by = enclosed ? pick_box::rule::enclosed : pick_box::rule::touched;
  box.left = where.left() * ratio;
  box.bottom = (height() - where.bottom()) * ratio;
  box.width = where.width() * ratio;
  box.height = where.height() * ratio;
  for (std::size_t i = 0; i < 4; ++i)
    box.rays[i] =
      camera_.ray(box.left + (i % 2 == 0 ? 0 : box.width), box.bottom + (i < 2 ? 0 : box.height));
  box.to_pixels = camera_.to_pixels();
  box.hidden = scene_.hidden();
  box.section = section_;
  builders_.start([this, part, box, add] {
    QMetaObject::invokeMethod(
      this, [this, found = surfaces_in(*part, box), add] { emit boxed(found, add); },
      Qt::QueuedConnection);
  });
}

}  // namespace tedit::desktop
