// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include "fem/load_case.hpp"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;

namespace tedit::desktop {

class quantity_field;
class vector_field;

/// The fields of one load: its kind, and what that kind needs.
class load_form : public QWidget {
  Q_OBJECT

public:
  load_form();

  void show_load(const fem::load& load);
  /// As typed; what is no number becomes NaN. It names no surfaces.
  [[nodiscard]] fem::load read() const;
  /// False of a load on all mass.
  [[nodiscard]] bool takes_surfaces() const;
  /// Shows what is wrong with a field in the line below it.
  void add_line_below(const char* field, QLabel* line);

signals:
  void changed();
  void kind_changed();
  void accepted();  ///< Enter.

private:
  [[nodiscard]] std::size_t kind() const;
  void build_fields(QFormLayout* form);
  void show_fields();
  void fill(const fem::load& load);
  void show_size();

  bool filling_ = false;
  QComboBox* kind_;
  QLabel* hint_;
  vector_field* components_;  ///< Of kinds that have a direction.
  quantity_field* scalar_;    ///< Of those along the normal.
  QWidget* scalar_row_;
  QLabel* size_;
  QCheckBox* by_place_;   ///< A pressure with a gradient.
  vector_field* second_;  ///< The gradient, or the moment beside a remote force.
  vector_field* place_;
};

}  // namespace tedit::desktop
