// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/window/latencies.hpp"

#include <QEvent>
#include <QTimer>

#include <algorithm>
#include <limits>

#include <QMainWindow>
#include "client-qt/context/window_context.hpp"
#include "client-qt/model/live_preview.hpp"
#include "client-qt/view/viewport.hpp"

namespace tedit::desktop {

namespace {

/// Ends a wait.
void note(QElapsedTimer& since, std::optional<double>& worst) {
  const double ms = static_cast<double>(since.nsecsElapsed()) * 1e-6;
  worst = std::max(worst.value_or(0), ms);
  since.invalidate();
}

}  // namespace

latencies::latencies(window_context& in, const live_preview& preview, QObject* parent)
    : QObject(parent), in_(in) {
  since_start_.start();
  connect(&in_.view, &viewport::clicked, this, [this] {
    clicked_.start();
    asked_by_click_ = std::numeric_limits<int>::max();  // Known when all have heard of it.
    QTimer::singleShot(0, this, [this] { asked_by_click_ = in_.view.asked(); });
  });
  connect(&in_.part, &document::head_changed, this, [this] { committed_.start(); });
  connect(&preview, &live_preview::changed, this, [this, &preview] {
    if (preview.shown() && !preview.is_busy() &&
        in_.view.current().surface == preview.shown()->surface && !in_.view.is_settled())
      previewed_.start();
  });
  connect(&in_.view, &vtk_view::drawn, this, &latencies::drawn);
  in_.window.installEventFilter(this);
}

bool latencies::eventFilter(QObject* watched, QEvent* event) {
  if (!window_open && (event->type() == QEvent::Paint || event->type() == QEvent::UpdateRequest)) {
    watched->removeEventFilter(this);
    window_open = 0;  // Asked for once; known when this event is done.
    QTimer::singleShot(0, this, [this] {
      window_open = static_cast<double>(since_start_.nsecsElapsed()) * 1e-6;
      emit window_shown();
    });
  }
  return QObject::eventFilter(watched, event);
}

void latencies::drawn() {
  const auto& view = in_.view;
  if (clicked_.isValid() && view.seen() >= asked_by_click_)
    note(clicked_, click_to_frame);
  if (since_start_.isValid() && view.painted().extremes && view.is_seen())
    note(since_start_, first_field);
  if (!view.is_settled() || !view.is_shape_seen())
    return;
  const auto* head = in_.part.head();
  if (committed_.isValid() && head && head->surface && view.current().surface == head->surface)
    note(committed_, commit_to_frame);
  if (previewed_.isValid())
    note(previewed_, preview_to_frame);
}

}  // namespace tedit::desktop
