// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

/// Figures for people who read and paste them elsewhere: with the decimal point of their locale.
namespace tedit::desktop {

/// A number and its unit apart, as cells of a table hold them.
struct shown_quantity {
  QString number;  ///< "13,4" or "13.4".
  QString unit;    ///< "MPa"; empty for numbers without one.

  [[nodiscard]] QString text() const { return unit.isEmpty() ? number : number + " " + unit; }
  friend bool operator==(const shown_quantity&, const shown_quantity&) = default;
};

/// A value in SI units ("m", "Pa", "N", "kg", "m3", "ratio", or none) with the digits of `number`
/// and a unit by its size: 1.2e-7 m is "120 nm", 4e4 Pa is "40 kPa", 3e5 N is "300 kN".
[[nodiscard]] shown_quantity shown(double value, const QString& si_unit);

/// Words with numbers that were written with a point, with the locale's decimal point instead;
/// lists of such numbers are parted by semicolons where that point is a comma.
[[nodiscard]] QString in_locale(QString words);

}  // namespace tedit::desktop
