// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include <vector>

#include "client-qt/model/legend.hpp"
#include "mesh/vec3.hpp"

class QPainter;

namespace tedit::desktop {

class viewport;

/// Paints a legend: title, unit, colour scale with ticks, and a note below ("preview"). Used on the
/// screen and in pictures. `scale`: 1 for the screen's usual size.
void paint_legend(QPainter& painter, const QRectF& where, const legend& by, const QString& note,
                  const QColor& ink, double scale);

/// Where a box goes so that it does not cover another: above it, or below where there is no room.
[[nodiscard]] QRectF clear_of(const QRectF& other, QRectF box, double gap);

/// Where the words of a mark at a place go so that none is cut off: to its other side.
[[nodiscard]] QRectF kept_within(const QSizeF& room, const QPointF& place, QRectF box, double gap);

/// Where the words of a mark go so that they cover neither the words nor the ring of another.
[[nodiscard]] QRectF clear_of_mark(const QPointF& ring, const QRectF& words, const QRectF& box,
                                   double gap);

/// Where a box goes so that it does not cover another: to its right, where there is room up to
/// `end`; else it stays.
[[nodiscard]] QRectF right_of(const QRectF& other, QRectF box, double gap, double end);

/// A ring at a place and a line from it towards `to`. Seen on every ground: ink that is light has
/// dark beside it, and dark ink light.
void paint_pin(QPainter& painter, const QPointF& place, const QPointF& to, const QColor& ink,
               double scale);

/// What lies over the viewport: legend, marks at the smallest and largest value, and a line about
/// the state of the field. Lets the mouse through.
class overlay : public QWidget {
  Q_OBJECT

public:
  explicit overlay(viewport& view);

  void set_note(const QString& note);
  [[nodiscard]] const QString& note() const noexcept { return note_; }
  void set_ink(const QColor& ink);
  void show_extremes(bool on);
  /// The legend's room is kept free when something is made to fit.
  void show_legend(bool on);
  /// Whether there is a field to come: a part without one stands in the middle.
  void expect_legend(bool on);
  [[nodiscard]] bool shows_extremes() const noexcept { return extremes_; }
  /// Axes and a length at the lower right.
  void show_orientation(bool on);
  [[nodiscard]] bool shows_orientation() const noexcept { return orientation_; }
  /// Around the legend, pixels of the screen; whether it is shown or not.
  [[nodiscard]] QRectF scale_box() const;
  /// All stands above `below` pixels that something else covers.
  void keep_free(int below);
  /// The legend stands below what ends so many pixels from the upper edge: it is lower for that,
  /// as far as it can be read then.
  void keep_free_above(int above);

  /// The view with all that lies over it, `factor` times as many pixels as on the screen.
  [[nodiscard]] QImage picture(int width = 0, int height = 0);

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  /// Words at a place of the part.
  struct tag {
    QPointF place;
    QRectF box;  ///< Around the words.
    bool below;  ///< The words stand below the place, so that two near each other stay readable.
    QString text;
  };
  void paint(QPainter& painter, double scale, const QRect& within);
  [[nodiscard]] std::vector<tag> tags(double scale) const;
  void paint_scale(QPainter& painter, double scale);
  void paint_note(QPainter& painter, double scale);
  [[nodiscard]] QRect orientation_box() const;
  [[nodiscard]] QRect triad_box() const;
  [[nodiscard]] QRect bar_box() const;
  void paint_orientation(QPainter& painter, double scale);
  void paint_tag(QPainter& painter, const tag& what, double scale) const;
  void keep_legend_room();

  viewport& view_;
  QString note_;
  QColor ink_{32, 38, 48};
  bool extremes_ = true;
  bool legend_ = true;
  bool expected_ = true;
  bool orientation_ = true;
  int below_ = 0;  ///< Pixels at the lower edge that are not free,
  int above_ = 0;  ///< and at the upper one, of those where the legend is.
};

}  // namespace tedit::desktop
