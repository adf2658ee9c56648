// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include <array>

#include "client-qt/model/document.hpp"
#include "client-qt/model/legend.hpp"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;

namespace tedit::desktop {

class deformation_row;

/// Which field of which load case is drawn, and how: range, colours, deformation.
class field_panel : public QWidget {
  Q_OBJECT

public:
  explicit field_panel(document& part, QWidget* parent = nullptr);

  [[nodiscard]] const legend& wanted() const noexcept { return legend_; }
  /// The field of the chosen load case of the head; null when there is none yet.
  [[nodiscard]] shared_field field() const;
  /// Whether the field is there, but came before the chosen quantity was asked for.
  [[nodiscard]] bool is_on_its_way() const;
  /// Factor on the displacement; 0: not deformed.
  [[nodiscard]] double deform() const;
  [[nodiscard]] deformation_row& deformation() { return *deform_; }
  [[nodiscard]] bool isolines() const;
  void set_isolines(bool on);
  /// Steps of one colour each; 0: smooth.
  void set_bands(int bands);
  void set_field(shown_field field);
  void set_deform(double factor);
  /// A load case by its name; an empty one: the envelope, or the only one.
  void set_case(const QString& name);
  [[nodiscard]] QString shown_case() const;  ///< As for `set_case`.
  /// How fields are drawn unless something else is chosen. `locked`: to the range of the first
  /// converged field of a document.
  void set_look(colour_map map, bool locked, bool logarithmic);
  /// Shows the range that the view took from the values; without any there is none.
  void take_range(const legend& shown, bool has_values);

signals:
  void changed();
  void height_changed();  ///< It has another row, or one less.

private:
  void list_fields();
  void list_cases();
  void show_row(QWidget& field, bool on);
  void field_chosen();
  void case_chosen();
  void map_chosen();
  void say_what_is_missing();
  [[nodiscard]] bool lacks_yield() const;
  /// Whether the range is that of the values.
  [[nodiscard]] bool follows_values() const;
  void read_form();
  void enable_what_counts();

  document& part_;
  legend legend_;
  bool locks_ = false;
  bool to_lock_ = false;  ///< With the next field.
  QComboBox* field_;
  QComboBox* case_;
  QComboBox* map_;
  QComboBox* bands_;
  QCheckBox* isolines_;
  QLabel* missing_;
  /// By the kind of field: what has a sign is read by other colours than what has none.
  std::array<colour_map, 3> maps_{colour_map::viridis, colour_map::coolwarm, colour_map::safety};
  QComboBox* mode_;
  QLineEdit* low_;
  QLineEdit* high_;
  QCheckBox* log_;
  deformation_row* deform_;
};

}  // namespace tedit::desktop
