// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QFrame>

#include "base/error.hpp"

class QLabel;
class QLineEdit;

namespace tedit::desktop {

/// Another name for the document, in a small field over the window. Enter asks for it, Esc and a
/// click elsewhere leave it. What is refused stays to be changed, with cause and remedy below.
class name_form : public QFrame {
  Q_OBJECT

public:
  explicit name_form(QWidget* parent);
  ~name_form() override;

  /// `at`: its upper left corner in the parent.
  void open(const QString& name, QPoint at);
  void leave();
  void refuse(const error& why);

signals:
  /// Only one that is new. `leave` or `refuse` is to follow; until then nothing can be typed.
  void wanted(const QString& name);
  /// By a key: those that follow are for somebody else.
  void left();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void take();

  QString before_;
  QLineEdit* name_;
  QLabel* words_;
};

}  // namespace tedit::desktop
