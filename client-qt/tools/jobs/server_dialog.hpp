// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QDialog>

#include "client-qt/model/server_tables.hpp"
#include "client-qt/net/remote.hpp"

class QLabel;
class QTreeWidget;

namespace tedit::desktop {

/// What the server is, what takes up its memory, how its workers are, and which other machines work
/// for it; renewed while it is open.
class server_dialog : public QDialog {
  Q_OBJECT

public:
  explicit server_dialog(remote& link, QWidget* parent = nullptr);

  /// All that it shows, as it is copied.
  [[nodiscard]] QString text() const;
  [[nodiscard]] QTreeWidget* nodes() { return nodes_; }

private:
  [[nodiscard]] QTreeWidget* add_table(const char* name, const word_table& empty);
  [[nodiscard]] QWidget* make_buttons();
  [[nodiscard]] QStringList facts() const;
  void refresh();
  static void fill(QTreeWidget& list, const word_table& now);

  remote& link_;
  QLabel* facts_;
  QTreeWidget* memory_;
  QTreeWidget* workers_;
  QTreeWidget* nodes_;
  QLabel* no_nodes_;
};

}  // namespace tedit::desktop
