// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QTextBrowser>
#include <QUrl>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace tedit::desktop {

class manual_page;

/// Pages of the manual inside the window, as they are shipped with the program, with a search.
class help_panel : public QWidget {
  Q_OBJECT

public:
  explicit help_panel(QWidget* parent = nullptr);

  /// Marks all places of the letters and goes to the first; empty letters mark none.
  void search(const QString& letters);
  /// Goes to the next place, from the last one to the first; `back`: the other way.
  void step(bool back);
  [[nodiscard]] int hits() const { return static_cast<int>(hits_.size()); }
  [[nodiscard]] QTextBrowser* page() const;
  void start_typing();
  /// Shows a page ("desktop", "operations", "results", ...) from a heading on; empty: from its top.
  void show_page(const QString& id, const QString& heading = {});
  /// The page "operations", which the server's catalogue makes: Markdown.
  void set_operations(const QString& markdown);
  /// The page that is shown.
  [[nodiscard]] QString shown() const;
  /// The same page of the HTML manual; empty when that is not installed.
  [[nodiscard]] QUrl in_browser() const;

private:
  void show_hit();
  void mark_hits();
  void lay_out();

  QComboBox* pages_;
  QPushButton* browser_;
  QLineEdit* letters_;
  QLabel* count_;
  manual_page* page_;
  QList<QTextCursor> hits_;
  int at_ = 0;
  QString operations_;
};

}  // namespace tedit::desktop
