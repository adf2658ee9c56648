// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include <optional>

#include "client-qt/model/print_inspection.hpp"
#include "client-qt/model/print_rows.hpp"
#include "client-qt/model/selection.hpp"

class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace tedit::desktop {

class quantity_field;

/// What a part is printed with, and what of it is hard to print: a form, and a list of what was
/// found. A place in the list is a way to it, by a click; Enter or a double click picks its
/// surfaces.
class print_panel : public QWidget {
  Q_OBJECT

public:
  print_panel(document& part, const selection& picked, print_inspection& inspection,
              QWidget* parent = nullptr);

  /// Reads the form and asks; a number that is none is said instead.
  void check();
  /// Fills the form; a direction that is no axis stays as it is given until another is chosen.
  void set_settings(const print_settings& settings);
  [[nodiscard]] QTreeWidget* list() const { return list_; }

signals:
  void place_wanted(const tedit::vec3& at, const std::vector<tedit::surface_id>& surfaces);
  void surfaces_wanted(const std::vector<tedit::surface_id>& surfaces);

private:
  [[nodiscard]] QWidget* make_form();
  [[nodiscard]] QWidget* make_found();
  [[nodiscard]] std::optional<print_settings> read_form();
  [[nodiscard]] std::optional<vec3> direction() const;
  void refresh();
  void refresh_state();
  void say(const QString& text);
  void add_row(QTreeWidgetItem* parent, const print_row& row);
  [[nodiscard]] const print_row* place_of(const QTreeWidgetItem* item) const;

  document& part_;
  const selection& picked_;
  print_inspection& inspection_;
  quantity_field* wall_;
  quantity_field* lean_;
  QComboBox* direction_;
  vec3 own_direction_;  ///< Of the last entry, where there is one.
  QPushButton* button_;
  QLabel* state_;
  QTreeWidget* list_;
  QLabel* colours_;
  std::vector<print_row> rows_;
};

}  // namespace tedit::desktop
