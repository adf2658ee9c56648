// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include <optional>

#include "client-qt/model/probes.hpp"
#include "client-qt/view/viewport.hpp"

class QComboBox;
class QPainter;

namespace tedit::desktop {

class field_panel;
class probe_panel;

/// What a plot shows: bars over equal steps of x, or a line. Values are as they are shown (mm,
/// MPa).
struct plot {
  QString title;
  QString x_title;
  QString y_title;
  double x_low = 0;
  double x_high = 0;
  bool bars = true;
  std::vector<double> y;         ///< One for each bar, or for equal steps of x; NaN: a gap.
  std::vector<double> y_before;  ///< The same before an edit, drawn as an outline; may be empty.
  QString note;                  ///< Instead of the plot, when `y` is empty.
};

/// Values along the straight line between two points of the drawn part, taken at the nearest point
/// of its boundary; NaN where that is farther than a fiftieth of the line. Cost: O(steps log
/// facets).
[[nodiscard]] std::vector<double> along(const part_geometry& part, const std::vector<float>& values,
                                        const vec3& from, const vec3& to, std::size_t steps);

/// Draws one plot.
class plot_area : public QWidget {
  Q_OBJECT

public:
  explicit plot_area(QWidget* parent = nullptr);

  void set(plot what);
  [[nodiscard]] const plot& shown() const noexcept { return what_; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  struct axes;
  [[nodiscard]] axes make_axes(double line) const;
  void paint_axes(QPainter& painter, const axes& frame) const;
  void paint_bars(QPainter& painter, const axes& frame) const;
  void paint_line(QPainter& painter, const axes& frame) const;

  plot what_;
};

/// The shown field by area, along the line between two probes, or the tets that an edit touched.
class plot_panel : public QWidget {
  Q_OBJECT

public:
  plot_panel(document& part, probes& all, probe_panel& list, field_panel& fields, viewport& view,
             QWidget* parent = nullptr);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void refresh();
  [[nodiscard]] plot by_area() const;
  [[nodiscard]] plot on_line() const;
  [[nodiscard]] plot quality() const;

  document& part_;
  probes& all_;
  probe_panel& list_;
  field_panel& fields_;
  viewport& view_;
  QComboBox* kind_;
  plot_area* area_;
};

}  // namespace tedit::desktop
