// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QTextBrowser>
#include <QWidget>

class QLabel;
class QLineEdit;

namespace tedit::desktop {

/// The manual inside the window, as it is shipped with the program, with a search.
class help_panel : public QWidget {
  Q_OBJECT

public:
  explicit help_panel(QWidget* parent = nullptr);

  /// Marks all places of the letters and goes to the first; empty letters mark none.
  void search(const QString& letters);
  /// Goes to the next place, from the last one to the first; `back`: the other way.
  void step(bool back);
  [[nodiscard]] int hits() const { return static_cast<int>(hits_.size()); }
  [[nodiscard]] QTextBrowser* page() const { return page_; }
  void start_typing();

private:
  void show_hit();
  void mark_hits();

  QLineEdit* letters_;
  QLabel* count_;
  QTextBrowser* page_;
  QList<QTextCursor> hits_;
  int at_ = 0;
};

}  // namespace tedit::desktop
