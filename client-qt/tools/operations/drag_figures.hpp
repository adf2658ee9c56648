// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QJsonObject>
#include <QObject>

#include <vector>

namespace tedit::desktop {

class operation_handles;
class live_preview;
struct window_context;

/// How well handles follow the mouse: for `--report`.
class drag_figures : public QObject {
  Q_OBJECT

public:
  drag_figures(window_context& in, operation_handles& handles, const live_preview& preview);

  /// Of the last drag: moves, frames of the handles, previews on the screen, its seconds, and how
  /// long each took from the move (ms; p50, p99, worst); empty before the first.
  [[nodiscard]] QJsonObject report() const;

private:
  void moved();
  void painted();
  void drawn();

  window_context& in_;
  const live_preview& preview_;
  QElapsedTimer drag_;
  double dragged_ms_ = 0;
  int moves_ = 0;
  QElapsedTimer since_move_;
  std::vector<double> handle_ms_;
  const void* last_shown_ = nullptr;
  std::vector<double> preview_ms_;
};

}  // namespace tedit::desktop
