// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/operations/drag_figures.hpp"

#include <algorithm>
#include <cmath>

#include "client-qt/model/live_preview.hpp"
#include "client-qt/tools/operations/operation_handles.hpp"

namespace tedit::desktop {

namespace {

double ms_of(const QElapsedTimer& clock) {
  return static_cast<double>(clock.nsecsElapsed()) * 1e-6;
}

QJsonObject shares_of(std::vector<double> all) {
  std::ranges::sort(all);
  const auto at = [&](double share) {
    return all.empty() ? 0
                       : all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
  };
  return {{"count", static_cast<qint64>(all.size())},
          {"p50_ms", at(0.5)},
          {"p99_ms", at(0.99)},
          {"worst_ms", at(1)}};
}

}  // namespace

drag_figures::drag_figures(window_context& in, operation_handles& handles,
                           const live_preview& preview)
    : QObject(&handles), in_(in), preview_(preview) {
  connect(&handles, &operation_handles::dragged, this, &drag_figures::moved);
  connect(&handles, &operation_handles::dropped, this, [this] {
    if (drag_.isValid())
      dragged_ms_ = ms_of(drag_);
    drag_.invalidate();
  });
  connect(&handles.layer(), &handle_layer::painted, this, &drag_figures::painted);
  connect(&in_.view, &vtk_view::drawn, this, &drag_figures::drawn);
}

void drag_figures::moved() {
  if (!drag_.isValid()) {
    dragged_ms_ = 0;
    moves_ = 0;
    handle_ms_.clear();
    preview_ms_.clear();
    drag_.start();
  }
  ++moves_;
  if (!since_move_.isValid())
    since_move_.start();  // Of several moves for one frame the first has waited longest.
}

void drag_figures::painted() {
  if (!since_move_.isValid())
    return;
  handle_ms_.push_back(ms_of(since_move_));
  since_move_.invalidate();
}

void drag_figures::drawn() {
  const auto& shown = preview_.shown();
  if (!drag_.isValid() || !shown || shown.get() == last_shown_ || !in_.view.is_shape_seen() ||
      in_.view.current().surface != shown->surface)
    return;
  last_shown_ = shown.get();
  preview_ms_.push_back(preview_.wished_ms());
}

QJsonObject drag_figures::report() const {
  if (moves_ == 0)
    return {};
  const double seconds = 1e-3 * (dragged_ms_ + (drag_.isValid() ? ms_of(drag_) : 0));
  return {{"seconds", seconds},
          {"moves", moves_},
          {"handles", shares_of(handle_ms_)},
          {"previews", shares_of(preview_ms_)}};
}

}  // namespace tedit::desktop
