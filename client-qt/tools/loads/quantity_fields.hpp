// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <QWidget>

#include <array>

#include "mesh/vec3.hpp"

class QLabel;

namespace tedit::desktop {

/// A line for one quantity, in the unit that is shown or any other that is typed with it.
class quantity_field : public QLineEdit {
  Q_OBJECT

public:
  /// `accessible` says what it is without its unit.
  quantity_field(const QString& name, const QString& accessible, const QString& si_unit);

  void set_unit(const QString& si_unit);
  [[nodiscard]] const QString& si_unit() const { return si_unit_; }
  [[nodiscard]] QString unit_name() const;  ///< The one that is shown: "MPa".
  /// In SI units; NaN while it is no number of its unit.
  [[nodiscard]] double value() const;
  void set_value(double in_si);

private:
  QString what_;
  QString si_unit_;
};

/// A field with its unit behind it.
[[nodiscard]] QWidget* with_unit(quantity_field* field);

/// Three components along x, y and z in one line, with their unit.
class vector_field : public QWidget {
  Q_OBJECT

public:
  /// The fields are named `name`_x, `name`_y and `name`_z.
  vector_field(const QString& name, const QString& accessible, const QString& si_unit);

  void set_unit(const QString& si_unit);
  [[nodiscard]] vec3 value() const;  ///< In SI units; NaN where no number stands.
  void set_value(const vec3& in_si);
  /// "2500 N in all"; empty for zero and for what is no number.
  [[nodiscard]] QString size_in_words() const;

signals:
  void changed();
  void accepted();  ///< Enter.

private:
  std::array<quantity_field*, 3> parts_{};
  QLabel* unit_;
};

}  // namespace tedit::desktop
