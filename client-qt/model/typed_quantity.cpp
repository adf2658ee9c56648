// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/typed_quantity.hpp"

#include <QRegularExpression>
#include <QStringList>

#include <cmath>
#include <numbers>
#include <vector>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

struct unit {
  const char* name;  ///< As `plain` writes it.
  double si;         ///< One of it in SI units.
  bool offered = true;
};

constexpr double inch = 0.0254;
constexpr double pound_force = 4.4482216152605;
constexpr double standard_gravity = 9.80665;
constexpr double psi = pound_force / (inch * inch);

/// Which units a quantity is typed in. Spellings that say the same as one before are not offered.
const std::vector<unit>& units_of(const QString& si_unit) {
  static const std::vector<std::pair<QString, std::vector<unit>>> all{
    {"m",
     {{"nm", 1e-9, false},
      {"um", 1e-6},
      {"mm", 1e-3},
      {"cm", 1e-2},
      {"m", 1},
      {"in", inch},
      {"\"", inch, false},
      {"ft", 12 * inch}}},
    {"N", {{"N", 1}, {"kN", 1e3}, {"MN", 1e6}, {"kgf", standard_gravity}, {"lbf", pound_force}}},
    {"Pa",
     {{"Pa", 1},
      {"kPa", 1e3},
      {"MPa", 1e6},
      {"N/mm2", 1e6, false},
      {"GPa", 1e9},
      {"bar", 1e5},
      {"psi", psi},
      {"ksi", 1e3 * psi}}},
    {"Pa/m", {{"Pa/m", 1}, {"kPa/m", 1e3}, {"MPa/m", 1e6}, {"bar/m", 1e5}}},
    {"N m",
     {{"Nm", 1},
      {"Nmm", 1e-3},
      {"Ncm", 1e-2, false},
      {"kNm", 1e3},
      {"lbfin", pound_force * inch, false},
      {"lbfft", 12 * pound_force * inch, false}}},
    {"m/s2", {{"m/s2", 1}, {"g", standard_gravity}}},
    {"kg/m3", {{"kg/m3", 1}, {"g/cm3", 1e3}}},
    {"rad",
     {{"deg", std::numbers::pi / 180, false}, {"\u00b0", std::numbers::pi / 180}, {"rad", 1}}},
    {"ratio", {{"%", 1e-2}}},
    {"kg", {{"g", 1e-3}, {"kg", 1}}},
    {"m2", {{"mm2", 1e-6}, {"cm2", 1e-4}, {"m2", 1}}},
    {"m3", {{"mm3", 1e-9}, {"cm3", 1e-6}, {"m3", 1}}},
  };
  static const std::vector<unit> none;
  for (const auto& [name, units] : all)
    if (name == si_unit)
      return units;
  return none;
}

/// The spelling of the table: "N·m", "N m" as "Nm", "mm²" as "mm2", "µm" as "um".
QString plain_name(QString name) {
  static const QRegularExpression between(QString::fromUtf8("[\\s·*]"));
  name.remove(between);
  name.replace(QString::fromUtf8("²"), "2").replace(QString::fromUtf8("³"), "3");
  return name.replace(QChar(0x00b5), 'u').replace(QChar(0x03bc), 'u');
}

/// The spelling for people.
QString written(const QString& name) {
  QString text = name;
  if (text == "um")
    return QString::fromUtf8("µm");
  static const QRegularExpression moment("^(k?N)(m+)$");
  text.replace(moment, "\\1 \\2");
  return text.replace('2', QString::fromUtf8("²")).replace('3', QString::fromUtf8("³"));
}

struct typed_number {
  double value;
  QString unit;
};

std::optional<typed_number> split(QString text) {
  text.replace(QString::fromUtf8("−"), "-").replace(',', '.');
  static const QRegularExpression form(
    R"(^\s*([-+]?)\s*(?:(?:(\d+)\s+)?(\d+)\s*/\s*(\d+)|((?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?))\s*(.*?)\s*$)");
  const auto found = form.match(text);
  if (!found.hasMatch())
    return std::nullopt;
  double value = found.captured(5).toDouble();
  if (found.captured(5).isEmpty())
    value =
      found.captured(2).toDouble() + found.captured(3).toDouble() / found.captured(4).toDouble();
  if (!std::isfinite(value))
    return std::nullopt;
  return typed_number{found.captured(1) == "-" ? -value : value, found.captured(6)};
}

}  // namespace

std::optional<double> read_number(const QString& text) {
  const auto typed = split(text);
  return typed && typed->unit.isEmpty() ? std::optional(typed->value) : std::nullopt;
}

std::optional<double> read_quantity(const QString& text, const QString& si_unit) {
  const auto typed = split(text);
  if (!typed)
    return std::nullopt;
  const auto name = plain_name(typed->unit.isEmpty() ? shown_as(si_unit).name : typed->unit);
  if (name.isEmpty())
    return typed->value;
  for (const auto& one : units_of(si_unit))
    if (name == QString::fromUtf8(one.name))
      return typed->value * one.si;
  return typed->unit.isEmpty() ? std::optional(typed->value) : std::nullopt;
}

QString other_units(const QString& si_unit) {
  QStringList names;
  const auto shown = plain_name(shown_as(si_unit).name);
  for (const auto& one : units_of(si_unit))
    if (const auto name = QString::fromUtf8(one.name); one.offered && name != shown)
      names << written(name);
  return names.join(", ");
}

}  // namespace tedit::desktop
