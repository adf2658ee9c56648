// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace tedit::desktop {

/// One step of a tour beside the part: what to try, which step it is, and the ways on.
class tour_card : public QFrame {
  Q_OBJECT

public:
  explicit tour_card(QWidget* parent);

  /// `step` from 1. The last one has nothing to show or to leave out.
  void show_step(const QString& title, const QString& words, int step, int of);

signals:
  void show_me_wanted();
  void skip_wanted();
  void close_wanted();

private:
  QLabel* title_;
  QLabel* words_;
  QLabel* place_;
  QPushButton* show_me_;
  QPushButton* skip_;
  QPushButton* close_;
};

}  // namespace tedit::desktop
