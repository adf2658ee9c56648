// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/quantities.hpp"

#include <QCoreApplication>
#include <QRegularExpression>

#include <cmath>
#include <numbers>

namespace tedit::desktop {

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
    return QString::number(value, 'g', 3);
  return QString::number(value, 'g', size >= 1000 ? 6 : 4);
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
    return QString::number(ms, 'f', ms < 10 ? 1 : 0) + " ms";
  if (ms < 60'000)
    return QString::number(ms / 1000, 'f', 1) + " s";
  const auto seconds = static_cast<long long>(ms / 1000);
  return QString("%1 min %2 s").arg(seconds / 60).arg(seconds % 60);
}

QString count(double items) {
  if (items >= 1e6)
    return QString::number(items / 1e6, 'f', 2) + " M";
  if (items >= 1e4)
    return QString::number(items / 1e3, 'f', items < 1e5 ? 1 : 0) + " k";
  return QString::number(items, 'f', 0);
}

QString change(double before, double after) {
  if (before == 0 || !std::isfinite(before) || !std::isfinite(after))
    return {};
  const double percent = 100 * (after - before) / std::abs(before);
  const QString text =
    QString::number(std::abs(percent), 'f', std::abs(percent) < 10 ? 1 : 0) + " %";
  return (percent < 0 ? QString::fromUtf8("−") : QString("+")) + text;
}

QString words_of(const std::string& said) {
  static const QRegularExpression power(R"(\b([mck]?m)([23])\b)");
  QString text = QString::fromStdString(said);
  for (auto found = power.match(text); found.hasMatch(); found = power.match(text))
    text.replace(found.capturedStart(2), 1, QChar(found.captured(2) == "2" ? 0x00b2 : 0x00b3));
  return text;
}

}  // namespace tedit::desktop
