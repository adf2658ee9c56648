// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include "client-qt/model/legend.hpp"

namespace tedit::desktop {

/// A legend that lies: title and unit, beside them the colours from left to right with their
/// values. For views that stand above it and share it.
class legend_strip : public QWidget {
  Q_OBJECT

public:
  explicit legend_strip(QWidget* parent = nullptr);

  void set_legend(const legend& by);
  [[nodiscard]] const legend& shown() const noexcept { return by_; }
  void set_ink(const QColor& ink);

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  void paint_ticks(QPainter& painter, const QRectF& bar) const;

  legend by_;
  QColor ink_{32, 38, 48};
};

}  // namespace tedit::desktop
