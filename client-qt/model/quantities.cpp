// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/quantities.hpp"
#include "client-qt/model/server_words.hpp"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tedit::desktop {

namespace {

/// With the decimal point of the person's language; groups of digits are not parted, so that what
/// is shown can be typed.
QString digits(double value, char format, int precision) {
  static const QRegularExpression filling("(?<=e[-+])0(?=[0-9])");  // "e-07" is a program's way.
  return QString::number(value, format, precision)
    .remove(filling)
    .replace('.', QLocale().decimalPoint());
}

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
display_unit by_size(const step (&steps)[N], double in_si) {
  for (const auto& one : steps)
    if (std::abs(in_si) >= one.from)
      return {QString::fromUtf8(one.unit), one.scale};
  return {QString::fromUtf8(steps[N - 1].unit), steps[N - 1].scale};  // Of what is not a number.
}

display_unit unit_for(double in_si, const QString& si_unit) {
  if (in_si == 0)
    return shown_as(si_unit);
  if (si_unit == "m")
    return by_size(lengths, in_si);
  if (si_unit == "Pa")
    return by_size(stresses, in_si);
  if (si_unit == "N")
    return by_size(forces, in_si);
  if (si_unit == "kg")
    return by_size(masses, in_si);
  if (si_unit == "m3")
    return by_size(volumes, in_si);
  return shown_as(si_unit);
}

}  // namespace

display_unit shown_as(const QString& si_unit) {
  if (si_unit == "m")
    return {"mm", 1e3};
  if (si_unit == "m2")
    return {QString::fromUtf8("mm²"), 1e6};
  if (si_unit == "m3")
    return {QString::fromUtf8("mm³"), 1e9};
  if (si_unit == "Pa")
    return {"MPa", 1e-6};
  if (si_unit == "Pa/m")
    return {"MPa/m", 1e-6};
  if (si_unit == "m/s2")
    return {QString::fromUtf8("m/s²"), 1};
  if (si_unit == "kg/m3")
    return {QString::fromUtf8("kg/m³"), 1};
  if (si_unit == "rad")
    return {QString::fromUtf8("°"), 180 / std::numbers::pi};
  if (si_unit == "m/m")
    return {QString::fromUtf8("µm/m"), 1e6};
  if (si_unit == "ratio")
    return {"%", 100};
  if (si_unit == "kg")
    return {"g", 1e3};
  return {si_unit, 1};
}

QString number(double value) {
  if (!std::isfinite(value))
    return QCoreApplication::translate("quantities", "none");
  const double size = std::abs(value);
  if (size != 0 && (size < 1e-3 || size >= 1e6))
    return digits(value, 'g', 3);
  return digits(value, 'g', size >= 1000 ? 6 : 4);
}

QString number_in(double value, double range) {
  constexpr int most_decimals = 6;
  if (std::abs(value) < 5e-4 * range)
    return "0";
  if (!std::isfinite(value) || !(range >= 1e-3 && range < 1e6))
    return number(value);
  const int decimals =
    std::clamp(2 - static_cast<int>(std::floor(std::log10(range))), 0, most_decimals);
  QString text = digits(value, 'f', decimals);
  if (decimals == 0)
    return text;
  while (text.endsWith('0'))
    text.chop(1);
  return text.back().isDigit() ? text : text.chopped(1);
}

QString exact(double value) {
  return digits(value, 'g', 10);
}

QString two_digits(double value) {
  return digits(value, 'g', 2);
}

QString side_by_side(const QStringList& numbers) {
  return numbers.join(QLocale().decimalPoint() == "," ? "; " : ", ");
}

QString quantity(double in_si, const QString& si_unit) {
  const auto unit = si_unit == "m3" ? by_size(volumes, in_si) : shown_as(si_unit);
  QString text = number(in_si * unit.scale);
  if (unit.name.isEmpty())
    return text;
  return unit.name == QString::fromUtf8("°") ? text + unit.name : text + " " + unit.name;
}

shown_quantity shown(double in_si, const QString& si_unit) {
  const auto unit = unit_for(in_si, si_unit);
  return {number(in_si * unit.scale), unit.name};
}

QString length(double metres) {
  return shown(metres, "m").text();
}

QString mass(double kg) {
  return shown(kg, "kg").text();
}

QString duration(double ms) {
  if (ms < 1000)
    return digits(ms, 'f', ms < 10 ? 1 : 0) + " ms";
  if (ms < 60'000)
    return digits(ms / 1000, 'f', 1) + " s";
  const auto seconds = static_cast<long long>(ms / 1000);
  return QString("%1 min %2 s").arg(seconds / 60).arg(seconds % 60);
}

QString count(double items) {
  if (items >= 1e6)
    return digits(items / 1e6, 'f', 2) + " M";
  if (items >= 1e4)
    return digits(items / 1e3, 'f', items < 1e5 ? 1 : 0) + " k";
  return digits(items, 'f', 0);
}

QString change(double before, double after) {
  if (before == 0 || !std::isfinite(before) || !std::isfinite(after))
    return {};
  const double percent = 100 * (after - before) / std::abs(before);
  const double size = std::abs(percent);
  if (size < 0.005)
    return digits(0, 'f', 1) + " %";
  const QString text = digits(size, 'f', size < 0.05 ? 2 : size < 10 ? 1 : 0) + " %";
  return (percent < 0 ? QString::fromUtf8("−") : QString("+")) + text;
}

QString change_by(double in_si, const QString& si_unit) {
  const QString sign = in_si < 0 ? QString::fromUtf8("−") : in_si > 0 ? QString("+") : QString();
  return sign + quantity(std::abs(in_si), si_unit);
}

QString words_of(const std::string& said) {
  static const QRegularExpression power(R"(\b([mck]?m)([23])\b)");
  QString text = in_window_language(said);
  for (auto found = power.match(text); found.hasMatch(); found = power.match(text))
    text.replace(found.capturedStart(2), 1, QChar(found.captured(2) == "2" ? 0x00b2 : 0x00b3));
  // Not in versions, addresses and names of files.
  static const QRegularExpression point(
    R"((?<![\w.])(?<!ersion )(\d+)\.(?=\d+(e[-+]?\d+)?([\s,;:)%]|\.?\s|\.?$)))");
  text.replace(point, "\\1" + QLocale().decimalPoint());
  return text;
}

QString sentence_of(const std::string& said) {
  QString result = words_of(said);
  if (!result.isEmpty())
    result[0] = result[0].toUpper();
  if (!result.isEmpty() && !result.endsWith('.'))
    result += '.';
  return result;
}

}  // namespace tedit::desktop
