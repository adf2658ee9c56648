// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <string>

namespace tedit::desktop {

/// How a number in SI units is shown and typed: engineers think in mm, MPa and N. All words below
/// have the decimal point of QLocale's default.
struct display_unit {
  QString name;      ///< "mm"; empty for numbers without one.
  double scale = 1;  ///< Shown = SI times scale.
};

/// The unit to show for an SI unit: "m" as "mm", "Pa" as "MPa", "rad" as degrees, "m2" as "mm²",
/// "m3" as "mm³", "kg" as "g", "Pa/m" as "MPa/m", strains ("m/m") as "µm/m"; others as they are.
[[nodiscard]] display_unit shown_as(const QString& si_unit);

/// A value with four digits at most and a unit: "12.5 mm", "1.2e-05 mm".
[[nodiscard]] QString number(double value);
/// The same on a scale over `range`: to about a thousandth of it, without zeros at the end. What is
/// less than half of that is "0".
[[nodiscard]] QString number_in(double value, double range);
/// All digits that matter, so that showing and reading again changes nothing.
[[nodiscard]] QString exact(double value);
/// Two digits, for what is known no better: "0.13", "6.9e-07".
[[nodiscard]] QString two_digits(double value);
/// Numbers side by side: "0.5, -1.25"; where a comma is the decimal point "0,5; -1,25".
[[nodiscard]] QString side_by_side(const QStringList& numbers);
[[nodiscard]] QString quantity(double in_si, const QString& si_unit);

/// A number and its unit apart, as cells of a table hold them.
struct shown_quantity {
  QString number;  ///< "13.4".
  QString unit;    ///< "MPa"; empty for numbers without one.

  [[nodiscard]] QString text() const { return unit.isEmpty() ? number : number + " " + unit; }
  friend bool operator==(const shown_quantity&, const shown_quantity&) = default;
};

/// A value in SI units ("m", "Pa", "N", "kg", "m3", "ratio", or none) with the digits of `number`
/// and a unit by its size: 1.2e-7 m is "120 nm", 4e4 Pa is "40 kPa", 3e5 N is "300 kN". Zero has
/// the usual unit.
[[nodiscard]] shown_quantity shown(double in_si, const QString& si_unit);
/// A length by its size: "0.35 µm", "12.5 mm", "1.2 m".
[[nodiscard]] QString length(double metres);
/// A mass by its size: "120 g", "39.7 kg".
[[nodiscard]] QString mass(double kg);
/// "87 ms", "1.3 s", "4 min 10 s".
[[nodiscard]] QString duration(double ms);
/// "12", "12 400", "1.02 M".
[[nodiscard]] QString count(double items);
/// A change in percent with its sign: "+3.2 %", "−0.02 %"; "0.0 %" below 0.005 %; nothing when
/// `before` is zero.
[[nodiscard]] QString change(double before, double after);

/// A change with its sign, so that nobody takes it for the whole: "+21992.1 mm³", "−3800 cm³".
[[nodiscard]] QString change_by(double in_si, const QString& si_unit);

/// What the server says, which writes English and no letters beyond ASCII, as the window writes it:
/// in its language (`in_window_language`), "3 mm²" for "3 mm2", numbers with its decimal point.
[[nodiscard]] QString words_of(const std::string& said);
/// The same as a sentence: with a capital and a full stop.
[[nodiscard]] QString sentence_of(const std::string& said);

}  // namespace tedit::desktop
