// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/local_numbers.hpp"

#include <QLocale>
#include <QRegularExpression>

#include <cmath>
#include <iterator>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

/// From `from` on in SI, the unit and what an SI value is multiplied by.
struct step {
  double from;
  const char* unit;
  double scale;
};

constexpr step lengths[] = {{1, "m", 1}, {1e-4, "mm", 1e3}, {1e-6, "µm", 1e6}, {0, "nm", 1e9}};
constexpr step stresses[] = {{1e5, "MPa", 1e-6}, {1e2, "kPa", 1e-3}, {0, "Pa", 1}};
constexpr step forces[] = {{1e5, "kN", 1e-3}, {0.1, "N", 1}, {0, "mN", 1e3}};
constexpr step masses[] = {{1, "kg", 1}, {0, "g", 1e3}};
constexpr step volumes[] = {{1e-3, "cm³", 1e6}, {0, "mm³", 1e9}};

template <std::size_t N>
display_unit by_size(const step (&steps)[N], double si_value) {
  for (const auto& one : steps)
    if (std::abs(si_value) >= one.from)
      return {QString::fromUtf8(one.unit), one.scale};
  return {QString::fromUtf8(steps[N - 1].unit), steps[N - 1].scale};  // Of what is not a number.
}

display_unit unit_for(double si_value, const QString& si_unit) {
  if (si_unit == "m")
    return by_size(lengths, si_value);
  if (si_unit == "Pa")
    return by_size(stresses, si_value);
  if (si_unit == "N")
    return by_size(forces, si_value);
  if (si_unit == "kg")
    return by_size(masses, si_value);
  if (si_unit == "m3")
    return by_size(volumes, si_value);
  return shown_as(si_unit);
}

}  // namespace

shown_quantity shown(double si_value, const QString& si_unit) {
  const auto unit = unit_for(si_value, si_unit);
  return {in_locale(number(si_value * unit.scale)), unit.name};
}

QString in_locale(QString words) {
  const QString point = QLocale().decimalPoint();
  if (point == ".")
    return words;
  static const QRegularExpression between(R"((?<=\d), (?=[\d\-−]))",
                                          QRegularExpression::UseUnicodePropertiesOption);
  static const QRegularExpression decimal(R"((?<=\d)\.(?=\d))");
  return words.replace(between, "; ").replace(decimal, point);
}

}  // namespace tedit::desktop
