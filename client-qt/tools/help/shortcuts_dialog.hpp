// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QDialog>

#include "client-qt/model/preferences.hpp"

class QKeySequenceEdit;
class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace tedit::desktop {

/// The keys of every command, to look up and to change. It blocks nothing; a change holds at once.
class shortcuts_dialog : public QDialog {
  Q_OBJECT

public:
  explicit shortcuts_dialog(shortcut_table table, QWidget* parent = nullptr);

  [[nodiscard]] QTreeWidget* list() const { return list_; }
  /// Gives the command that is chosen these keys, unless another one has them: then it says which.
  void assign(const QKeySequence& keys);

signals:
  void changed();

private:
  void fill();
  void search(const QString& letters);
  void show_current();
  [[nodiscard]] const command* current() const;

  shortcut_table table_;
  QTreeWidget* list_;
  QKeySequenceEdit* keys_;
  QLabel* conflict_;
  QPushButton* reset_;
};

}  // namespace tedit::desktop
