// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>

#include <optional>

namespace tedit::desktop {

class live_preview;
struct window_context;

/// How long a person waits for a picture, and for the window itself. Each figure is the worst so
/// far, ms; none before the first.
class latencies : public QObject {
  Q_OBJECT

public:
  /// Its time counts from here.
  latencies(window_context& in, const live_preview& preview, QObject* parent = nullptr);

  std::optional<double> window_open;       ///< From the start to the first picture of the window.
  std::optional<double> first_field;       ///< From the start to the first field on the screen.
  std::optional<double> click_to_frame;    ///< From a click to the frame with its surface marked.
  std::optional<double> commit_to_frame;   ///< From the word of a new head to its frame.
  std::optional<double> preview_to_frame;  ///< From the answer of a preview to its frame.

signals:
  /// The window is on the screen for the first time.
  void window_shown();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void drawn();

  window_context& in_;
  QElapsedTimer since_start_;
  QElapsedTimer clicked_;
  int asked_by_click_ = 0;
  QElapsedTimer committed_;
  QElapsedTimer previewed_;
};

}  // namespace tedit::desktop
