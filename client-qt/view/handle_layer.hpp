// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

#include "client-qt/model/handle_layout.hpp"
#include "client-qt/model/tool_ghost.hpp"

namespace tedit::desktop {

class viewport;

/// What is drawn of a form's handles.
struct drawn_handles {
  std::vector<ghost_body> ghost;
  std::vector<laid_handle> handles;
  const handle* marked = nullptr;  ///< Pointed at or dragged.
  QString words;                   ///< Beside it.
  std::optional<vec3> snapped;     ///< Where the place took hold,
  QString snapped_to;              ///< and of what.
};

/// The view as handles are laid by: as the camera is, or as the last frame shows the part.
[[nodiscard]] lens lens_of(viewport& view);
[[nodiscard]] lens lens_of_frame(viewport& view);

/// Handles and the tool's ghost over the part. Painted over the last frame: it follows the mouse
/// without waiting for the next one, and is in no picture that is kept. Lets the mouse through.
class handle_layer : public QWidget {
  Q_OBJECT

public:
  explicit handle_layer(viewport& view);

  /// What to draw by a lens; asked whenever it is painted, as the part may have been turned.
  void set_source(std::function<drawn_handles(const lens&)> source);
  void set_accent(const QColor& accent);
  /// Times that handles were painted.
  [[nodiscard]] int frames() const noexcept { return frames_; }

signals:
  void painted();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  void paint_ghost(QPainter& painter, const std::vector<ghost_body>& bodies, const lens& by) const;
  void paint_handle(QPainter& painter, const laid_handle& one, bool marked) const;
  void paint_snap(QPainter& painter, const drawn_handles& what, const lens& by) const;
  void paint_words(QPainter& painter, QPointF beside, const QString& words) const;

  viewport& view_;
  std::function<drawn_handles(const lens&)> source_;
  QColor accent_;
  int frames_ = 0;
};

}  // namespace tedit::desktop
