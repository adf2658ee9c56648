// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QWidget>

#include <vector>

#include "client-qt/view/camera.hpp"

namespace tedit::desktop {

class viewport;

/// A small cube that turns with the part; a click on a face looks from there.
class view_cube : public QWidget {
  Q_OBJECT

public:
  explicit view_cube(viewport& view);

  [[nodiscard]] QSize sizeHint() const override { return {84, 84}; }
  void set_colours(const QColor& fill, const QColor& ink);

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

private:
  struct face {
    camera::direction from;
    QPolygonF shape;
    double facing;  ///< Cosine towards the viewer.
    QString name;
  };
  [[nodiscard]] std::vector<face> visible_faces() const;

  viewport& view_;
  QColor face_{235, 238, 242};
  QColor ink_{60, 68, 80};
  QPointF pointer_{-1, -1};
};

}  // namespace tedit::desktop
