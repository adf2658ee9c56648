// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QFrame>

class QLineEdit;
class QListWidget;

namespace tedit::desktop {

/// A line to type into and a list of what fits, over the window: up and down walk through the list,
/// Enter takes the row, Esc and a click elsewhere close it.
class finder_popup : public QFrame {
  Q_OBJECT

public:
  /// Its fields are named `name`_letters and `name`_hits.
  finder_popup(const QString& name, const QString& placeholder, QWidget* parent);

  ~finder_popup() override;

  virtual void open();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

  /// Fills the list.
  virtual void search(const QString& letters) = 0;
  /// Enter or a click; it is closed by then.
  virtual void take(int row) = 0;
  /// The current row changed while it is open, -1 to none.
  virtual void walk(int) {}
  /// Closed without taking anything.
  virtual void give_up() {}

  QLineEdit* letters_;
  QListWidget* hits_;

private:
  bool press(int key);
  void take_current();
  void leave();

  bool open_ = false;
};

}  // namespace tedit::desktop
