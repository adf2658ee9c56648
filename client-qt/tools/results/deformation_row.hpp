// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

class QDoubleSpinBox;
class QToolButton;

namespace tedit::desktop {

/// The factor that shows a displacement well: the largest is about a twentieth of the part's size;
/// 1, 2 or 5 times a power of ten, never less than 1. 0 where nothing moves. Both in m.
[[nodiscard]] double readable_deformation(double largest, double size);

/// By how much the shown displacement is made larger: typed, or what is readable; and whether the
/// part swings between its shape without load and that.
class deformation_row : public QWidget {
  Q_OBJECT

public:
  explicit deformation_row(QWidget* parent = nullptr);

  /// 0: not deformed.
  [[nodiscard]] double factor() const;
  /// Of the moment: `factor` unless it swings.
  [[nodiscard]] double shown_factor() const;
  void set_factor(double factor);
  [[nodiscard]] bool is_automatic() const;
  [[nodiscard]] bool swings() const;
  void set_swinging(bool on);
  /// What there is to show now, m: an automatic factor follows it.
  void take(double largest, double size);

signals:
  void changed();
  void swung();  ///< `shown_factor` is another one; `factor` is not.

private:
  void follow();
  void swing();

  QDoubleSpinBox* factor_;
  QToolButton* automatic_;
  QToolButton* swings_;
  QTimer clock_;
  int beat_ = 0;
  double largest_ = 0;
  double size_ = 0;
};

}  // namespace tedit::desktop
