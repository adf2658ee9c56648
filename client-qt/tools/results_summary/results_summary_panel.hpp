// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include "client-qt/model/results_summary.hpp"

class QLabel;
class QMimeData;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace tedit::desktop {

/// The figures of the part: a row each under its load case. A row with a place is a way to it, by a
/// click or Enter; Ctrl+C copies all as a table.
class results_summary_panel : public QWidget {
  Q_OBJECT

public:
  explicit results_summary_panel(QWidget* parent = nullptr);

  void show_summary(const results_summary& what);
  [[nodiscard]] const results_summary& summary() const noexcept { return shown_; }
  [[nodiscard]] QTreeWidget* tree() const { return tree_; }
  /// The table, for other programs.
  [[nodiscard]] QMimeData* table() const;
  void copy() const;
  /// Of warnings.
  void set_warning_ink(const QColor& ink);

signals:
  /// `load_case`: whose row it is; empty for the envelope and the part.
  void row_wanted(const tedit::desktop::result_row& row, const QString& load_case);
  void report_wanted();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;  ///< Of the list's own room.

private:
  void build_top();
  void wire();
  void add_section(std::size_t at);
  void add_row(QTreeWidgetItem* parent, std::size_t section, std::size_t at);
  void set_columns();
  void share_width();
  void fit_rows();
  void go_to(const QTreeWidgetItem* item);

  results_summary shown_;
  QColor warning_ink_;
  QLabel* state_;
  QLabel* missing_;
  QPushButton* copy_;
  QPushButton* report_;
  QTreeWidget* tree_;
};

}  // namespace tedit::desktop
