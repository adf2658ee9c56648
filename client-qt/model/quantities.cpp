// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/quantities.hpp"

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
  return QString::number(value, format, precision).replace('.', QLocale().decimalPoint());
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
  if (si_unit == "rad")
    return {QString::fromUtf8("°"), 180 / std::numbers::pi};
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

QString quantity(double si_value, const QString& si_unit) {
  auto unit = shown_as(si_unit);
  constexpr double large_volume = 1e-3;  // m3; in mm3 it would be written with an exponent.
  if (si_unit == "m3" && std::abs(si_value) >= large_volume)
    unit = {QString::fromUtf8("cm³"), 1e6};
  const QString text = number(si_value * unit.scale);
  if (unit.name.isEmpty())
    return text;
  return unit.name == QString::fromUtf8("°") ? text + unit.name : text + " " + unit.name;
}

QString length(double metres) {
  const double size = std::abs(metres);
  if (size >= 1)
    return number(metres) + " m";
  if (size < 1e-6 && size > 0)
    return number(metres * 1e9) + " nm";
  if (size < 1e-4 && size > 0)
    return number(metres * 1e6) + QString::fromUtf8(" µm");
  return number(metres * 1e3) + " mm";
}

QString mass(double kg) {
  return kg < 1 ? quantity(kg, "kg") : number(kg) + " kg";
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
  const QString text = digits(std::abs(percent), 'f', std::abs(percent) < 10 ? 1 : 0) + " %";
  return (percent < 0 ? QString::fromUtf8("−") : QString("+")) + text;
}

QString words_of(const std::string& said) {
  static const QRegularExpression power(R"(\b([mck]?m)([23])\b)");
  QString text = QString::fromStdString(said);
  for (auto found = power.match(text); found.hasMatch(); found = power.match(text))
    text.replace(found.capturedStart(2), 1, QChar(found.captured(2) == "2" ? 0x00b2 : 0x00b3));
  // Not in versions, addresses and names of files.
  static const QRegularExpression point(
    R"((?<![\w.])(\d+)\.(?=\d+(e[-+]?\d+)?([\s,;:)%]|\.?\s|\.?$)))");
  text.replace(point, "\\1" + QLocale().decimalPoint());
  return text;
}

}  // namespace tedit::desktop
