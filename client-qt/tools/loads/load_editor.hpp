// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QVariant>
#include <QWidget>

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "client-qt/model/load_editing.hpp"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;

namespace tedit::desktop {

class load_form;
class quantity_field;

/// What stands in the fields of a form, also what is no value yet.
struct typed_item {
  std::vector<QVariant> fields;
  std::vector<surface_id> surfaces;
};

/// What a form for a new item begins with.
[[nodiscard]] load_item first_item(item_kind kind, const std::vector<surface_id>& picked);

/// One material, support or load as a form, in mm, N and MPa or
/// any unit that is typed. It is a panel, no dialog: the view
/// stays free to pick surfaces. What is wrong stands in words below its field.
class load_editor : public QWidget {
  Q_OBJECT

public:
  /// `library`: materials to choose from besides own values.
  explicit load_editor(std::vector<fem::material> library, QWidget* parent = nullptr);

  /// Shows an item, also one that is not complete yet.
  void edit(const QString& title, const load_item& item);
  /// What is picked on the part: while the form is open, that is what its item acts on.
  void set_selection(const std::vector<surface_id>& picked);
  /// As it is typed; nothing while a field is at fault.
  [[nodiscard]] std::optional<load_item> value() const;
  /// What a person has typed so far; nothing while the form is as it was opened.
  [[nodiscard]] std::optional<typed_item> typed() const;
  /// Fills in what was typed before in a form of the same kind; its surfaces are the selection's.
  void take_up(const typed_item& before);

signals:
  void applied();  ///< `value` is complete.
  void closed();

private:
  void build_material();
  void build_support();
  void build_load();
  /// A field whose changes and Enter the form hears.
  QLineEdit* watched(QLineEdit* field, const char* name, const QString& accessible);
  [[nodiscard]] quantity_field* number_field(const char* name, const QString& accessible,
                                             const char* unit);
  [[nodiscard]] QLabel* fault_label(const char* field);
  [[nodiscard]] QFormLayout* new_page(item_kind kind);
  void add_row(QFormLayout* form, const QString& title, QWidget* field, const char* fault);
  [[nodiscard]] QWidget* row_of(const std::vector<QWidget*>& parts);
  void show_material(const fem::material& material);
  void show_support(const fem::constraint& support);
  void take_library(int row);
  [[nodiscard]] bool takes_surfaces() const;
  void show_surfaces();
  [[nodiscard]] std::vector<QWidget*> fields() const;
  void touched();
  void check();
  /// The item as typed; what is no number becomes NaN, which is at fault.
  [[nodiscard]] load_item read() const;
  [[nodiscard]] std::vector<item_fault> faults_now() const;

  std::vector<fem::material> library_;
  std::vector<surface_id> selection_;
  std::vector<surface_id> surfaces_;
  item_kind kind_ = item_kind::load;
  bool filling_ = false;
  bool touched_ = false;  ///< Before, what is missing is a hint and no fault.
  std::map<QString, std::vector<QLabel*>> fault_labels_;

  QScrollArea* scroll_;  ///< All but the buttons: no field is squashed.
  QLabel* title_;
  std::array<QWidget*, 3> pages_{};  ///< By kind.
  QComboBox* library_box_;
  QLineEdit* name_;
  quantity_field* young_;
  quantity_field* poisson_;
  quantity_field* density_;
  quantity_field* yield_;
  QLineEdit* regions_;
  QComboBox* support_kind_;
  QWidget* displacements_;
  std::array<QCheckBox*, 3> held_{};
  std::array<quantity_field*, 3> moved_{};
  load_form* load_;
  QWidget* picking_;
  QLabel* picked_ = nullptr;
  QPushButton* apply_;
};

}  // namespace tedit::desktop
